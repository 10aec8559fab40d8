#include "perinox/body/extent.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace perinox::body {

double diagonal(const Body& body) {
  double square = 0;
  for (int c = 0; c < body.dimension; ++c) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (LocalIndex i = 0; i < body.owned; ++i) {
      low = std::min(low, body.position(i)[c]);
      high = std::max(high, body.position(i)[c]);
    }
    const double length = body.communicator.max(high) - body.communicator.min(low);
    square += length * length;
  }
  return std::sqrt(square);
}

}  // namespace perinox::body
