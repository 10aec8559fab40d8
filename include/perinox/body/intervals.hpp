#pragma once
#include <utility>
#include <vector>

namespace perinox::body {

/// Closed intervals of a parameter, ascending and disjoint: first <= second.
using Intervals = std::vector<std::pair<double, double>>;

/// What lies in either; intervals that touch become one.
Intervals unite(const Intervals& a, const Intervals& b);
/// What lies in both.
Intervals intersect(const Intervals& a, const Intervals& b);
/// What lies in `a` and not inside of `b`; the ends of b's intervals stay.
Intervals subtract(const Intervals& a, const Intervals& b);
/// Sum of the lengths.
double length(const Intervals& a);

}  // namespace perinox::body
