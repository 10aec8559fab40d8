#pragma once
#include <cstdint>
#include <vector>

#include "perinox/bonds/families.hpp"

namespace perinox::bonds {

/// All bonds, stored family by family. The sparse assembly, checks and whoever asks for neighbours use them. They take
/// 28 bytes a directed bond, so nothing that must run on large bodies uses them.
struct Bonds : Families {
  std::vector<std::int64_t> offset;  ///< [owned + 1] first bond of each family
  std::vector<LocalIndex> neighbor;  ///< [bonds] local index of j; ascending id of j within a family
  std::vector<double> length;        ///< [bonds] reference length xi
  std::vector<double> weight;        ///< [bonds] V_j times the quadrature's share of it
  std::vector<double> influence;     ///< [bonds] omega(xi)

  std::int64_t count() const { return offset.empty() ? 0 : offset.back(); }
  int family_size(LocalIndex i) const { return static_cast<int>(offset[i + 1] - offset[i]); }
  /// The bonds of one family, in the form in which find_families hands them out.
  std::vector<FoundBond> family(LocalIndex i) const;
};

/// Calls find_families and stores every family. Collective; throws what find_families throws.
Bonds build(const deck::Deck& deck, const body::Body& body, double horizon);

}  // namespace perinox::bonds
