#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "perinox/mechanics/family_loops.hpp"
#include "perinox/mechanics/state.hpp"
#include "perinox/medium/displacement.hpp"

namespace perinox::mechanics {

/// The strains of one scene at the state that was asked for last, and the loops that find them. The internal force
/// leaves them here and the tangent finds them, so that Newton's residual and its tangent at one state cost one
/// kinematic sweep. Whoever evaluates a scene has one and shares it with the tangents of its own.
class Evaluation {
 public:
  /// The scene must outlive it.
  explicit Evaluation(const Scene& scene);

  /// Brings the strains to `at` as seen from the committed state. Collective.
  void at(const Committed& committed, const medium::At& at);

  /// Brings them to a state that surely is a new one. displacement: [local * dimension]; ghosts are filled here. The
  /// next at() evaluates whatever it is asked for. Collective.
  void moved(const Committed& committed, double* displacement);

  /// What a material sees of particle i at the state of the last at() or moved(). fit: what the sums of a fitted
  /// particle say.
  materials::FamilySums sums(const Committed& committed, LocalIndex i, materials::StrainFit& fit) const;
  const std::vector<double>& displacement() const { return displacement_; }  ///< [local * dimension]

  /// What the internal force makes of the sums: see FamilyLoops::forces.
  struct Law {
    std::vector<double> radial, shear, yielded;
    std::vector<bonds::Mandel> state;

    /// Null where the back stress has no place of its own.
    const double* yielded_or_null() const { return yielded.empty() ? nullptr : yielded.data(); }
  };
  /// The materials' answers to the sums of the last at() or moved(). The trial has to be prepared; it is filled.
  const Law& answers(const Committed& committed, Trial& trial);
  /// The answers that were found last.
  const Law& law() const { return law_; }

  const Scene& scene() const { return scene_; }
  FamilyLoops& loops() { return *loops_; }
  /// Some material has kinematic hardening.
  bool has_back_stress() const { return back_stress_; }

 private:
  void follow_bonds();

  const Scene& scene_;
  std::unique_ptr<FamilyLoops> loops_;
  std::vector<double> displacement_;
  StrainSums sums_, whole_;  ///< whole_: without plastic extension, of moved() with kinematic hardening
  Law law_;
  bool back_stress_;
  std::uint64_t committed_version_ = 0, version_ = 0;  ///< of what was evaluated
  std::uint64_t bonds_version_ = 0;
};

}  // namespace perinox::mechanics
