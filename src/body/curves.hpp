#pragma once
/// Curves that lie in surfaces, and the parts of them that are inside of other surfaces.
#include "perinox/body/intervals.hpp"
#include "perinox/body/solid.hpp"

namespace perinox::body {

/// The straight line at + s direction, s from lo to hi. direction: a unit vector.
struct Line {
  deck::Point at, direction;
  double lo, hi;
  Intervals whole() const { return {{lo, hi}}; }
  Intervals within(const Surface& surface) const;
};

/// The circle center + radius (cos(s) u + sin(s) v), s from -pi to pi. u, v: unit vectors at right angles.
struct Circle {
  deck::Point center, u, v;
  double radius;
  Intervals whole() const;
  Intervals within(const Surface& surface) const;
};

}  // namespace perinox::body
