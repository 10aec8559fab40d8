#pragma once
#include <functional>
#include <vector>

#include "perinox/core/communicator.hpp"
#include "perinox/core/types.hpp"

namespace perinox::linear {

/// What Lanczos' method knows of a symmetric operator's largest eigenvalue.
struct Ritz {
  double value = 0;     ///< largest Ritz value: a bound from below
  double least = 0;     ///< smallest Ritz value: a bound of the smallest eigenvalue from above
  double residual = 0;  ///< of the largest one's vector: an eigenvalue is that near to `value`
};

/// Lanczos' method stops after `most_products`, or where the residual has come down to `accuracy` times the value.
struct LanczosSettings {
  int most_products = 80;
  double accuracy = 0.01;
};

/// y = A x on the owned unknowns: [unknowns] each.
using LinearMap = std::function<void(const std::vector<double>& x, std::vector<double>& y)>;

/// The largest eigenvalue of A M in the scalar product of M. A is symmetric, M symmetric and positive definite; without
/// M it is the identity. start: [unknowns], zero where an unknown does not take part; a start of length zero gives a
/// Ritz of zeros. Collective.
Ritz largest_eigenvalue(const Communicator& ranks, const std::vector<double>& start, const LinearMap& a,
                        const LinearMap& m, const LanczosSettings& settings);

/// A number in (-1, 1) that depends on the particle and the component alone, so that any number of ranks starts alike.
double scatter(GlobalId id, int component);

}  // namespace perinox::linear
