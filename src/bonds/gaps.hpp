#pragma once
#include <optional>
#include <vector>

#include "perinox/body/body.hpp"
#include "perinox/body/solid.hpp"
#include "perinox/bonds/families.hpp"

namespace perinox::bonds {

/// Bonds do not reach across what is not material: a bond more than 0.3 spacings of whose straight segment lie outside
/// the shapes of the bodies is not made (bonds: {across_gaps: cut}). What touches a shape's surface is inside of it. A
/// point cloud's shape is known where its body names an outline, on which points within 0.01 horizons lie; without one
/// its bonds stay. With bond_bodies: false
/// the shape is that of the bond's own body, else all bodies together.
class Gaps {
 public:
  /// Both must outlive it. reach: length of the longest bond.
  Gaps(const deck::Deck& deck, const body::Body& body, double horizon, double reach);

  /// Takes the bonds of particle i that leave the material out of `found`; returns how many. From either end a bond
  /// gets the same answer, to the last bit.
  int remove(LocalIndex i, std::vector<FoundBond>& found) const;

 private:
  bool leaves(LocalIndex i, LocalIndex j) const;

  const body::Body& body_;
  double reach_;
  bool looked_at_ = false;                         ///< false where no bond of the scene can leave the material
  bool together_ = false;                          ///< bodies are bonded: their shapes count as one
  std::vector<const deck::Shape*> shape_;          ///< [bodies of the deck] of a lattice; null: a cloud
  std::vector<std::optional<body::Solid>> solid_;  ///< [bodies of the deck] none: a cloud without an outline
};

}  // namespace perinox::bonds
