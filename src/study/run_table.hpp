#pragma once
/// study.csv and the same on the terminal: a row a run.
#include <string>
#include <vector>

#include "measuring.hpp"
#include "perinox/study/study.hpp"
#include "planned_run.hpp"

namespace perinox::study {

struct Row {
  PlannedRun run;
  int status = 0;
  std::string reason;             ///< why the run stopped short or what could not be measured; empty if all is there
  Values values;                  ///< of measures and cost_columns(); what is not known is not there
  std::vector<double> residuals;  ///< of kind newton: relative residual of each iteration of the step

  /// The value of a column or of a numeric sweep; not-a-number if it is not known.
  double value(const std::string& column) const;
};

/// Columns of measures, then cost_columns() without those that are sweeps.
std::vector<std::string> value_columns(const Study& study);

/// CSV: run, the sweeps, status, reason, value_columns(). 17 digits.
std::string csv_text(const Study& study, const std::vector<Row>& rows);

/// The table in short: a cell a sweep and a value, as text; the first line holds the names.
std::vector<std::vector<std::string>> short_table(const Study& study, const std::vector<Row>& rows);

/// Numbers with four digits.
std::string short_number(double value);

}  // namespace perinox::study
