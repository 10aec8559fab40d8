#pragma once
/// Decides which charts a study shows and what they say in words.
#include <string>
#include <vector>

#include "chart.hpp"
#include "perinox/study/study.hpp"
#include "run_table.hpp"

namespace perinox::study {

struct Plot {
  std::string file;  ///< name without folder and ending
  Chart chart;
  std::string meaning;                ///< one sentence that says how to read it
  std::vector<std::string> findings;  ///< slopes, Pareto front, orders
};

/// The plots that the study asks for, or the usual ones. Those that would hold no point are left out.
std::vector<Plot> plots_of(const Study& study, const std::vector<Row>& rows);

}  // namespace perinox::study
