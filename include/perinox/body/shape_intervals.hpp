#pragma once
/// The part of a straight line that lies inside a shape. It is exact for every surface; intervals are combined as the
/// shapes are.
#include "perinox/body/intervals.hpp"
#include "perinox/body/solid.hpp"

namespace perinox::body {

/// Parameters 0..1 of the straight segment from `a` to `b` that lie inside of the shape or on its surface. Touching
/// counts as inside, within the surfaces' slack; what a difference or a hole takes away is taken without its surface.
/// An interval may be a single point. Where a and b are one point the result is {0, 1} or empty. In dimension 2 z is
/// ignored. Throws std::logic_error for a point cloud.
Intervals intervals_inside(const deck::Shape& shape, const deck::Point& a, const deck::Point& b, int dimension);
/// The intervals for a shape made ready by solid_of, for many segments. In 2-D the points must have z = 0.
Intervals intervals_inside(const Solid& solid, const deck::Point& a, const deck::Point& b);

/// Length of the part of the straight segment from a to b that lies outside of the solid.
double length_outside(const Solid& solid, const deck::Point& a, const deck::Point& b);
/// Width in spacings below which a gap on a straight line counts as none. Bonds are made across such a gap, and surface
/// loads and volumes reach across it.
constexpr double bridged_gap = 0.3;

/// The interval of t in which the line a + t direction, t any number, is inside of one surface moved outwards by
/// `slack` (a length, may be below 0). It may be the whole line, and it is empty if first > second.
std::pair<double, double> interval_inside(const Surface& surface, const deck::Point& a, const deck::Point& direction,
                                          double slack);

}  // namespace perinox::body
