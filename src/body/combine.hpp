#pragma once
#include "perinox/body/intervals.hpp"
#include "perinox/body/solid.hpp"

namespace perinox::body {

/// The intervals of a curve inside of a solid, from those inside of its leaves. of_leaf(leaf, removed) returns the
/// Intervals of one leaf; `removed` is true if the leaf is taken away from the solid.
template <class OfLeaf>
Intervals combine(const Solid& solid, const OfLeaf& of_leaf, bool removed = false) {
  if (solid.kind == Solid::Kind::convex) return of_leaf(solid, removed);
  const bool taken = solid.kind == Solid::Kind::subtract;
  Intervals sum = combine(solid.parts.front(), of_leaf, removed);
  for (std::size_t k = 1; k < solid.parts.size(); ++k) {
    if (sum.empty() && solid.kind != Solid::Kind::unite) return sum;
    const Intervals part = combine(solid.parts[k], of_leaf, removed != taken);
    sum = taken ? subtract(sum, part) : solid.kind == Solid::Kind::unite ? unite(sum, part) : intersect(sum, part);
  }
  return sum;
}

}  // namespace perinox::body
