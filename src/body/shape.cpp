#include "perinox/body/shape.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "vectors.hpp"

namespace perinox::body {

namespace {

/// Bounding box of a cylinder. A disc of radius r across the unit direction n reaches r sqrt(1 - n_k^2) along axis k.
Bounds cylinder_bounds(const deck::Cylinder& cylinder) {
  const Point axis = minus(cylinder.end, cylinder.start);
  const double squared = dot(axis, axis);
  Bounds box{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double reach = cylinder.radius * std::sqrt(std::max(0.0, 1 - axis[k] * axis[k] / squared));
    box.min[k] = std::min(cylinder.start[k], cylinder.end[k]) - reach;
    box.max[k] = std::max(cylinder.start[k], cylinder.end[k]) + reach;
  }
  return box;
}

struct BoundsOf {
  Bounds operator()(const deck::Box& box) const { return {box.min, box.max}; }
  Bounds operator()(const deck::Cylinder& cylinder) const { return cylinder_bounds(cylinder); }
  Bounds operator()(const deck::Sphere& sphere) const {
    Bounds box{sphere.center, sphere.center};
    for (std::size_t k = 0; k < 3; ++k) box.min[k] -= sphere.radius, box.max[k] += sphere.radius;
    return box;
  }
  Bounds operator()(const deck::PlateWithHole& plate) const { return {plate.min, plate.max}; }
  Bounds operator()(const deck::Union& whole) const {
    Bounds box = bounds(whole.parts.at(0));
    for (const deck::Shape& part : whole.parts) {
      const Bounds other = bounds(part);
      for (std::size_t k = 0; k < 3; ++k) {
        box.min[k] = std::min(box.min[k], other.min[k]);
        box.max[k] = std::max(box.max[k], other.max[k]);
      }
    }
    return box;
  }
  Bounds operator()(const deck::Difference& whole) const { return bounds(whole.parts.at(0)); }
  Bounds operator()(const deck::CloudFile&) const { throw std::logic_error("a point cloud has no shape"); }
};

}  // namespace

Bounds bounds(const deck::Shape& shape) { return std::visit(BoundsOf{}, shape.form); }

double largest_coordinate(const Bounds& box, int dimension) {
  double largest = 0;
  for (std::size_t c = 0; c < static_cast<std::size_t>(dimension); ++c)
    largest = std::max({largest, std::abs(box.min[c]), std::abs(box.max[c])});
  return largest;
}

bool contains(const Solid& solid, const Point& point) {
  const auto holds = [&](const Solid& part) { return contains(part, point); };
  switch (solid.kind) {
    case Solid::Kind::convex:
      return std::all_of(solid.surfaces.begin(), solid.surfaces.end(),
                         [&](const Surface& surface) { return distance(surface, point) <= surface.slack; });
    case Solid::Kind::unite:
      return std::any_of(solid.parts.begin(), solid.parts.end(), holds);
    case Solid::Kind::intersect:
      return std::all_of(solid.parts.begin(), solid.parts.end(), holds);
    default:
      return holds(solid.parts.front()) && std::none_of(solid.parts.begin() + 1, solid.parts.end(), holds);
  }
}

bool contains(const deck::Shape& shape, const Point& point, int dimension) {
  return contains(solid_of(shape, dimension), {point[0], point[1], dimension == 3 ? point[2] : 0.0});
}

}  // namespace perinox::body
