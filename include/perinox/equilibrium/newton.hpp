#pragma once
#include <memory>
#include <string>
#include <vector>

#include "perinox/core/record.hpp"
#include "perinox/deck/deck.hpp"
#include "perinox/linear/failure.hpp"
#include "perinox/linear/tangent_operators.hpp"
#include "perinox/loads/boundary.hpp"
#include "perinox/medium/medium.hpp"

namespace perinox::equilibrium {

/// Sizes of the out-of-balance force and of what it is measured against; the same on every rank. Particles that have
/// come loose do not count: whatever acts on them has nothing to do with the others' equilibrium.
struct ForceBalance {
  double residual = 0;      ///< 2-norm of internal + external force over the free unknowns
  double reaction = 0;      ///< 2-norm of it over the prescribed unknowns
  double external = 0;      ///< 2-norm of the external force
  double displacement = 0;  ///< 2-norm of the displacement
  bool finite = true;
};

struct NewtonResult {
  bool converged = false;
  linear::Failure failure = linear::Failure::none;
  std::string reason;  ///< a sentence, where not converged
  int newton_iterations = 0;
  int linear_iterations = 0;
};

/// One load step: NOX's Newton-Raphson on the force balance, Belos for the linear systems, return mapping inside every
/// evaluation. Holds the tangent system across steps. Collective throughout.
class Newton {
 public:
  /// Everything is kept by reference.
  Newton(const deck::Deck& deck, medium::Medium& medium, const loads::Boundary& boundary);
  ~Newton();

  /// Solves for equilibrium at load parameter t from the committed state. `step` only labels the records. On
  /// convergence the medium's state under trial is the one to commit and `force` [owned * dimension] its internal
  /// force. `guess` [owned * dimension] starts the free unknowns, or is empty. Where an attempt fails and better linear
  /// solves may be the remedy, it is made again with them: to a tighter tolerance, or, in a small scene whose conjugate
  /// gradients converge badly (a slender body), with a direct solver. What has helped is kept.
  NewtonResult solve(double t, int step, const std::vector<double>& guess, Observer& observer,
                     std::vector<double>& force);

  /// Where there is no stable equilibrium near the committed state: goes down in energy to the next one. Needs a
  /// symmetric tangent that is not a matrix; a failure with an empty reason elsewhere.
  NewtonResult descend(double t, int step, Observer& observer, std::vector<double>& force);

  /// To be called when bonds have broken or supports have changed. The tangent system is made anew where it has to be:
  /// with other supports, where it is a matrix, or where the linear solves have come to take half as many iterations
  /// again as after it was made, because the coarse functions still tie the new crack's faces together.
  void bonds_changed(bool supports_too);

  /// What the next solve finds here of the ones before, and the way back. To be restored with the bonds broken that
  /// were when the coarse part was made ("tangent/coarse_bonds_broken"), after bonds_changed() with those of
  /// "tangent/bonds_broken". Collective.
  void save(StateWriter& writer) const;
  void restore(StateReader& reader);
  /// Which better linear solves have come to be used. To be restored before anything else here.
  void save_remedies(StateWriter& writer) const;
  void restore_remedies(StateReader& reader);

  const linear::TangentSystem& system() const;
  linear::TangentSystem& system();

 private:
  NewtonResult attempt(double t, int step, const std::vector<double>& guess, Observer& observer,
                       std::vector<double>& force);
  bool may_take_direct() const;
  void make_parts();
  void set_tolerance();

  const deck::Deck& deck_;
  medium::Medium& medium_;
  const loads::Boundary& boundary_;
  bool careful_ = false;  ///< linear solves to a tighter tolerance
  bool in_vain_ = false;  ///< that has not helped either, at this step
  bool direct_ = false;   ///< in place of conjugate gradients
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace perinox::equilibrium
