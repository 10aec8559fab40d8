#pragma once
#include <vector>

#include "perinox/mechanics/state.hpp"

namespace perinox::mechanics {

/// Internal force by the loops over stored bonds, for materials without point formulas of sums: what the families of
/// this rank exert on owned particles and ghosts, force [local * dimension]. trial.displacement is up to date; the rest
/// of the trial is filled.
void stored_force(const Scene& scene, const Committed& committed, Trial& trial, std::vector<double>& force);

}  // namespace perinox::mechanics
