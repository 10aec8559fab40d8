#pragma once
#include <optional>
#include <vector>

#include "perinox/mechanics/evaluation.hpp"

namespace perinox::mechanics {

/// The work of a converged step along the path that bonds and return mapping take, less that along the chord of the
/// step, -(f_before + f_after)/2 . du for the internal force f: the chord leaves out that bonds turn and that forces
/// bend where flow begins. docs/theory.md, section 4. Nothing for an elastic step with small strains, nor for a scene
/// that is not from_sums().
class PathWork {
 public:
  /// Before the trial is committed. Collective.
  PathWork(Evaluation& evaluation, const Committed& committed, const Trial& trial);
  /// This rank's share. committed: the same after advancing with that trial. Collective.
  double beyond_chord(Evaluation& evaluation, const Committed& committed) const;

 private:
  double work_ = 0;
  std::optional<medium::Displacement> start_;  ///< before a step in which something flows
};

}  // namespace perinox::mechanics
