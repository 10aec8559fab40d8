#pragma once
/// Makes study.csv and the same table for the terminal, with one row for each run.
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
  Values values;                  ///< values of measures and cost_columns(); what is not known is not there
  std::vector<double> residuals;  ///< for kind newton: relative residual of each iteration of the step

  /// The value of a column or of a numeric sweep. It is not-a-number if it is not known.
  double value(const std::string& column) const;
};

/// Columns of measures, then cost_columns() without those that are sweeps.
std::vector<std::string> value_columns(const Study& study);

/// The table as CSV: run, the sweeps, status, reason, value_columns(). Numbers have 17 digits.
std::string csv_text(const Study& study, const std::vector<Row>& rows);

/// The table in short, as text. It has one cell for each sweep and value; the first line holds the names.
std::vector<std::vector<std::string>> short_table(const Study& study, const std::vector<Row>& rows);

/// A number with four digits.
std::string short_number(double value);

}  // namespace perinox::study
