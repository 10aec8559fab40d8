#pragma once
#include <vector>

#include "perinox/body/body.hpp"

namespace perinox::body {

/// Diagonal of the bounding box of all particles before loading, length. It is 0 for a single particle. Collective.
double diagonal(const Body& body);

/// Diagonal of the bounding box of each of `count` parts, length. part: [owned or more] the part of each particle, from
/// 0. A part without particles has 0. Collective.
std::vector<double> diagonals(const Body& body, const std::vector<int>& part, int count);

}  // namespace perinox::body
