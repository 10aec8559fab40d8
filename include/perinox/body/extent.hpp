#pragma once
#include "perinox/body/body.hpp"

namespace perinox::body {

/// Diagonal of the bounding box of all particles before loading: length; 0 of a single one. Collective.
double diagonal(const Body& body);

}  // namespace perinox::body
