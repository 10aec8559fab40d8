#include "fit.hpp"

#include <algorithm>
#include <cmath>

namespace perinox::study {

std::optional<double> log_slope(const std::vector<Pair>& pairs) {
  double n = 0, mean_x = 0, mean_y = 0;
  const auto counts = [](const Pair& p) { return p.x > 0 && p.y > 0; };
  for (const Pair& p : pairs) {
    if (!counts(p)) continue;
    ++n;
    mean_x += std::log(p.x);
    mean_y += std::log(p.y);
  }
  if (n < 2) return std::nullopt;
  mean_x /= n;
  mean_y /= n;
  double xx = 0, xy = 0;
  for (const Pair& p : pairs) {
    if (!counts(p)) continue;
    xx += (std::log(p.x) - mean_x) * (std::log(p.x) - mean_x);
    xy += (std::log(p.x) - mean_x) * (std::log(p.y) - mean_y);
  }
  if (xx < 1e-24) return std::nullopt;
  return xy / xx;
}

std::vector<std::size_t> pareto_front(const std::vector<Pair>& points) {
  std::vector<std::size_t> front;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool beaten = std::any_of(points.begin(), points.end(), [&](const Pair& other) {
      return other.x <= points[i].x && other.y <= points[i].y && (other.x < points[i].x || other.y < points[i].y);
    });
    if (!beaten) front.push_back(i);
  }
  std::stable_sort(front.begin(), front.end(), [&](std::size_t a, std::size_t b) { return points[a].x < points[b].x; });
  return front;
}

std::optional<double> newton_order(std::vector<double> residuals) {
  constexpr double rounding = 1e-12;
  while (residuals.size() > 3 && residuals.back() < rounding * residuals.front()) residuals.pop_back();
  const std::size_t n = residuals.size();
  if (n < 3) return std::nullopt;
  const double first = residuals[n - 3], second = residuals[n - 2], third = residuals[n - 1];
  if (!(third > 0 && third < second && second < first)) return std::nullopt;
  return std::log(third / second) / std::log(second / first);
}

}  // namespace perinox::study
