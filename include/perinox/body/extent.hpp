#pragma once
#include <vector>

#include "perinox/body/body.hpp"

namespace perinox::body {

/// Diagonal of the bounding box of all particles before loading: length; 0 of a single one. Collective.
double diagonal(const Body& body);

/// The same for each of `count` parts. part: [owned or more] the part of each particle, from 0; a part without
/// particles has 0. Collective.
std::vector<double> diagonals(const Body& body, const std::vector<int>& part, int count);

}  // namespace perinox::body
