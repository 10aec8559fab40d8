#pragma once
#include <cstdint>
#include <vector>

#include "perinox/bonds/bond_graph.hpp"

namespace perinox::bonds {

/// The owned particles along a space-filling curve (Morton's), so that neighbours in space are near in memory.
std::vector<LocalIndex> curve_order(const body::Body& body);

/// The families of any body as pairs, each kept once: with the first of its particles along the curve, or with the
/// owned one if the other is a ghost. Pairs of one particle are padded to a multiple of eight with a particle that is
/// not there. 4 bytes a pair for the index and 8 for its length; 8 more where influence or quadrature differ from bond
/// to bond.
class PairFamilies {
 public:
  static constexpr int lanes = 8;

  PairFamilies(const body::Body& body, std::vector<LocalIndex> order);
  /// To be called for every owned particle in the order given; then complete().
  void receive(LocalIndex i, const std::vector<FoundBond>& family, const body::Body& body);
  void complete();

  /// Slots: owned particles along the curve, then ghosts, then the particle that is not there.
  const std::vector<LocalIndex>& particle() const { return particle_; }  ///< [slots - 1] of each slot
  const std::vector<int>& slot() const { return slot_; }                 ///< [local] of each particle
  int slots() const { return static_cast<int>(particle_.size()) + 1; }

  const std::vector<std::int64_t>& begin() const { return begin_; }  ///< [owned + 1] first pair of each owned slot
  const std::vector<std::int32_t>& far() const { return far_; }      ///< [pairs] slot of the far end
  const std::vector<double>& length() const { return length_; }      ///< [pairs] xi; 1 where padded
  /// [pairs] omega(xi) times the quadrature's share, 0 where padded; empty: 1 wherever there is a pair.
  const std::vector<double>& weight() const { return weight_; }
  /// Owned slots whose pairs join owned particles only: they can be worked on while ghosts' values are on their way.
  const std::vector<std::int32_t>& interior() const { return interior_; }
  const std::vector<std::int32_t>& boundary() const { return boundary_; }
  std::size_t bytes() const;

  /// A bond that was there.
  struct Removed {
    double length = 0;
    double weight = 0;  ///< omega times the quadrature's share
  };
  /// Takes the bond between two particles out, for good: its place becomes one with the particle that is not there. A
  /// length of zero if there is none.
  Removed remove(LocalIndex i, LocalIndex j);
  /// visit(near end, far end, length, omega times share) for every bond, once.
  template <class Visit>
  void each(const Visit& visit) const {
    for (int s = 0; s < owned_; ++s)
      for (std::int64_t k = begin_[s]; k < begin_[s + 1]; ++k)
        if (far_[k] != slots() - 1)
          visit(particle_[s], particle_[far_[k]], length_[k], weight_.empty() ? 1.0 : weight_[k]);
  }

  /// A bond as the sweeps see it.
  struct Place {
    LocalIndex neighbor;
    int near;           ///< owned slot that keeps the pair
    std::int64_t pair;  ///< index of the pair
    bool far;           ///< true: the particle is the pair's far end
  };
  /// Particle i's end of its bond to j, one of the two owned; its neighbor is -1 if there is none.
  Place find(LocalIndex i, LocalIndex j) const;
  /// All bonds of all owned particles: [owned][family].
  std::vector<std::vector<Place>> places() const;
  /// Who is bonded to whom; must not outlive the families. Holds four bytes a directed bond.
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
