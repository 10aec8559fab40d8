#include "perinox/body/shape_intervals.hpp"

#include <algorithm>
#include <limits>

#include "combine.hpp"
#include "vectors.hpp"

namespace perinox::body {

namespace {

using Interval = std::pair<double, double>;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr Interval all{-infinity, infinity}, none{infinity, -infinity};

/// The interval of a line inside of a ball or tube. a: the line's first point from the centre, or from the axis and at
/// right angles to it. The direction is as for a.
Interval inside_round(const Point& a, const Point& direction, double radius) {
  if (radius < 0) return none;
  const double square = dot(direction, direction);
  if (square == 0) return norm(a) <= radius ? all : none;
  const double nearest = -dot(a, direction) / square;
  const double off = norm(along(a, nearest, direction));
  if (off > radius) return none;
  const double half = std::sqrt((radius - off) * (radius + off) / square);
  return {nearest - half, nearest + half};
}

}  // namespace

Interval interval_inside(const Surface& surface, const Point& a, const Point& direction, double slack) {
  const Point away = minus(a, surface.at);
  if (surface.kind == Surface::Kind::ball) return inside_round(away, direction, surface.radius + slack);
  if (surface.kind == Surface::Kind::tube) {
    // A direction along the axis has a part across it by rounding only.
    Point turned = across(direction, surface.direction);
    if (dot(turned, turned) < 1e-30 * dot(direction, direction)) turned = {};
    return inside_round(across(away, surface.direction), turned, surface.radius + slack);
  }
  const double begin = dot(away, surface.direction) - slack, slope = dot(direction, surface.direction);
  if (slope == 0) return begin <= 0 ? all : none;
  const double at = -begin / slope;
  return slope > 0 ? Interval{-infinity, at} : Interval{at, infinity};
}

Intervals intervals_inside(const Solid& solid, const Point& a, const Point& b) {
  const Point direction = minus(b, a);
  return combine(solid, [&](const Solid& leaf, bool removed) -> Intervals {
    Interval left{0, 1};
    for (const Surface& surface : leaf.surfaces) {
      const Interval one = interval_inside(surface, a, direction, removed ? -surface.slack : surface.slack);
      left = {std::max(left.first, one.first), std::min(left.second, one.second)};
      if (!(left.first <= left.second)) return {};
    }
    return {left};
  });
}

double length_outside(const Solid& solid, const Point& a, const Point& b) {
  return norm(minus(b, a)) * (1 - length(intervals_inside(solid, a, b)));
}

Intervals intervals_inside(const deck::Shape& shape, const Point& a, const Point& b, int dimension) {
  if (dimension == 3) return intervals_inside(solid_of(shape, 3), a, b);
  return intervals_inside(solid_of(shape, 2), {a[0], a[1], 0}, {b[0], b[1], 0});
}

}  // namespace perinox::body
