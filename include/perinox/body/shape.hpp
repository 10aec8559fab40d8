#pragma once
#include "perinox/deck/deck.hpp"

namespace perinox::body {

/// Smallest box along the axes around a shape. Length.
struct Bounds {
  deck::Point min, max;
};

/// Bounding box of a shape; of a difference: of its first part. In 2-D the z entries mean nothing.
/// Throws std::logic_error for a point cloud, which has no shape.
Bounds bounds(const deck::Shape& shape);

/// True where the point is inside the shape or on its surface (within 1e-10 of the shape's size, so that rounding
/// cannot make a symmetric lattice lopsided). What a difference or a hole takes away includes the surface of the part
/// taken away. dimension 2: z is ignored.
bool contains(const deck::Shape& shape, const deck::Point& point, int dimension);

}  // namespace perinox::body
