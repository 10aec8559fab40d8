#pragma once
/// The particles of a scene on this rank: owned ones first (ascending id), then ghosts (ascending id).
#include <map>
#include <string>
#include <vector>

#include "perinox/body/halo.hpp"
#include "perinox/core/communicator.hpp"
#include "perinox/core/types.hpp"
#include "perinox/deck/deck.hpp"

namespace perinox::body {

struct Body {
  Communicator communicator;
  int dimension = 3;  ///< unknowns a particle: 3 or 2
  int owned = 0;
  int ghosts = 0;
  GlobalId total = 0;  ///< particles on all ranks
  double reach = 0;    ///< length: every particle this near to an owned one is on this rank
  /// Length: of the lattices of all bodies; 0 if one of them is a cloud or has another spacing.
  double spacing = 0;
  /// [bodies of the deck] length: of each body's own lattice, as its deck entry has it; 0: a point cloud.
  std::vector<double> lattice_spacing;

  std::vector<GlobalId> id;       ///< [owned + ghosts]
  std::vector<double> reference;  ///< [(owned + ghosts) * dimension] position X, length
  std::vector<double> volume;     ///< [owned + ghosts] 3-D: volume; 2-D: area (unit thickness)
  std::vector<int> part;          ///< [owned + ghosts] index into deck.body, the block
  std::vector<int> material;      ///< [owned + ghosts] index into deck.materials
  Halo halo;

  /// Owned particles of each named set, ascending. `all` and every body's name are sets too. No set is empty over all
  /// ranks; on one rank it may be.
  std::map<std::string, std::vector<LocalIndex>> sets;

  int local() const { return owned + ghosts; }
  const double* position(LocalIndex i) const { return &reference[static_cast<std::size_t>(i) * dimension]; }
  /// Position with z = 0 filled in for 2-D.
  deck::Point position3(LocalIndex i) const;
  /// Distance of a particle from its neighbours, length: the spacing of its body's lattice, whatever part of a cell the
  /// particle stands for; in a cloud V^(1/d). Depends on nothing but the particle and its own body.
  double spacing_of(LocalIndex i) const;
  /// What rounding may have moved a particle by, length: a few units in the last place of its coordinates.
  double rounding(LocalIndex i) const;
};

/// How well the particles are spread over the ranks.
struct PartitionReport {
  double bond_imbalance = 1;      ///< most bonds on a rank over the mean
  double particle_imbalance = 1;  ///< most particles on a rank over the mean
  std::vector<long long> owned;   ///< of each rank
  std::vector<long long> ghosts;  ///< of each rank
};

/// Largest lattice spacing of the deck's bodies (for a cloud: the cube or square root of its mean volume).
double largest_spacing(const deck::Deck& deck, const Communicator& communicator);
/// The horizon as a length.
double horizon_length(const deck::Deck& deck, const Communicator& communicator);

/// Generates or reads the particles, partitions them with Zoltan2 (coordinates, weighted by the number of neighbours
/// within `reach`), and brings in as ghosts every particle within `reach` of an owned one. Ids do not depend on the
/// number of ranks. Collective. Throws InputError on all ranks together: empty body, empty set, particles nearer
/// to each other than 1e-8 of their spacing, an id out of range, a malformed cloud, more than 2e9 particles.
Body build(const deck::Deck& deck, const Communicator& communicator, double reach, PartitionReport* report = nullptr);

}  // namespace perinox::body
