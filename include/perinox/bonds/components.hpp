#pragma once
#include <vector>

#include "perinox/body/body.hpp"
#include "perinox/bonds/bond_graph.hpp"

namespace perinox::bonds {

/// The pieces that bonds hold together. Two particles are in one piece if a chain of bonds joins them. Pieces are
/// numbered from 0 in the order of their smallest particle ids, alike on every rank and for any number of ranks.
struct Components {
  std::vector<int> of;               ///< [owned + ghosts] the piece of each particle
  std::vector<GlobalId> first;       ///< [count] smallest particle id of each piece, ascending
  std::vector<long long> particles;  ///< [count] particles of each piece over all ranks

  int count() const { return static_cast<int>(first.size()); }
};

/// Finds the pieces. It visits each bond once (union-find) and then exchanges the pieces' smallest ids between ranks
/// until nothing changes, which takes as many rounds as the longest chain of ranks through one piece. Collective.
Components connected_components(const body::Body& body, const BondGraph& graph);

}  // namespace perinox::bonds
