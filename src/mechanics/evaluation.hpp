#pragma once
#include "perinox/mechanics/family_loops.hpp"
#include "perinox/mechanics/state.hpp"

namespace perinox::mechanics {

/// The strains at the state that was asked for last. The internal force leaves them here and the tangent finds them:
/// Newton's residual and its tangent at one state cost one kinematic sweep.
class Evaluation {
 public:
  explicit Evaluation(const Scene& scene)
      : loops_(FamilyLoops::make(scene)), back_stress_(mechanics::has_back_stress(scene)) {}

  /// Brings the sums to displacement [owned * dimension]. Collective.
  void at(const Scene& scene, const Committed& committed, const double* displacement);

  /// The same for a state that surely is a new one. displacement: [local * dimension], ghosts are filled here. What the
  /// next at() is asked for will be evaluated. Collective.
  void moved(const Scene& scene, const Committed& committed, double* displacement);

  /// Of the state of the last at() or moved(). fit: what the sums of a fitted particle say.
  materials::FamilySums sums(const Scene& scene, const Committed& committed, LocalIndex i,
                             materials::StrainFit& fit) const;
  const std::vector<double>& displacement() const { return displacement_; }  ///< [local * dimension]

  /// What the internal force makes of the sums, kept between evaluations: see FamilyLoops::forces.
  struct Law {
    std::vector<double> radial, shear, yielded;
    std::vector<bonds::Mandel> state;
  };
  const Law& law() const { return law_; }
  /// The materials' answers to the sums of the last at() or moved(): the law, and the trial, which has to be prepared.
  Law& answers(const Scene& scene, const Committed& committed, Trial& trial);

  FamilyLoops& loops() { return *loops_; }
  /// Some material has kinematic hardening.
  bool has_back_stress() const { return back_stress_; }

 private:
  void follow_bonds(const Scene& scene);

  std::unique_ptr<FamilyLoops> loops_;
  std::vector<double> displacement_;
  StrainSums sums_, whole_;  ///< whole_: without plastic extension, of moved() with kinematic hardening
  Law law_;
  bool back_stress_;
  std::uint64_t version_ = 0;
  std::uint64_t bonds_version_ = 0;
};

}  // namespace perinox::mechanics
