#pragma once
/// The part of a straight line that lies inside a shape: exact for every surface, and intervals are combined as the
/// shapes are.
#include "perinox/body/intervals.hpp"
#include "perinox/body/solid.hpp"

namespace perinox::body {

/// Parameters 0..1 of the straight segment from `a` to `b` that lie inside of the shape or on its surface. Touching
/// counts as inside, within the surfaces' slack: what is taken away by a difference or a hole is taken without its
/// surface. An interval may be a single point. Where a and b are one point: {0, 1} or nothing. dimension 2: z is
/// ignored. Throws std::logic_error for a point cloud.
Intervals intervals_inside(const deck::Shape& shape, const deck::Point& a, const deck::Point& b, int dimension);
/// The same of a shape made ready by solid_of, for many segments; in 2-D the points have z = 0.
Intervals intervals_inside(const Solid& solid, const deck::Point& a, const deck::Point& b);

/// Length of the straight line from a to b that lies outside of the solid.
double length_outside(const Solid& solid, const deck::Point& a, const deck::Point& b);
/// Of the spacing: a gap that a straight line crosses in less than this is none. Bonds are made across it, surface
/// loads and volumes go across it.
constexpr double bridged_gap = 0.3;

/// Where the line a + t (b - a), t any number, is inside of one surface moved outwards by `slack` (a length, may be
/// below 0): all of the line, one interval, or none (first > second).
std::pair<double, double> interval_inside(const Surface& surface, const deck::Point& a, const deck::Point& direction,
                                          double slack);

}  // namespace perinox::body
