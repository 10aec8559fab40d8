#pragma once
#include <functional>
#include <vector>

#include "perinox/mechanics/scene.hpp"

namespace perinox::solve {

/// Writes the neighbours that owned particle i is still bonded to (local indices, ghosts included) over `neighbors`.
/// What the coarse grid knows of bonds: however they are stored, nothing else of them is read here.
using BondGraph = std::function<void(LocalIndex i, std::vector<LocalIndex>& neighbors)>;

/// The graph of the scene's families; keeps a reference to the scene.
BondGraph bond_graph(const mechanics::Scene& scene);

}  // namespace perinox::solve
