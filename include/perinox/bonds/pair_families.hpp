#pragma once
#include <cstdint>
#include <vector>

#include "perinox/bonds/bond_graph.hpp"

namespace perinox::bonds {

/// The owned particles in the order of a space-filling curve (Morton's), so that neighbours in space are near in
/// memory.
std::vector<LocalIndex> curve_order(const body::Body& body);

/// The families of any body as pairs. Each pair is kept once: with the first of its particles along the curve, or with
/// the owned one if the other is a ghost. Pairs of one particle are padded to a multiple of eight with a particle that
/// is not there. A pair takes 4 bytes for the index and 8 for its length; it takes 8 more where influence or quadrature
/// differ from bond to bond.
class PairFamilies {
 public:
  static constexpr int lanes = 8;

  PairFamilies(const body::Body& body, std::vector<LocalIndex> order);
  /// Takes the family of one owned particle. It is to be called for every one in the order given; then complete().
  void receive(LocalIndex i, const std::vector<FoundBond>& family, const body::Body& body);
  void complete();

  /// A slot is a place in the order of this layout: owned particles along the curve, then ghosts, then the particle
  /// that is not there.
  const std::vector<LocalIndex>& particle() const { return particle_; }  ///< [slots - 1] particle of each slot
  const std::vector<int>& slot() const { return slot_; }                 ///< [local] slot of each particle
  int slots() const { return static_cast<int>(particle_.size()) + 1; }

  const std::vector<std::int64_t>& begin() const { return begin_; }  ///< [owned + 1] first pair of each owned slot
  const std::vector<std::int32_t>& far() const { return far_; }      ///< [pairs] slot of the far end
  const std::vector<double>& length() const { return length_; }      ///< [pairs] xi; 1 in padding
  /// [pairs] omega(xi) times the quadrature's share, 0 in padding. Empty if that is 1 for every pair.
  const std::vector<double>& weight() const { return weight_; }
  /// Owned slots whose pairs join owned particles only. They can be worked on while ghosts' values are on their way.
  const std::vector<std::int32_t>& interior() const { return interior_; }
  /// All other owned slots.
  const std::vector<std::int32_t>& boundary() const { return boundary_; }
  std::size_t bytes() const;

  /// A bond that was removed.
  struct Removed {
    double length = 0;
    double weight = 0;  ///< omega times the quadrature's share
  };
  /// Removes the bond between two particles for good: its place becomes padding. The length of the result is zero if
  /// there is no such bond.
  Removed remove(LocalIndex i, LocalIndex j);
  /// Calls visit(near end, far end, length, omega times share) once for every bond.
  template <class Visit>
  void each(const Visit& visit) const {
    for (int s = 0; s < owned_; ++s)
      for (std::int64_t k = begin_[s]; k < begin_[s + 1]; ++k)
        if (far_[k] != slots() - 1)
          visit(particle_[s], particle_[far_[k]], length_[k], weight_.empty() ? 1.0 : weight_[k]);
  }

  /// One end of a bond, as the sweeps over the pairs see it.
  struct Place {
    LocalIndex neighbor;
    int near;           ///< owned slot that keeps the pair
    std::int64_t pair;  ///< index of the pair
    bool far;           ///< true: the particle is the pair's far end
  };
  /// Finds particle i's end of its bond to j, at least one of the two owned. The neighbor of the result is -1 if there
  /// is none.
  Place find(LocalIndex i, LocalIndex j) const;
  /// Finds all bonds of all owned particles: [owned][family].
  std::vector<std::vector<Place>> places() const;
  /// The graph of these bonds. It must not outlive the families. It holds four bytes a directed bond.
  BondGraph graph() const;

 private:
  int owned_ = 0;
  std::vector<LocalIndex> particle_;
  std::vector<int> slot_;
  std::vector<std::int64_t> begin_;
  std::vector<std::int32_t> far_, interior_, boundary_;
  std::vector<double> length_, weight_;
};

}  // namespace perinox::bonds
