#pragma once
#include <functional>
#include <vector>

#include "perinox/body/body.hpp"
#include "perinox/bonds/bonds.hpp"

namespace perinox::bonds {

/// The intact neighbours of an owned particle i, as local indices, ghosts included, in any order; replaces what is in
/// `neighbors`. Bonds are mutual: where j is a neighbour of i, i is one of j, on the rank that owns j.
using BondGraph = std::function<void(LocalIndex i, std::vector<LocalIndex>& neighbors)>;

/// The graph of stored bonds, which must outlive it. The one place that knows how they are stored.
BondGraph bond_graph(const Bonds& bonds);

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
