#pragma once
#include <vector>

#include "perinox/mechanics/scene.hpp"

namespace perinox::mechanics {

/// A state under trial: what one evaluation of the internal force leaves behind. Worthless until committed.
struct Trial {
  double t = 0;
  std::vector<double> displacement;  ///< [local * dimension], ghosts up to date
  std::vector<double> point_history;
  std::vector<double> bond_history;
  std::vector<double> dilatation;     ///< [owned]
  std::vector<double> stored_energy;  ///< [owned] energy a volume
  double stored = 0;                  ///< energy of this rank's particles
  double dissipated = 0;              ///< energy this rank's particles dissipate in the step
  long long yielding = 0;             ///< this rank's particles that flow in the step
};

/// The state after the last converged step. Evaluations read it and cannot write it; only the load stepper makes a new
/// one, from a converged trial.
class Committed {
 public:
  /// The undeformed body at t = 0.
  explicit Committed(const Scene& scene);
  /// The trial becomes the truth.
  explicit Committed(Trial&& trial);

  double t() const { return t_; }
  const std::vector<double>& displacement() const { return displacement_; }
  const std::vector<double>& point_history() const { return point_history_; }
  const std::vector<double>& bond_history() const { return bond_history_; }

  materials::CommittedHistory history(const Scene& scene, LocalIndex i) const {
    return {point_history_.data() + scene.history().point[i], bond_history_.data() + scene.history().bond[i]};
  }

 private:
  double t_ = 0;
  std::vector<double> displacement_;
  std::vector<double> point_history_;
  std::vector<double> bond_history_;
};

}  // namespace perinox::mechanics
