#pragma once
/// Private to the study room: measures of history.csv.
#include <string>

#include "measuring.hpp"

namespace perinox::study {

/// True if two values of t are the same step's.
bool same_time(double a, double b);

/// Checks a history measure's formulas against the columns that the runs write. Throws InputError.
void check_history_measure(const Measure& measure, const PlannedRun& run, const deck::Deck& deck);

/// Columns of a history measure of the run in `folder`. Throws RunError: no such row, or a value that is not finite.
Values history_value(const Measure& measure, const PlannedRun& run, const std::string& folder);

}  // namespace perinox::study
