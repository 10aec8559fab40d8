#include "perinox/body/solid.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "vectors.hpp"

namespace perinox::body {

namespace {

constexpr double touching = 1e-10;  // of a leaf's size

double largest(const Point& a) { return std::max({std::abs(a[0]), std::abs(a[1]), std::abs(a[2])}); }

/// Length to which the places of a shape of this size, at coordinates as large as these, are known.
double slack_of(double size, double coordinate) {
  return touching * size + 8 * std::numeric_limits<double>::epsilon() * (coordinate + size);
}

Surface plane(const Point& at, const Point& normal) { return {Surface::Kind::plane, at, normal, 0, 0}; }
Surface ball(const Point& center, double radius) { return {Surface::Kind::ball, center, {}, radius, 0}; }
Surface tube(const Point& at, const Point& axis, double radius) { return {Surface::Kind::tube, at, axis, radius, 0}; }

Solid leaf(std::vector<Surface> surfaces, double slack) {
  for (Surface& surface : surfaces) surface.slack = slack;
  return {Solid::Kind::convex, std::move(surfaces), {}};
}

struct SolidOf {
  int dimension;

  Point flat(const Point& a) const { return {a[0], a[1], dimension == 3 ? a[2] : 0}; }
  Solid box(const Point& min, const Point& max) const {
    std::vector<Surface> surfaces;
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension); ++axis)
      for (const int side : {-1, 1}) {
        Point normal{};
        normal[axis] = side;
        surfaces.push_back(plane(flat(side < 0 ? min : max), normal));
      }
    return leaf(std::move(surfaces), slack_of(largest(minus(flat(max), flat(min))), largest(flat(min))));
  }
  Solid disc(const Point& center, double radius) const {
    const Surface around = dimension == 3 ? tube(center, {0, 0, 1}, radius) : ball(flat(center), radius);
    return leaf({around}, slack_of(radius, largest(flat(center))));
  }

  Solid operator()(const deck::Box& form) const { return box(form.min, form.max); }
  Solid operator()(const deck::Sphere& sphere) const {
    return leaf({ball(flat(sphere.center), sphere.radius)}, slack_of(sphere.radius, largest(flat(sphere.center))));
  }
  Solid operator()(const deck::PlateWithHole& plate) const {
    return {Solid::Kind::subtract, {}, {box(plate.min, plate.max), disc(plate.center, plate.radius)}};
  }
  Solid operator()(const deck::Cylinder& cylinder) const {
    const Point axis = minus(cylinder.end, cylinder.start), n = unit(axis);
    const double slack = slack_of(std::max(norm(axis), 2 * cylinder.radius), largest(cylinder.start));
    if (dimension == 3)
      return leaf(
          {plane(cylinder.start, times(-1, n)), plane(cylinder.end, n), tube(cylinder.start, n, cylinder.radius)},
          slack);
    if (axis[0] == 0 && axis[1] == 0) return disc(cylinder.start, cylinder.radius);
    if (axis[2] != 0 || cylinder.start[2] != 0)
      throw std::logic_error("in 2-D a cylinder's axis lies in the plane or stands on it");
    const Point side{-n[1], n[0], 0};
    return leaf({plane(cylinder.start, times(-1, n)), plane(cylinder.end, n),
                 plane(along(cylinder.start, -cylinder.radius, side), times(-1, side)),
                 plane(along(cylinder.start, cylinder.radius, side), side)},
                slack);
  }
  Solid operator()(const deck::Union& whole) const { return {Solid::Kind::unite, {}, parts(whole.parts)}; }
  Solid operator()(const deck::Difference& whole) const { return {Solid::Kind::subtract, {}, parts(whole.parts)}; }
  Solid operator()(const deck::CloudFile&) const { throw std::logic_error("a point cloud has no shape"); }

  std::vector<Solid> parts(const std::vector<deck::Shape>& shapes) const {
    std::vector<Solid> solids;
    for (const deck::Shape& shape : shapes) solids.push_back(std::visit(*this, shape.form));
    return solids;
  }
};

}  // namespace

Solid solid_of(const deck::Shape& shape, int dimension) { return std::visit(SolidOf{dimension}, shape.form); }

double distance(const Surface& surface, const Point& point) {
  const Point away = minus(point, surface.at);
  switch (surface.kind) {
    case Surface::Kind::plane:
      return dot(away, surface.direction);
    case Surface::Kind::ball:
      return norm(away) - surface.radius;
    default:
      return norm(across(away, surface.direction)) - surface.radius;
  }
}

}  // namespace perinox::body
