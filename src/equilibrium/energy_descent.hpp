#pragma once
#include <vector>

#include "equilibrium_model.hpp"

namespace perinox::equilibrium {

/// Goes down in energy from a point without a stable equilibrium nearby to the next stable one: what an overdamped body
/// would do. Newton's steps with a shift of the tangent, K + mu diag(k), k its scale of stiffness, mu as small as
/// conjugate gradients allow (Levenberg and Marquardt's trust region in the norm of the displacement); a step is taken
/// if it lowers stored + dissipated energy - work of the dead loads, and, once rounding hides that, the residual.
/// Needs a symmetric tangent that is not a matrix.
class EnergyDescent {
 public:
  /// Everything is kept by reference.
  EnergyDescent(const deck::Solver& solver, EquilibriumModel& model, const linear::LinearSolver& linear)
      : solver_(solver), model_(model), linear_(linear) {}

  /// From displacement x [owned * dimension], prescribed values imposed, on the step that the model has been given;
  /// external: of that step. Converged: x is a stable equilibrium and the model was evaluated there last. A body that
  /// moves farther than it is large is said to run away: under a load beyond what it carries the energy has no minimum.
  /// Collective.
  NewtonResult run(const std::vector<double>& external, int step, Observer& observer, std::vector<double>& x);

 private:
  /// Stored + dissipated energy of the step - external force . displacement at the last evaluation, over all ranks.
  double potential(const std::vector<double>& external) const;
  /// Solves for Newton's direction with the least shift that conjugate gradients allow, from `shift` on.
  linear::LinearOutcome find_direction(double& shift, std::vector<double>& change);
  /// Moves `here` along the change by all of it, or the half, quarter, ... that lowers the energy, and evaluates there.
  /// Returns the share, one below `shortest` where none does. balance, energy: of `here`, brought up to date.
  double step_along(const std::vector<double>& external, const std::vector<double>& change, medium::Displacement& here,
                    ForceBalance& balance, double& energy);

  const deck::Solver& solver_;
  EquilibriumModel& model_;
  const linear::LinearSolver& linear_;
};

}  // namespace perinox::equilibrium
