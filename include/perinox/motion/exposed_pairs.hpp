#pragma once
#include <array>
#include <vector>

#include "perinox/core/saved_state.hpp"
#include "perinox/mechanics/scene.hpp"
#include "perinox/motion/exposed_particles.hpp"

namespace perinox::motion {

/// Pairs of exposed particles that share no intact bond and are near to each other as the body is deformed. The list is
/// made by a k-d tree, of pairs nearer than the reach and a margin, and made again when a particle has gone half the
/// margin. Between ranks, exposed particles within the reach of another rank's bounding box are sent there with every
/// new list, and their places with every move.
///
/// Points are numbered: this rank's exposed particles first, in ascending local index, then those of other ranks.
class ExposedPairs {
 public:
  /// reach, margin: lengths, the same on all ranks. Finds the exposed particles.
  ExposedPairs(const mechanics::Scene& scene, double reach, double margin);

  /// To be called after bonds have broken: asks the scene's bond graph anew.
  void refresh();
  /// Takes the places at displacement [at least owned * dimension]; true if the list was made anew. Collective.
  bool move(const double* displacement);
  /// Values of this rank's points [own * count], and after them those of the points of other ranks. Collective.
  std::vector<double> share(std::vector<double> values, int count) const;

  /// Own points, and those of other ranks.
  int own() const { return static_cast<int>(exposed_.particle.size()); }
  const std::vector<LocalIndex>& particle() const { return exposed_.particle; }
  const ExposedParticles& exposed() const { return exposed_; }
  /// The first of a pair is this rank's; the second may be another's.
  const std::vector<std::array<int, 2>>& pairs() const { return pairs_; }
  const double* place(int point) const { return &place_[static_cast<std::size_t>(point) * d_]; }  ///< current
  const double* reference(int point) const {
    return &reference_[static_cast<std::size_t>(point) * d_];
  }  ///< undeformed
  long long lists() const { return lists_; }

  /// Where the particles were when the list was made [owned * dimension], and the list made of it again: in which order
  /// forces add up and how long the list lasts depend on it. Collective.
  std::vector<double> listed() const;
  void list_again(const std::vector<double>& listed);

 private:
  void make_list();
  void choose_what_to_send();
  bool moved_too_far() const;

  const mechanics::Scene& scene_;
  std::size_t d_;
  double reach_, margin_;
  ExposedParticles exposed_;
  std::vector<double> reference_, place_;  ///< [points * d]
  std::vector<double> id_;                 ///< [points]
  std::vector<double> listed_;             ///< [own * d] when the list was made
  std::vector<std::array<int, 2>> pairs_;
  std::vector<int> out_, out_count_, in_count_;  ///< own points to send, rank by rank; [ranks] how many
  bool listed_once_ = false;
  long long lists_ = 0;
};

}  // namespace perinox::motion
