#pragma once
/// Changes of a scene's description that must not change its answer.
#include <optional>
#include <string>
#include <vector>

#include "random_scenes.hpp"
#include "rewriting.hpp"

namespace perinox::invariance {

/// The box in which the particles of an answer are.
struct Extent {
  Vector3 min{}, max{};
  double length() const;  ///< the largest
};
Extent extent_of(const Answer& answer);

/// Changes of the frame and the units: moved by 1e5 body lengths, mirrored, axes exchanged, units of length and of
/// stress. Files are written under `prefix`.
std::vector<Variant> frames(const DeckText& deck, const Extent& extent, int dimension, Lot& lot,
                            const std::string& prefix);
/// A deck of clouds turned by any angle.
Variant turned(const DeckText& deck, int dimension, Lot& lot, const std::string& prefix);

/// Adds one more body, far away, of another material and spacing, held all over: a lattice, or a cloud.
Variant with_far_body(const DeckText& deck, const Extent& extent, double spacing, bool cloud, Lot& lot,
                      const std::string& prefix);
/// Bodies, materials and sets in reverse order. It is absent if there is only one body.
std::optional<Variant> reordered(const DeckText& deck);
/// The rows of every cloud in another order. It is absent if there is no cloud.
std::optional<Variant> permuted(const DeckText& deck, Lot& lot, const std::string& prefix);
/// Takes twice as many steps, for scenes that do not remember the way. `linear`: not even the sums of their work do.
Variant with_more_steps(const DeckText& deck, bool linear);
/// Goes to the load, back to exactly zero, and to the load again, for scenes that do not remember the way.
Variant through_zero(const DeckText& deck);

}  // namespace perinox::invariance
