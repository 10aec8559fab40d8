#pragma once
#include <string>
#include <vector>

#include "perinox/mechanics/state.hpp"

namespace perinox::mechanics {

/// Force states t = omega (radial xi + shear e + xi N . H) of a committed state of a scene without plastic flow:
/// radial, shear, H. [owned * (2 + mandel_size)]. Collective.
void force_states(const Scene& scene, const Committed& state, double* points);

/// Internal force on every particle, f_i = V_i sum_j (T_i<xi> - T_j<-xi>) V_j (Eq. 16 times V_i; force), with return
/// mapping from the committed state. Minus the gradient of the stored energy where nothing flows.
/// displacement: [owned * dimension]; force: [owned * dimension], overwritten. Fills `trial` with everything the state
/// needs to be committed. Collective.
void internal_force(const Scene& scene, const Committed& committed, const double* displacement, Trial& trial,
                    double* force);

/// The same for time steps: the state is in trial.displacement [local * dimension] already, and no evaluation made
/// before is looked for. Nothing is allocated after the first call with one trial, and messages travel while bonds
/// without ghosts are worked on. Collective.
void internal_force_in_motion(const Scene& scene, const Committed& committed, Trial& trial, double* force);

/// force_states of the displacement that the last internal_force or internal_force_in_motion was asked for, which has
/// found them already. Only of scenes from_sums(). Not collective.
void force_states_in_motion(const Scene& scene, double* points);

/// Names the first owned particle whose force is not finite: a sentence with its id, position and, where a bond has
/// collapsed to length zero, the neighbour; "" if all are finite. Not collective.
std::string first_not_finite(const Scene& scene, const Trial& trial, const double* force);

}  // namespace perinox::mechanics
