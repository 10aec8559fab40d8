#pragma once
#include "perinox/deck/deck.hpp"

namespace perinox::body {

/// Questions about a shape within a ball (2-D: a disc) around a center. Both answers are on the safe side.

/// False only if no point of the shape lies within the ball. Throws std::logic_error for a point cloud.
bool meets(const deck::Shape& shape, const deck::Point& center, double radius, int dimension);

/// True only if the straight line between any two points of the shape within the ball stays inside the shape. This is
/// so everywhere in a box, a cylinder and a ball. In other shapes it is so away from what is taken away and from the
/// seams of unions. Throws std::logic_error for a point cloud.
bool convex_within(const deck::Shape& shape, const deck::Point& center, double radius, int dimension);

}  // namespace perinox::body
