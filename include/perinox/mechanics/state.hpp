#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "perinox/core/saved_state.hpp"
#include "perinox/mechanics/plastic_extension.hpp"
#include "perinox/mechanics/scene.hpp"
#include "perinox/medium/medium.hpp"

namespace perinox::mechanics {

class Committed;
class Evaluation;

/// A state under trial: what one evaluation of the internal force leaves behind. Worthless until committed. The
/// displacement has the ghosts too, up to date: [local * dimension].
struct Trial : medium::Trial {
  double unflowed = 0;     ///< energy of this rank's particles, had nothing flowed in the step
  long long yielding = 0;  ///< this rank's particles that flow in the step
  std::vector<double> point_history;
  std::vector<double> bond_history;  ///< only where the scene is not made of sums
  std::vector<double> flow;          ///< [owned] share of the elastic part that flows; empty: no plastic material
  std::vector<double> dilatation;    ///< [owned]
  std::vector<double> mean;          ///< [owned] dilatation/d as the material takes it

  /// Sizes the arrays but those of displacement and bonds, and sets the sums to zero.
  void prepare(const Scene& scene, const Committed& committed);
};

/// The state after the last converged step. Evaluations read it and cannot write it; only the load stepper moves it on,
/// with a converged trial.
class Committed {
 public:
  /// The undeformed body at t = 0.
  explicit Committed(const Scene& scene);
  Committed(Committed&&) = default;
  Committed& operator=(Committed&&) = default;

  /// The trial, evaluated from this state, becomes the committed state. Plastic extension grows in place, by a sweep of
  /// the evaluation's loops.
  void advance(Evaluation& evaluation, Trial&& trial);

  /// Everything this state holds, and the way back: the same numbers in the same places on as many ranks. Collective.
  /// restore() throws InputError if the saved state is of another body.
  void save(const Scene& scene, StateWriter& writer) const;
  void restore(Evaluation& evaluation, StateReader& reader);

  double t() const { return t_; }
  const std::vector<double>& displacement() const { return displacement_; }
  const std::vector<double>& point_history() const { return point_history_; }
  const PlasticExtension& plastic() const { return *plastic_; }
  /// The same, to be kept by a tangent.
  std::shared_ptr<const PlasticExtension> shared_plastic() const { return plastic_; }
  /// Of the broken bonds of owned particle i.
  bonds::BrokenElastic broken_elastic(const Scene& scene, LocalIndex i) const;
  /// [owned] dilatation/d; what strains are measured from, so that little cancels.
  const std::vector<double>& mean() const { return mean_; }
  /// The displacement's owned unknowns with the number of this state.
  medium::At at() const { return {displacement_.data(), version_}; }
  /// Differs between any two states.
  std::uint64_t version() const { return version_; }

  /// Of a scene that is not made of sums.
  const std::vector<double>& bond_history() const { return bond_history_; }

  const double* point_history(const Scene& scene, LocalIndex i) const {
    return point_history_.data() + scene.point_history()[i];
  }

 private:
  void flow_of_broken(const Scene& scene, const Trial& trial);

  double t_ = 0;
  std::vector<double> displacement_;
  std::vector<double> point_history_;
  std::vector<double> bond_history_;
  std::vector<double> mean_;
  std::vector<bonds::BrokenElastic> broken_elastic_;  ///< [owned], or empty: zero
  std::shared_ptr<PlasticExtension> plastic_;
  std::uint64_t version_ = 0;
};

}  // namespace perinox::mechanics
