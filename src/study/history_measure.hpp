#pragma once
/// Private to the room study: measures of history.csv.
#include <string>

#include "measuring.hpp"

namespace perinox::study {

/// True if two values of t belong to the same step.
bool same_time(double a, double b);

/// Checks a history measure's formulas against the columns that the runs write. Throws InputError.
void check_history_measure(const Measure& measure, const PlannedRun& run, const deck::Deck& deck);

/// The columns of a history measure of the run in `folder`. Throws RunError if there is no such row or a value is not
/// finite.
Values history_value(const Measure& measure, const PlannedRun& run, const std::string& folder);

}  // namespace perinox::study
