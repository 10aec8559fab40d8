#pragma once
#include <string>
#include <vector>

#include "formula.hpp"
#include "perinox/study/study.hpp"

namespace perinox::study {

/// One combination of the sweeps' values.
struct PlannedRun {
  std::string name;                    ///< "quadrature-whole_spacing-0.5": its folder
  std::vector<std::size_t> point;      ///< number of the value of each sweep
  std::vector<std::string> label;      ///< of each sweep
  Numbers numbers;                     ///< the labels that are numbers, by the sweep's name
  std::vector<std::string> overrides;  ///< key=value, the study's own first
  int ranks = 1;
};

/// Every combination, the last sweep fastest. Throws InputError for a bad number of ranks, an unknown {name}, and two
/// sweeps that set the same key.
std::vector<PlannedRun> planned_runs(const Study& study);

/// Number of the first sweep with two or more values that are all numbers; the number of sweeps if there is none.
std::size_t first_numeric(const Study& study);

}  // namespace perinox::study
