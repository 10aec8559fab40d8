#pragma once
/// What any scene can be put through without another answer.
#include <optional>
#include <string>
#include <vector>

#include "random_scenes.hpp"
#include "rewriting.hpp"

namespace perinox::invariance {

/// Where the particles of an answer are.
struct Extent {
  Vector3 min{}, max{};
  double length() const;  ///< the largest
};
Extent extent_of(const Answer& answer);

/// The frame and the units changed: moved by 1e5 body lengths, mirrored, axes exchanged, units of length and of
/// stress. Files are written under `prefix`.
std::vector<Variant> frames(const DeckText& deck, const Extent& extent, int dimension, Lot& lot,
                            const std::string& prefix);
/// A deck of clouds turned by any angle.
Variant turned(const DeckText& deck, int dimension, Lot& lot, const std::string& prefix);

/// One more body, far away, of another material and spacing, held all over: a lattice, or a cloud.
Variant with_far_body(const DeckText& deck, const Extent& extent, double spacing, bool cloud, Lot& lot,
                      const std::string& prefix);
/// Bodies, materials and sets in reverse order; none if there is only one body.
std::optional<Variant> reordered(const DeckText& deck);
/// The rows of every cloud in another order; none if there is no cloud.
std::optional<Variant> permuted(const DeckText& deck, Lot& lot, const std::string& prefix);
/// Twice as many steps. For scenes that do not remember the way there; `linear`: not even in the sums of their work.
Variant with_more_steps(const DeckText& deck, bool linear);
/// To the load, back to exactly zero, and to the load again. For scenes that do not remember.
Variant through_zero(const DeckText& deck);

}  // namespace perinox::invariance
