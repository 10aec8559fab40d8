#pragma once
#include <memory>
#include <string>
#include <vector>

#include "perinox/deck/deck.hpp"
#include "perinox/equilibrium/newton.hpp"
#include "perinox/equilibrium/path_constraint.hpp"

namespace perinox::equilibrium {

/// Newton-Raphson on the force balance and one more equation, for the displacements and the load parameter t together.
/// Every iteration solves with the same tangent K for the residual r and for the rate of the loads q,
///   K a = r,  K b = q,  dt = -(g + g'.a) / (g'.b + g_t),  du = a + dt b;
/// K alone may be singular or indefinite (past a limit point), the two equations together are not. Conjugate gradients
/// as long as they meet no negative curvature, GMRES from there until the loads and their displacements go the same way
/// again. Collective throughout.
class BorderedNewton {
 public:
  /// system: shared with the other solver of the medium; everything is kept by reference.
  BorderedNewton(const deck::Deck& deck, medium::Medium& medium, const loads::Boundary& boundary,
                 linear::TangentSystem& system);
  ~BorderedNewton();

  /// b = du/dt along the path at the committed state; dt is 1. The linear iterations are counted in the result.
  NewtonResult rate(PathPoint& rate);
  /// Residual over reactions at `point`, where infinity stands for one that is not finite.
  double relative_residual(const PathPoint& point);

  /// True while GMRES stands in for conjugate gradients.
  bool indefinite() const;

  /// Solves for equilibrium and the constraint, starting at `point`, where it also ends. `step` only labels the
  /// records. On convergence the medium's state under trial is the one to commit and `force` [owned * dimension] its
  /// internal force.
  NewtonResult solve(PathPoint& point, const PathConstraint& constraint, int most_iterations, int step,
                     Observer& observer, std::vector<double>& force);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace perinox::equilibrium
