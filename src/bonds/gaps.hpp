#pragma once
#include <optional>
#include <vector>

#include "perinox/body/body.hpp"
#include "perinox/body/solid.hpp"
#include "perinox/bonds/families.hpp"

namespace perinox::bonds {

/// Removes the bonds that leave the material (`bonds: {across_gaps: cut}`; docs/theory.md, section 9). A bond is not
/// made if more than 0.3 spacings of its straight segment lie outside the shapes of the bodies. What touches a shape's
/// surface is inside of it. With bond_bodies: false the shape is that of the bond's own body, otherwise that of all
/// bodies together. A point cloud's shape is known where its body names an outline, on which points within 0.01
/// horizons lie; without an outline its bonds stay.
class Gaps {
 public:
  /// Keeps the deck and the body by reference. reach: length of the longest bond.
  Gaps(const deck::Deck& deck, const body::Body& body, double horizon, double reach);

  /// Removes the bonds of particle i that leave the material from `found` and returns how many there were. The answer
  /// for a bond is the same from either end, to the last bit.
  int remove(LocalIndex i, std::vector<FoundBond>& found) const;

 private:
  bool leaves(LocalIndex i, LocalIndex j) const;

  const body::Body& body_;
  double reach_;
  bool looked_at_ = false;                 ///< false where no bond of the scene can leave the material
  bool together_ = false;                  ///< bodies are bonded to each other, so that their shapes count as one
  std::vector<const deck::Shape*> shape_;  ///< [bodies of the deck] shape of a lattice; null: a cloud
  /// [bodies of the deck] shape made ready for many lines; none: a cloud without an outline.
  std::vector<std::optional<body::Solid>> solid_;
};

}  // namespace perinox::bonds
