#pragma once
#include "perinox/mechanics/scene.hpp"

namespace perinox::mechanics {

/// Calls visit(i, j) with the local indices of each intact bond that has an end of this rank's, once.
template <class Visit>
void each_bond(const mechanics::Scene& scene, const Visit& visit) {
  if (scene.lattice())
    scene.lattice()->each([&](LocalIndex i, LocalIndex j, const bonds::StencilOffset&) { visit(i, j); });
  else
    scene.pairs()->each([&](LocalIndex i, LocalIndex j, double, double) { visit(i, j); });
}

}  // namespace perinox::mechanics
