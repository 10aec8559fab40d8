#pragma once
#include <optional>
#include <vector>

namespace perinox::study {

struct Pair {
  double x, y;
};

/// Slope of the straight line through log x, log y that has the least squared distance in log y. Pairs that are not
/// positive are left out. It is absent with fewer than two different x.
std::optional<double> log_slope(const std::vector<Pair>& pairs);

/// Numbers of the points that no other point beats: none has both x and y at most as large, and one of them smaller.
/// They are in the order of x.
std::vector<std::size_t> pareto_front(const std::vector<Pair>& points);

/// Order of convergence log(r2/r1)/log(r1/r0) of the last three residuals above 1e-12 of the first. It is absent if
/// there are no three that fall.
std::optional<double> newton_order(std::vector<double> residuals);

}  // namespace perinox::study
