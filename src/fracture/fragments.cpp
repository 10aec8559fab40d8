#include "perinox/fracture/fragments.hpp"

#include <algorithm>

#include "perinox/bonds/components.hpp"

namespace perinox::fracture {

void Fragments::find() {
  const bonds::Components pieces = bonds::connected_components(model_.body(), model_.bond_graph());
  number_.assign(pieces.of.begin(), pieces.of.begin() + model_.owned());
  single_ = std::count(pieces.particles.begin(), pieces.particles.end(), 1LL);
  several_ = pieces.count() - single_;
}

}  // namespace perinox::fracture
