#pragma once
#include <memory>
#include <vector>

#include "bond_rule.hpp"
#include "perinox/bonds/cell_grid.hpp"

namespace perinox::bonds {

/// The bonds a particle has before cracks and gaps, in ascending id of the neighbour.
class Candidates {
 public:
  virtual ~Candidates() = default;
  /// Replaces what is in `found`.
  virtual void find(LocalIndex i, std::vector<FoundBond>& found) = 0;
};

/// From the grid's stencil, or by a k-d tree where grid is null. All arguments must outlive it. reach: length.
std::unique_ptr<Candidates> make_candidates(const body::Body& body, const BondRule& rule, double reach,
                                            const CellGrid* grid);

}  // namespace perinox::bonds
