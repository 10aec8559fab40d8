#pragma once
#include <functional>
#include <vector>

#include "perinox/bonds/bonds.hpp"

namespace perinox::bonds {

/// A function that lists the intact neighbours of an owned particle i as local indices, ghosts included, in any order.
/// It replaces what is in `neighbors`. Bonds are mutual: where j is a neighbour of i, i is a neighbour of j on the rank
/// that owns j.
using BondGraph = std::function<void(LocalIndex i, std::vector<LocalIndex>& neighbors)>;

/// The graph of stored bonds. These must outlive it.
BondGraph bond_graph(const Bonds& bonds);

}  // namespace perinox::bonds
