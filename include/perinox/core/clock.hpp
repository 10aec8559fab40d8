#pragma once
#include <chrono>

namespace perinox {

/// Seconds of a clock that never goes back. Only differences of two readings have a meaning.
inline double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace perinox
