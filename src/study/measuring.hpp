#pragma once
#include <map>
#include <string>

#include "formula.hpp"
#include "perinox/deck/deck.hpp"
#include "perinox/study/study.hpp"
#include "planned_run.hpp"

namespace perinox::study {

/// Columns of study.csv and their values. What could not be measured is not there.
using Values = std::map<std::string, double>;

/// Checks the measures' formulas and names against a run and its deck, before anything is run. Throws InputError.
void check_measures(const Study& study, const PlannedRun& run, const deck::Deck& deck);

/// Particles, unknowns, steps, iterations and the wall seconds of the steps of the run in `folder`.
Values counts_of(const std::string& folder);

/// The columns of one measure of the run in `folder`. A history measure has the value and the relative error (value -
/// exact)/|exact|, or the difference where exact is 0. A field measure has the root mean square error over that of the
/// exact field, weighted by volume, and the largest error over the largest exact value; both are absolute where the
/// exact field is 0. `reference`: the results.h5 of a measure that has a reference. Throws RunError if a file cannot be
/// read or has no such step.
Values measured(const Measure& measure, const PlannedRun& run, const std::string& folder, const std::string& reference);

}  // namespace perinox::study
