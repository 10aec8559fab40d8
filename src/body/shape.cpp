#include "perinox/body/shape.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace perinox::body {

namespace {

using deck::Point;
constexpr double kSurface = 1e-10;  ///< of the shape's size

Point minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
double norm(const Point& a) { return std::sqrt(dot(a, a)); }

bool inside_box(const Point& min, const Point& max, const Point& point, int dimension) {
  for (int axis = 0; axis < dimension; ++axis) {
    const double slack = kSurface * (max[axis] - min[axis]);
    if (point[axis] < min[axis] - slack || point[axis] > max[axis] + slack) return false;
  }
  return true;
}

bool inside_circle(const Point& center, double radius, const Point& point) {
  return std::hypot(point[0] - center[0], point[1] - center[1]) <= radius * (1 + kSurface);
}

bool inside_cylinder(const deck::Cylinder& cylinder, const Point& point) {
  const Point axis = minus(cylinder.end, cylinder.start);
  const Point to_point = minus(point, cylinder.start);
  const double along = dot(to_point, axis) / dot(axis, axis);
  if (along < -kSurface || along > 1 + kSurface) return false;
  const Point across = {to_point[0] - along * axis[0], to_point[1] - along * axis[1], to_point[2] - along * axis[2]};
  return norm(across) <= cylinder.radius * (1 + kSurface);
}

/// A disc of radius r across the unit direction n reaches r sqrt(1 - n_k^2) along axis k.
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

struct Contains {
  const Point& point;
  int dimension;
  bool operator()(const deck::Box& box) const { return inside_box(box.min, box.max, point, dimension); }
  bool operator()(const deck::Cylinder& cylinder) const { return inside_cylinder(cylinder, point); }
  bool operator()(const deck::Sphere& sphere) const {
    const Point away = minus(point, sphere.center);
    const double distance = dimension == 3 ? norm(away) : std::hypot(away[0], away[1]);
    return distance <= sphere.radius * (1 + kSurface);
  }
  bool operator()(const deck::PlateWithHole& plate) const {
    return inside_box(plate.min, plate.max, point, dimension) && !inside_circle(plate.center, plate.radius, point);
  }
  bool operator()(const deck::Union& whole) const {
    return std::any_of(whole.parts.begin(), whole.parts.end(),
                       [this](const deck::Shape& part) { return contains(part, point, dimension); });
  }
  bool operator()(const deck::Difference& whole) const {
    if (!contains(whole.parts.at(0), point, dimension)) return false;
    return std::none_of(whole.parts.begin() + 1, whole.parts.end(),
                        [this](const deck::Shape& part) { return contains(part, point, dimension); });
  }
  bool operator()(const deck::CloudFile&) const { throw std::logic_error("a point cloud has no shape"); }
};

}  // namespace

Bounds bounds(const deck::Shape& shape) { return std::visit(BoundsOf{}, shape.form); }

bool contains(const deck::Shape& shape, const Point& point, int dimension) {
  const Point flat = {point[0], point[1], dimension == 3 ? point[2] : 0.0};
  return std::visit(Contains{flat, dimension}, shape.form);
}

}  // namespace perinox::body
