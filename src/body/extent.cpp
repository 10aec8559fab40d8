#include "perinox/body/extent.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace perinox::body {

double diagonal(const Body& body) {
  return diagonals(body, std::vector<int>(static_cast<std::size_t>(body.owned), 0), 1).front();
}

std::vector<double> diagonals(const Body& body, const std::vector<int>& part, int count) {
  const auto parts = static_cast<std::size_t>(count);
  const auto d = static_cast<std::size_t>(body.dimension);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<double> high(parts * d, -infinity), low(parts * d, -infinity);  // low: with the other sign
  for (LocalIndex i = 0; i < body.owned; ++i)
    for (std::size_t c = 0; c < d; ++c) {
      const std::size_t k = static_cast<std::size_t>(part[i]) * d + c;
      const double x = body.position(i)[c];
      high[k] = std::max(high[k], x);
      low[k] = std::max(low[k], -x);
    }
  body.communicator.max(high);
  body.communicator.max(low);
  std::vector<double> diagonal(parts, 0.0);
  for (std::size_t k = 0; k < parts; ++k) {
    if (high[k * d] == -infinity) continue;
    double square = 0;
    for (std::size_t c = 0; c < d; ++c) square += std::pow(high[k * d + c] + low[k * d + c], 2);
    diagonal[k] = std::sqrt(square);
  }
  return diagonal;
}

}  // namespace perinox::body
