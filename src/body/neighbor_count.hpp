#pragma once
#include <vector>

namespace perinox::body {

/// Number of points within `reach` of each of the first `queries` points, itself not counted: [queries]. By cells of
/// about `reach`: a tenth of the cost of a tree, where only the number is wanted. points: [count * dimension].
std::vector<double> count_within(const std::vector<double>& points, int dimension, int queries, double reach);

}  // namespace perinox::body
