#pragma once
#include "perinox/deck/deck.hpp"

namespace perinox::body {

/// Balls (2-D: discs) of a radius around a center, against shapes; both answers err on the side of caution.

/// False only if no point of the shape lies within the ball. Throws std::logic_error for a point cloud.
bool meets(const deck::Shape& shape, const deck::Point& center, double radius, int dimension);

/// True only if the straight line between any two points of the shape within the ball stays inside the shape: so it is
/// everywhere in a box, a cylinder, a ball, and in the others away from what is taken away and from seams of unions.
/// Throws std::logic_error for a point cloud.
bool convex_within(const deck::Shape& shape, const deck::Point& center, double radius, int dimension);

}  // namespace perinox::body
