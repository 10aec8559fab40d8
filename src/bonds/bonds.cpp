#include "perinox/bonds/bonds.hpp"

#include <numeric>

namespace perinox::bonds {

std::vector<FoundBond> Bonds::family(LocalIndex i) const {
  std::vector<FoundBond> found;
  for (std::int64_t k = offset[i]; k < offset[i + 1]; ++k)
    found.push_back({neighbor[k], length[k], weight[k], influence[k]});
  return found;
}

Bonds build(const deck::Deck& deck, const body::Body& body, double horizon) {
  Bonds bonds;
  bonds.offset.push_back(0);
  std::vector<LocalIndex> order(static_cast<std::size_t>(body.owned));
  std::iota(order.begin(), order.end(), 0);
  const auto grid = find_grid(body);
  static_cast<Families&>(bonds) = find_families(
      deck, body, horizon, grid ? &*grid : nullptr, order, [&](LocalIndex, const std::vector<FoundBond>& family) {
        for (const FoundBond& bond : family) {
          bonds.neighbor.push_back(bond.neighbor);
          bonds.length.push_back(bond.length);
          bonds.weight.push_back(bond.weight);
          bonds.influence.push_back(bond.influence);
        }
        bonds.offset.push_back(static_cast<std::int64_t>(bonds.neighbor.size()));
      });
  return bonds;
}

}  // namespace perinox::bonds
