#include "surface_integrals.hpp"

#include <algorithm>
#include <cmath>

#include "vectors.hpp"

namespace perinox::body {

namespace {

/// Adds dA times 1, x, n and x n at x.
void add(SurfaceIntegrals& sum, double area, const Point& x, const Point& n) {
  sum.area += area;
  for (std::size_t c = 0; c < 3; ++c) {
    sum.first[c] += area * x[c];
    sum.normal[c] += area * n[c];
    for (std::size_t k = 0; k < 3; ++k) sum.moment[c][k] += area * x[c] * n[k];
  }
}

}  // namespace

void SurfaceIntegrals::operator+=(const SurfaceIntegrals& other) {
  area += other.area;
  for (std::size_t c = 0; c < 3; ++c) {
    first[c] += other.first[c];
    normal[c] += other.normal[c];
    for (std::size_t k = 0; k < 3; ++k) moment[c][k] += other.moment[c][k];
  }
}

double SurfaceIntegrals::difference(const SurfaceIntegrals& other) const {
  double largest = std::abs(area - other.area);
  for (std::size_t c = 0; c < 3; ++c) largest = std::max(largest, std::abs(normal[c] - other.normal[c]));
  return largest;
}

void add_line(SurfaceIntegrals& sum, const Intervals& pieces, const Line& line, double width, const Point& n) {
  // x is linear along the line and n does not change, so the mean x is enough.
  for (const auto& [from, to] : pieces)
    add(sum, width * (to - from), along(line.at, (from + to) / 2, line.direction), n);
}

void add_arc(SurfaceIntegrals& sum, const Intervals& pieces, const Circle& circle, double rise, const Point& e,
             const Surface& ball, int side, double width) {
  // The unit normal is rise e + reach (cos s u + sin s v).
  const double reach = circle.radius / ball.radius;
  const Point& center = ball.at;
  for (const auto& [from, to] : pieces) {
    const double length = to - from, c = std::sin(to) - std::sin(from), s = std::cos(from) - std::cos(to);
    const double cc = length / 2 + (std::sin(2 * to) - std::sin(2 * from)) / 4;
    const double sc = (std::cos(2 * from) - std::cos(2 * to)) / 4;
    Point n = times(rise * length, e);
    n = along(along(n, reach * c, circle.u), reach * s, circle.v);
    sum.area += width * length;
    const double second[3][3] = {{reach * reach * cc, reach * reach * sc, rise * reach * c},
                                 {reach * reach * sc, reach * reach * (length - cc), rise * reach * s},
                                 {rise * reach * c, rise * reach * s, rise * rise * length}};
    const Point* frame[3] = {&circle.u, &circle.v, &e};
    for (std::size_t a = 0; a < 3; ++a) {
      sum.first[a] += width * (center[a] * length + ball.radius * n[a]);
      sum.normal[a] += width * side * n[a];
      for (std::size_t b = 0; b < 3; ++b) {
        double both = 0;  // integral of n_a n_b
        for (std::size_t i = 0; i < 3; ++i)
          for (std::size_t j = 0; j < 3; ++j) both += second[i][j] * (*frame[i])[a] * (*frame[j])[b];
        sum.moment[a][b] += width * side * (center[a] * n[b] + ball.radius * both);
      }
    }
  }
}

}  // namespace perinox::body
