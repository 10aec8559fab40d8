#pragma once
#include <vector>

#include "perinox/deck/deck.hpp"
#include "perinox/mechanics/scene.hpp"
#include "perinox/motion/exposed_pairs.hpp"

namespace perinox::motion {

/// Short-range repulsion of particles that share no intact bond. Two of them at a distance r below their reach
///     r_c = distance max(h_i, h_j), or their distance in the undeformed body where that is less,
/// h being Body::spacing_of(), have the energy k (r_c - r)^2/2, k = stiffness V_i V_j (alpha_i omega(h_i) + alpha_j
/// omega(h_j)), `stiffness` times what a bond of one spacing between the two would have: central forces, equal and
/// opposite to the last bit.
///
/// Looked at are exposed particles only. Where two ranks have a pair, either works out the force on its own particle.
class Contact {
 public:
  /// Collective.
  Contact(const mechanics::Scene& scene, const deck::Contact& settings);

  /// Adds the forces at displacement [at least owned * dimension] to force [owned * dimension]; returns this rank's
  /// share of the energy: half of a pair's that two ranks have. Collective.
  double add_forces(const double* displacement, double* force);
  /// To be called after bonds have broken: asks the scene's bond graph anew.
  void refresh() { near_.refresh(); }

  /// Where the particles were when the list was made, from which it is made again. Collective.
  void save(StateWriter& writer) const;
  void restore(StateReader& reader);

  /// What contacts add at most to the largest eigenvalue of M^-1 K where no particle has more than six, 1/time^2.
  /// masses: [owned]. Collective.
  double largest_eigenvalue(const std::vector<double>& masses) const;
  /// Pairs on this rank's list, exposed particles among its own, and lists made so far; for tests and reports.
  std::size_t pairs() const { return near_.pairs().size(); }
  std::size_t exposed() const { return near_.particle().size(); }
  long long lists() const { return near_.lists(); }

 private:
  struct Spring {
    double reach, stiffness;
  };
  void find_stiffness();
  double largest_reach() const;
  void make_springs();

  const mechanics::Scene& scene_;
  deck::Contact settings_;
  int d_;
  std::vector<double> stiffness_;  ///< [owned] alpha omega
  ExposedPairs near_;
  std::vector<Spring> springs_;  ///< [pairs of near_]
};

}  // namespace perinox::motion
