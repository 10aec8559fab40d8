#pragma once
#include <vector>

#include "perinox/body/body.hpp"
#include "perinox/bonds/bond_graph.hpp"

namespace perinox::bonds {

/// The pieces that bonds hold together: two particles are in one piece if a chain of bonds joins them. Numbered from 0
/// by their smallest particle id, alike on every rank and on any number of ranks.
struct Components {
  std::vector<int> of;               ///< [owned + ghosts] the piece of each particle
  std::vector<GlobalId> first;       ///< [count] smallest particle id of each, ascending
  std::vector<long long> particles;  ///< [count] over all ranks

  int count() const { return static_cast<int>(first.size()); }
};

/// Visits each bond once (union-find), then exchanges the pieces' smallest ids between ranks until nothing changes: as
/// many rounds as the longest chain of ranks through one piece. Collective.
Components connected_components(const body::Body& body, const BondGraph& graph);

}  // namespace perinox::bonds
