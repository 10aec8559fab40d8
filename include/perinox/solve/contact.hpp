#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "perinox/body/neighbor_search.hpp"
#include "perinox/core/saved_state.hpp"
#include "perinox/deck/deck.hpp"
#include "perinox/mechanics/scene.hpp"

namespace perinox::solve {

/// Short-range repulsion of particles that share no intact bond. Two of them at a distance r below their reach
///     r_c = distance (h_i + h_j)/2, h = V^(1/d), or their distance in the undeformed body where that is less,
/// have the energy k (r_c - r)^2/2, k = stiffness V_i V_j (alpha_i omega(h_i) + alpha_j omega(h_j)), `stiffness` times
/// what a bond of one spacing between the two would have: central forces, equal and opposite to the last bit.
///
/// Looked at are exposed particles only: those whose bonds are lopsided, as at a surface or a crack, or few. A list of
/// pairs nearer than r_c and a margin is made by a k-d tree and made again when a particle has gone half the margin.
/// Between ranks, exposed particles within the reach of another rank's bounding box are sent there with every new list,
/// and their places with every evaluation; either rank then works out the force on its own particle.
class Contact {
 public:
  /// Collective.
  Contact(const mechanics::Scene& scene, const deck::Contact& settings);

  /// Adds the forces at displacement [at least owned * dimension] to force [owned * dimension]; returns this rank's
  /// share of the energy: half of a pair's that two ranks have. Collective.
  double add_forces(const double* displacement, double* force);
  /// To be called after bonds have broken: asks the scene's bond graph anew. Collective.
  void refresh();

  /// Where the particles were when the list was made, from which it is made again: in which order forces add up and how
  /// long the list lasts depend on it. Collective.
  void save(StateWriter& writer) const;
  void restore(StateReader& reader);

  /// What contacts add at most to the largest eigenvalue of M^-1 K where no particle has more than six, 1/time^2.
  /// masses: [owned]. Collective.
  double largest_eigenvalue(const std::vector<double>& masses) const;
  /// Pairs on this rank's list, exposed particles among its own, and lists made so far; for tests and reports.
  std::size_t pairs() const { return pairs_.size(); }
  std::size_t exposed() const { return own_.size(); }
  long long lists() const { return lists_; }

 private:
  struct Point {
    GlobalId id = 0;
    double reference[3] = {};
    double volume = 0;
    double spacing = 0;
    double stiffness = 0;  ///< alpha omega
  };
  struct Pair {
    int own, other;  ///< indices into the points; `other` may be of another rank
    double reach, stiffness;
  };
  static constexpr std::size_t sent = 7;  ///< numbers of a point on its way, besides its place

  void find_exposed();
  void place_own(const double* displacement);
  bool moved_too_far() const;
  void make_list();
  void exchange_points();
  void exchange_places();

  const mechanics::Scene& scene_;
  deck::Contact settings_;
  int d_;
  double largest_reach_ = 0, margin_ = 0;
  std::vector<double> stiffness_;              ///< [owned] alpha omega
  std::vector<LocalIndex> particle_;           ///< [own] of each exposed particle
  std::vector<Point> own_, other_;             ///< this rank's, then those other ranks have sent
  std::vector<double> place_;                  ///< [(own + other) * d] current
  std::vector<double> listed_;                 ///< [own * d] when the list was made
  std::vector<std::vector<GlobalId>> bonded_;  ///< [own] ascending
  std::vector<Pair> pairs_;
  std::vector<int> out_, out_count_, in_count_;  ///< own points to send, rank by rank; [ranks] how many
  bool listed_once_ = false;
  long long lists_ = 0;
};

}  // namespace perinox::solve
