#pragma once
#include "perinox/core/record.hpp"
#include "perinox/deck/deck.hpp"

namespace perinox::equilibrium {

/// True where the residual of `last` is small against the reactions and what another update would change is small
/// against the step, or where nothing but rounding (a residual of `floor`, force) is left. `before`: residual of the
/// iterate before, force; unused in iteration 0.
bool converged(const deck::Newton& settings, const NewtonIteration& last, double before, double floor);

/// Tolerance of the linear solve that follows `last`: Eisenstat and Walker's choice 2, or the deck's constant.
double next_forcing(const deck::Solver& settings, const NewtonIteration& last, double before);

}  // namespace perinox::equilibrium
