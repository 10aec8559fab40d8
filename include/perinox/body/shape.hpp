#pragma once
#include "perinox/body/solid.hpp"
#include "perinox/deck/deck.hpp"

namespace perinox::body {

/// Smallest box along the axes around a shape. Lengths.
struct Bounds {
  deck::Point min, max;
};

/// Bounding box of a shape; for a difference it is that of its first part. In 2-D the z entries mean nothing. Throws
/// std::logic_error for a point cloud, which has no shape.
Bounds bounds(const deck::Shape& shape);

/// Largest absolute coordinate of the box; in dimension 2 only x and y count.
double largest_coordinate(const Bounds& box, int dimension);

/// True if the point is inside the shape or on its surface (within the surface's slack, so that rounding cannot make a
/// symmetric lattice lopsided). What a difference or a hole takes away includes the surface of the part taken away. In
/// dimension 2 z is ignored. Throws std::logic_error for a point cloud.
bool contains(const deck::Shape& shape, const deck::Point& point, int dimension);
/// Answers the same question for a shape made ready by solid_of, for many points. In 2-D z must be 0.
bool contains(const Solid& solid, const deck::Point& point);

}  // namespace perinox::body
