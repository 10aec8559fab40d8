#include "perinox/body/convexity.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace perinox::body {

namespace {

using deck::Point;

double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Point minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

[[noreturn]] void no_shape() { throw std::logic_error("a point cloud has no shape"); }

bool meets_box(const Point& min, const Point& max, const Point& center, double radius, int dimension) {
  double square = 0;
  for (std::size_t c = 0; c < static_cast<std::size_t>(dimension); ++c) {
    const double beyond = std::max({min[c] - center[c], center[c] - max[c], 0.0});
    square += beyond * beyond;
  }
  return square <= radius * radius;
}

/// True if the ball may reach into the round hole of a plate. The hole is as deep as the plate.
bool meets_hole(const deck::PlateWithHole& plate, const Point& center, double radius) {
  return std::hypot(center[0] - plate.center[0], center[1] - plate.center[1]) <= plate.radius + radius;
}

struct Meets {
  const Point& center;
  double radius;
  int dimension;
  bool operator()(const deck::Box& box) const { return meets_box(box.min, box.max, center, radius, dimension); }
  bool operator()(const deck::Cylinder& cylinder) const {
    const Point axis = minus(cylinder.end, cylinder.start), to = minus(center, cylinder.start);
    const double length = std::sqrt(dot(axis, axis)), along = dot(to, axis) / length;
    const double across = std::sqrt(std::max(0.0, dot(to, to) - along * along));
    return across <= cylinder.radius + radius && along >= -radius && along <= length + radius;
  }
  bool operator()(const deck::Sphere& sphere) const {
    Point to = minus(center, sphere.center);
    if (dimension == 2) to[2] = 0;
    return std::sqrt(dot(to, to)) <= sphere.radius + radius;
  }
  bool operator()(const deck::PlateWithHole& plate) const {
    return meets_box(plate.min, plate.max, center, radius, dimension);
  }
  bool operator()(const deck::Union& whole) const {
    return std::any_of(whole.parts.begin(), whole.parts.end(),
                       [&](const deck::Shape& part) { return meets(part, center, radius, dimension); });
  }
  bool operator()(const deck::Difference& whole) const { return meets(whole.parts.at(0), center, radius, dimension); }
  bool operator()(const deck::CloudFile&) const { no_shape(); }
};

struct ConvexWithin {
  const Point& center;
  double radius;
  int dimension;
  bool operator()(const deck::Box&) const { return true; }
  bool operator()(const deck::Cylinder&) const { return true; }
  bool operator()(const deck::Sphere&) const { return true; }
  bool operator()(const deck::PlateWithHole& plate) const { return !meets_hole(plate, center, radius); }
  bool operator()(const deck::Union& whole) const {
    const deck::Shape* only = nullptr;
    for (const deck::Shape& part : whole.parts) {
      if (!meets(part, center, radius, dimension)) continue;
      if (only) return false;
      only = &part;
    }
    return !only || convex_within(*only, center, radius, dimension);
  }
  bool operator()(const deck::Difference& whole) const {
    return convex_within(whole.parts.at(0), center, radius, dimension) &&
           std::none_of(whole.parts.begin() + 1, whole.parts.end(),
                        [&](const deck::Shape& part) { return meets(part, center, radius, dimension); });
  }
  bool operator()(const deck::CloudFile&) const { no_shape(); }
};

}  // namespace

bool meets(const deck::Shape& shape, const Point& center, double radius, int dimension) {
  return std::visit(Meets{center, radius, dimension}, shape.form);
}

bool convex_within(const deck::Shape& shape, const Point& center, double radius, int dimension) {
  return std::visit(ConvexWithin{center, radius, dimension}, shape.form);
}

}  // namespace perinox::body
