#pragma once
#include <memory>
#include <vector>

#include "bond_rule.hpp"
#include "perinox/bonds/cell_grid.hpp"

namespace perinox::bonds {

/// Finds the bonds that a particle has before cracks and gaps are considered.
class Candidates {
 public:
  virtual ~Candidates() = default;
  /// Finds the bonds of particle i in ascending id of the neighbour. Replaces what is in `found`.
  virtual void find(LocalIndex i, std::vector<FoundBond>& found) = 0;
};

/// Makes candidates from the grid's stencil, or with a k-d tree where grid is null. All arguments must outlive the
/// result. reach: length of the longest bond.
std::unique_ptr<Candidates> make_candidates(const body::Body& body, const BondRule& rule, double reach,
                                            const CellGrid* grid);

}  // namespace perinox::bonds
