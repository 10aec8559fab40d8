#pragma once
#include <vector>

#include "perinox/core/types.hpp"

namespace perinox::body {

/// For each of the first `queries` points: all points (except itself) within `radius` of it, in ascending order of local
/// index. points: [count * dimension]. One k-d tree (nanoflann), O(count log count).
std::vector<std::vector<LocalIndex>> neighbors_within(const std::vector<double>& points, int dimension, int queries,
                                                      double radius);

}  // namespace perinox::body
