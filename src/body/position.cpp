#include <cmath>
#include <limits>

#include "perinox/body/body.hpp"
#include "perinox/body/spacing.hpp"

namespace perinox::body {

deck::Point Body::position3(LocalIndex i) const {
  const double* x = position(i);
  return {x[0], x[1], dimension == 3 ? x[2] : 0.0};
}

double Body::spacing_of(LocalIndex i) const {
  const auto p = static_cast<std::size_t>(part[static_cast<std::size_t>(i)]);
  const double lattice = p < lattice_spacing.size() ? lattice_spacing[p] : 0;
  return lattice > 0 ? lattice : edge_of(volume[static_cast<std::size_t>(i)], dimension);
}

double Body::rounding(LocalIndex i) const {
  double size = 0;
  for (int c = 0; c < dimension; ++c) size += std::abs(position(i)[c]);
  return 4 * std::numeric_limits<double>::epsilon() * size;
}

}  // namespace perinox::body
