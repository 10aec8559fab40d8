#pragma once
#include <cmath>
#include <cstdint>
#include <vector>

#include "perinox/core/types.hpp"

namespace perinox::solve {

/// Largest eigenvalue of the symmetric tridiagonal matrix of Lanczos' method, the smallest one, and the residual of the
/// largest one's vector.
struct Ritz {
  double value = 0, least = 0, residual = 0;
};
/// side: [diagonal.size()], the last one that of the next vector.
Ritz largest_ritz(const std::vector<double>& diagonal, const std::vector<double>& side);

/// A number in (-1, 1) that depends on the particle alone, so that any number of ranks begins alike.
double scatter(GlobalId id, int component);

}  // namespace perinox::solve
