#pragma once
#include <string>
#include <vector>

#include "plotting.hpp"
#include "run_table.hpp"

namespace perinox::study {

/// Table and findings for the terminal.
std::string terminal_report(const Study& study, const std::vector<Row>& rows, const std::vector<Plot>& plots);
/// Text of study.md: the table, the plots with what they mean, and where the runs are.
std::string page(const Study& study, const std::vector<Row>& rows, const std::vector<Plot>& plots);

}  // namespace perinox::study
