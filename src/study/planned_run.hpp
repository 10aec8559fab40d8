#pragma once
#include <string>
#include <vector>

#include "formula.hpp"
#include "perinox/study/study.hpp"

namespace perinox::study {

/// A run for one combination of the sweeps' values.
struct PlannedRun {
  std::string name;                    ///< name of its folder: "quadrature-whole_spacing-0.5"
  std::vector<std::size_t> point;      ///< number of the value of each sweep
  std::vector<std::string> label;      ///< label of each sweep
  Numbers numbers;                     ///< the labels that are numbers, by the sweep's name
  std::vector<std::string> overrides;  ///< key=value; the study's own come first
  int ranks = 1;
};

/// Plans a run for every combination; the last sweep changes fastest. Throws InputError for a bad number of ranks, an
/// unknown {name}, and two sweeps that set the same key.
std::vector<PlannedRun> planned_runs(const Study& study);

/// Number of the first sweep with two or more values that are all numbers. It is the number of sweeps if there is none.
std::size_t first_numeric(const Study& study);

}  // namespace perinox::study
