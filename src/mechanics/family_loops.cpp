#include "perinox/mechanics/family_loops.hpp"

#include "lattice_loops.hpp"
#include "pair_loops.hpp"

namespace perinox::mechanics {

std::unique_ptr<FamilyLoops> FamilyLoops::make(const Scene& scene) {
  if (scene.lattice()) return std::make_unique<LatticeLoops>(scene);
  return std::make_unique<PairLoops>(scene);
}

}  // namespace perinox::mechanics
