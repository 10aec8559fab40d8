#pragma once
#include <vector>

#include "equilibrium_model.hpp"
#include "perinox/linear/linear_solve.hpp"

namespace perinox::equilibrium {

/// Goes down in energy from a point without a stable equilibrium nearby to the next stable one: what an overdamped body
/// would do. Newton's steps with a shift of the tangent, K + mu diag(k), k its scale of stiffness, mu as small as
/// conjugate gradients allow (Levenberg and Marquardt's trust region in the norm of the displacement); a step is taken
/// if it lowers stored + dissipated energy - work of the dead loads, and, once rounding hides that, the residual.
/// Needs a symmetric tangent that is not a matrix.
class EnergyDescent {
 public:
  /// reach: displacement (of all particles, root of the sum of squares) beyond which the body is said to run away:
  /// under a load beyond what it carries the energy has no minimum.
  EnergyDescent(const deck::Solver& solver, const loads::Boundary& boundary, linear::TangentSystem& system,
                EquilibriumModel& model, const linear::LinearSolverFactory& factory, double reach)
      : solver_(solver), boundary_(boundary), system_(system), model_(model), factory_(factory), reach_(reach) {}

  /// From displacement x [owned * dimension], prescribed values imposed, on the step that the model has been given;
  /// external: of that step. Converged: x is a stable equilibrium and the model was evaluated there last. Collective.
  NewtonResult run(const mechanics::Committed& committed, const std::vector<double>& external, double t, int step,
                   Observer& observer, std::vector<double>& x);

 private:
  /// Stored + dissipated energy of the step - external force . displacement at the last evaluation, over all ranks.
  double potential(const std::vector<double>& external) const;

  const deck::Solver& solver_;
  const loads::Boundary& boundary_;
  linear::TangentSystem& system_;
  EquilibriumModel& model_;
  const linear::LinearSolverFactory& factory_;
  double reach_;
};

}  // namespace perinox::equilibrium
