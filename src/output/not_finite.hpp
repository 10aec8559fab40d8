#pragma once
/// Private to the room output. No state that a run leaves holds infinity or NaN, and no run goes on from such a number.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "agree.hpp"

namespace perinox::output {

/// Refuses values that are not finite. values: this rank's share. Collective. Throws RunError on every rank.
inline void refuse_not_finite(const Communicator& communicator, const std::vector<double>& values,
                              const std::string& path, const std::string& name) {
  const bool finite = std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
  agree_on_run_error(communicator,
                     finite ? std::string() : path + " holds in " + name + " a number that is not finite");
}

}  // namespace perinox::output
