#include "perinox/medium/displacement.hpp"

#include <atomic>

namespace perinox::medium {

std::uint64_t new_version() {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

}  // namespace perinox::medium
