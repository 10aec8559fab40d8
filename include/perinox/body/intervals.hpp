#pragma once
#include <utility>
#include <vector>

namespace perinox::body {

/// Closed intervals of a parameter, ascending and disjoint: first <= second.
using Intervals = std::vector<std::pair<double, double>>;

/// The parameters that lie in either. Intervals that touch become one.
Intervals unite(const Intervals& a, const Intervals& b);
/// The parameters that lie in both.
Intervals intersect(const Intervals& a, const Intervals& b);
/// The parameters that lie in `a` and not inside of `b`. The ends of b's intervals stay.
Intervals subtract(const Intervals& a, const Intervals& b);
/// Sum of the intervals' lengths.
double length(const Intervals& a);

}  // namespace perinox::body
