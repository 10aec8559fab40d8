#pragma once
/// The particles of a scene on this rank: owned ones first (by ascending id), then ghosts (by ascending id).
#include <map>
#include <string>
#include <vector>

#include "perinox/body/halo.hpp"
#include "perinox/core/communicator.hpp"
#include "perinox/core/types.hpp"
#include "perinox/deck/deck.hpp"

namespace perinox::body {

/// The particles of a scene on one rank.
struct Body {
  Communicator communicator;
  int dimension = 3;  ///< unknowns a particle: 3 or 2
  int owned = 0;
  int ghosts = 0;
  GlobalId total = 0;  ///< particles on all ranks
  double reach = 0;    ///< length: every particle that is this near to an owned one is on this rank
  /// Spacing of the lattices of all bodies, length. It is 0 if one of them is a cloud or if their spacings differ.
  double spacing = 0;
  /// [bodies of the deck] spacing of each body's own lattice, length, as its deck entry has it; 0 for a point cloud.
  std::vector<double> lattice_spacing;

  std::vector<GlobalId> id;       ///< [owned + ghosts]
  std::vector<double> reference;  ///< [(owned + ghosts) * dimension] position X, length
  std::vector<double> volume;     ///< [owned + ghosts] 3-D: volume; 2-D: area (unit thickness)
  std::vector<int> part;          ///< [owned + ghosts] index into deck.body, the block
  std::vector<int> material;      ///< [owned + ghosts] index into deck.materials
  Halo halo;

  /// Owned particles of each named set, ascending. `all` and every body's name are sets too. No set is empty over all
  /// ranks, but a set may be empty on one rank.
  std::map<std::string, std::vector<LocalIndex>> sets;

  int local() const { return owned + ghosts; }
  const double* position(LocalIndex i) const { return &reference[static_cast<std::size_t>(i) * dimension]; }
  /// Position of a particle, with z = 0 filled in for 2-D.
  deck::Point position3(LocalIndex i) const;
  /// Distance of a particle from its neighbours, length. It is the spacing of its body's lattice, whatever part of a
  /// cell the particle stands for, and V^(1/d) in a cloud. It depends on nothing but the particle and its own body.
  double spacing_of(LocalIndex i) const;
  /// Length by which rounding may have moved a particle: a few units in the last place of its coordinates.
  double rounding(LocalIndex i) const;
};

/// How well the particles are spread over the ranks.
struct PartitionReport {
  double bond_imbalance = 1;      ///< most bonds on a rank over the mean
  double particle_imbalance = 1;  ///< most particles on a rank over the mean
  std::vector<long long> owned;   ///< [ranks] owned particles of each rank
  std::vector<long long> ghosts;  ///< [ranks] ghosts of each rank
};

/// Largest lattice spacing of the deck's bodies, length. For a cloud without a spacing it is the cube or square root of
/// its mean volume. Collective. Throws InputError on all ranks together for a body without a usable spacing.
double largest_spacing(const deck::Deck& deck, const Communicator& communicator);
/// The deck's horizon as a length. Collective.
double horizon_length(const deck::Deck& deck, const Communicator& communicator);

/// Makes the body of a deck. It generates or reads the particles, partitions them with Zoltan2 (by coordinates,
/// weighted by the number of neighbours within `reach`), and adds as ghosts all particles within `reach` (a length) of
/// an owned one. Ids do not depend on the number of ranks. Fills `report` if it is not null. Collective. Throws
/// InputError on all ranks together for an empty body, an empty set, particles nearer to each other than 1e-8 of their
/// spacing, an id out of range, a malformed cloud, and more than 2e9 particles.
Body build(const deck::Deck& deck, const Communicator& communicator, double reach, PartitionReport* report = nullptr);

}  // namespace perinox::body
