#pragma once
/// A shape as surfaces: a tree of unions, intersections and differences. Its leaves are convex, each the common part of
/// half-spaces, balls and endless cylinders (tubes).
#include <vector>

#include "perinox/deck/deck.hpp"

namespace perinox::body {

/// A plane, a sphere or the mantle of an endless cylinder, with the side of it that is inside.
struct Surface {
  enum class Kind { plane, ball, tube };
  Kind kind = Kind::plane;
  deck::Point at{};         ///< a point of the plane, the centre of the ball, a point of the tube's axis; length
  deck::Point direction{};  ///< unit: outward normal of a plane, axis of a tube
  double radius = 0;        ///< length; 0 for a plane
  double slack = 0;  ///< distance that counts as touching: 1e-10 of the leaf's size and the rounding of its place
};

/// A node of the tree.
struct Solid {
  enum class Kind { convex, unite, intersect, subtract };
  Kind kind = Kind::convex;
  std::vector<Surface> surfaces{};  ///< surfaces of a leaf
  std::vector<Solid> parts{};       ///< parts of any other node; `subtract` takes all others from the first
};

/// The solid of a shape. In dimension 2 it is the section at z = 0: a disc is a ball and a tube runs along z, with
/// their centres at z = 0. Throws std::logic_error for a point cloud, and in 2-D for a cylinder that lies askew to the
/// plane.
Solid solid_of(const deck::Shape& shape, int dimension);

/// Signed distance of a point from the surface, length. It is above 0 outside and below 0 inside.
double distance(const Surface& surface, const deck::Point& point);

}  // namespace perinox::body
