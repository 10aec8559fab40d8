#include "curves.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <complex>

#include "perinox/body/shape_intervals.hpp"
#include "vectors.hpp"

namespace perinox::body {

namespace {

constexpr double pi = 3.14159265358979323846;

/// The function a + b cos s + c sin s + d cos 2s + e sin 2s.
struct Wave {
  double a, b, c, d = 0, e = 0;
  double operator()(double s) const {
    return a + b * std::cos(s) + c * std::sin(s) + d * std::cos(2 * s) + e * std::sin(2 * s);
  }
  double slope(double s) const {
    return c * std::cos(s) - b * std::sin(s) + 2 * e * std::cos(2 * s) - 2 * d * std::sin(2 * s);
  }
};

std::vector<double> zeros_of_first_order(const Wave& wave) {
  const double size = std::hypot(wave.b, wave.c);
  if (!(std::abs(wave.a) < size)) return {};
  const double top = std::atan2(wave.c, wave.b), half = std::acos(-wave.a / size);
  return {std::remainder(top - half, 2 * pi), std::remainder(top + half, 2 * pi)};
}

/// The zeros of a wave. It is a polynomial of fourth degree in exp(i s), whose zeros on the unit circle are wanted.
std::vector<double> zeros(const Wave& wave) {
  using Complex = std::complex<double>;
  const double scale = std::max({std::abs(wave.a), std::abs(wave.b), std::abs(wave.c)});
  if (std::hypot(wave.d, wave.e) <= 1e-13 * scale) return zeros_of_first_order(wave);
  const Complex second(wave.d, -wave.e), first(wave.b, -wave.c);
  const std::array<Complex, 4> lower{std::conj(second), std::conj(first), 2 * wave.a, first};
  Eigen::Matrix4cd companion = Eigen::Matrix4cd::Zero();
  for (Eigen::Index k = 0; k < 4; ++k) companion(k, 3) = -lower[static_cast<std::size_t>(k)] / second;
  for (Eigen::Index k = 0; k < 3; ++k) companion(k + 1, k) = 1;
  const Eigen::Vector4cd roots = Eigen::ComplexEigenSolver<Eigen::Matrix4cd>(companion, false).eigenvalues();
  std::vector<double> found;
  for (const Complex& root : roots) {
    if (std::abs(std::log(std::abs(root))) > 1e-5) continue;  // two that nearly meet stray by the root of the rounding
    double s = std::arg(root);
    for (int pass = 0; pass < 3; ++pass)
      if (const double slope = wave.slope(s); std::abs(wave(s)) < 1e-3 * std::abs(slope)) s -= wave(s) / slope;
    found.push_back(std::remainder(s, 2 * pi));
  }
  return found;
}

/// The intervals in which the wave is at most 0.
Intervals below(const Wave& wave) {
  std::vector<double> ends = zeros(wave);
  ends.push_back(-pi);
  ends.push_back(pi);
  std::sort(ends.begin(), ends.end());
  Intervals found;
  for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
    // A zero that is only touched may lie between. The value where the wave is largest tells its sign.
    double value = 0;
    for (const double share : {0.29, 0.5, 0.77}) {
      const double one = wave(ends[k] + share * (ends[k + 1] - ends[k]));
      if (std::abs(one) >= std::abs(value)) value = one;
    }
    if (!(value <= 0)) continue;
    if (!found.empty() && found.back().second == ends[k])
      found.back().second = ends[k + 1];
    else
      found.emplace_back(ends[k], ends[k + 1]);
  }
  return found;
}

}  // namespace

Intervals Line::within(const Surface& surface) const {
  const auto [begin, end] = interval_inside(surface, at, direction, 0);
  const double from = std::max(begin, lo), to = std::min(end, hi);
  if (!(from < to)) return {};
  return {{from, to}};
}

Intervals Circle::whole() const { return {{-pi, pi}}; }

Intervals Circle::within(const Surface& surface) const {
  const Point away = minus(center, surface.at);
  const double square = surface.radius * surface.radius;
  if (surface.kind == Surface::Kind::plane)
    return below(
        {dot(away, surface.direction), radius * dot(u, surface.direction), radius * dot(v, surface.direction)});
  if (surface.kind == Surface::Kind::ball)
    return below({dot(away, away) + radius * radius - square, 2 * radius * dot(away, u), 2 * radius * dot(away, v)});
  const Point a = across(away, surface.direction);
  const Point b = times(radius, across(u, surface.direction)), c = times(radius, across(v, surface.direction));
  return below({dot(a, a) - square + (dot(b, b) + dot(c, c)) / 2, 2 * dot(a, b), 2 * dot(a, c),
                (dot(b, b) - dot(c, c)) / 2, dot(b, c)});
}

}  // namespace perinox::body
