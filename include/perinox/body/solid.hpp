#pragma once
/// A shape as surfaces: a tree of unions, intersections and differences whose leaves are convex, each the common part
/// of half-spaces, balls and endless cylinders (tubes).
#include <vector>

#include "perinox/deck/deck.hpp"

namespace perinox::body {

/// A plane, a sphere or the mantle of an endless cylinder, with the side of it that is inside.
struct Surface {
  enum class Kind { plane, ball, tube };
  Kind kind = Kind::plane;
  deck::Point at{};         ///< a point of the plane, the centre, a point of the axis: length
  deck::Point direction{};  ///< unit: outward normal of a plane, axis of a tube
  double radius = 0;        ///< length; of a plane 0
  double slack = 0;         ///< length: what counts as touching, 1e-10 of the leaf's size and the rounding of its place
};

struct Solid {
  enum class Kind { convex, unite, intersect, subtract };
  Kind kind = Kind::convex;
  std::vector<Surface> surfaces{};  ///< of a leaf
  std::vector<Solid> parts{};       ///< of all others; `subtract` takes all others from the first
};

/// dimension 2: the section at z = 0, with a disc as a ball, a tube along z, whose centre has z = 0. Throws
/// std::logic_error for a point cloud, and in 2-D for a cylinder that lies askew to the plane.
Solid solid_of(const deck::Shape& shape, int dimension);

/// Above 0 outside and below 0 inside, a length: the distance from the surface, with sign.
double distance(const Surface& surface, const deck::Point& point);

}  // namespace perinox::body
