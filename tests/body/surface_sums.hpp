#pragma once
/// Sums of loads of one on a body's surface.
#include <algorithm>
#include <cmath>

#include "perinox/body/exposed_faces.hpp"
#include "support/bodies.hpp"

namespace perinox::body::fixture {

struct SurfaceSums {
  double size = 0;           ///< area on which tractions act
  deck::Point area{};        ///< the vector of area
  double moment[3][3] = {};  ///< sum of x (x) vector of area; for a closed surface volume times the unit tensor
  double resultant() const { return std::max({std::abs(area[0]), std::abs(area[1]), std::abs(area[2])}); }
};

inline SurfaceSums sums_of(const deck::Deck& deck, const Body& body, const std::string& set = "all",
                           const std::optional<deck::Point>& facing = std::nullopt) {
  SurfaceSums sums;
  for (const FaceShare& face : exposed_faces(deck, body, body.sets.at(set), {"deck.yaml", 3, 5}, facing)) {
    sums.size += face.size;
    const deck::Point x = body.position3(face.particle);
    for (std::size_t k = 0; k < 3; ++k) {
      sums.area[k] += face.area[k];
      for (std::size_t c = 0; c < 3; ++c) sums.moment[c][k] += face.area[k] * x[c];
    }
  }
  return sums;
}

inline double volume_of(const Body& body) {
  double sum = 0;
  for (LocalIndex i = 0; i < body.owned; ++i) sum += body.volume[static_cast<std::size_t>(i)];
  return sum;
}

/// Largest difference of the moments from volume times the unit tensor, over the volume.
inline double moment_error(const SurfaceSums& sums, double volume, int dimension = 3) {
  double largest = 0;
  for (int c = 0; c < dimension; ++c)
    for (int k = 0; k < dimension; ++k)
      largest = std::max(largest, std::abs(sums.moment[c][k] / volume - (c == k ? 1 : 0)));
  return largest;
}

/// A body whose particles stand for what of their cells is inside, as with quadrature: position-aware.
inline deck::Deck cut(decltype(deck::Shape::form) form, double spacing,
                      deck::Dimension dimension = deck::Dimension::three) {
  deck::Deck deck = deck_of(std::move(form), dimension, spacing);
  deck.body[0].cut_cells = true;
  return deck;
}

inline deck::Difference difference(std::vector<deck::Shape> parts) {
  deck::Difference whole;
  whole.parts = std::move(parts);
  return whole;
}
inline deck::Union union_of(std::vector<deck::Shape> parts) {
  deck::Union whole;
  whole.parts = std::move(parts);
  return whole;
}
inline deck::Shape box(const deck::Point& min, const deck::Point& max) { return shape_of(deck::Box{min, max}); }

}  // namespace perinox::body::fixture
