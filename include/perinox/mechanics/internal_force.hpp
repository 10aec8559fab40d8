#pragma once
#include <string>
#include <vector>

#include "perinox/mechanics/evaluation.hpp"

namespace perinox::mechanics {

/// Internal force on every particle, f_i = V_i sum_j (T_i<xi> - T_j<-xi>) V_j (Eq. 16 times V_i; force), with return
/// mapping from the committed state. It is minus the gradient of the stored energy where nothing flows.
/// at: [owned * dimension]; force: [owned * dimension], overwritten. Fills `trial` with everything that the state needs
/// to be committed. Collective.
void internal_force(Evaluation& evaluation, const Committed& committed, const medium::At& at, Trial& trial,
                    double* force);

/// The internal force for time steps. The displacement is in trial.displacement [local * dimension] already, and counts
/// as a new state. Nothing is allocated after the first call with one trial, and messages travel while bonds without
/// ghosts are worked on. Collective.
void internal_force_in_motion(Evaluation& evaluation, const Committed& committed, Trial& trial, double* force);

/// Force states t = omega (radial xi + shear e + xi N . H) of a committed state of a scene without plastic flow:
/// radial, shear, H. points: [owned * (2 + mandel_size)]. Collective.
void force_states(Evaluation& evaluation, const Committed& state, double* points);
/// The same of the answers that the evaluation holds: those of the last internal force. Only for scenes from_sums().
/// Not collective.
void held_force_states(const Evaluation& evaluation, double* points);

/// Names the first owned particle whose force is not finite: a sentence with its id, position and, where a bond has
/// collapsed to length zero, the neighbour; "" if all are finite. Not collective.
std::string first_not_finite(const Scene& scene, const Trial& trial, const double* force);

}  // namespace perinox::mechanics
