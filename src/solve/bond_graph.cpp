#include "perinox/solve/bond_graph.hpp"

namespace perinox::solve {

BondGraph bond_graph(const mechanics::Scene& scene) {
  return [&scene](LocalIndex i, std::vector<LocalIndex>& neighbors) {
    const bonds::Bonds& bonds = scene.bonds();
    neighbors.assign(bonds.neighbor.begin() + bonds.offset[i], bonds.neighbor.begin() + bonds.offset[i + 1]);
  };
}

}  // namespace perinox::solve
