#pragma once
#include <vector>

#include "perinox/body/particles.hpp"
#include "perinox/core/communicator.hpp"

namespace perinox::body {

/// The rank each of this rank's particles should go to, by Zoltan2's recursive coordinate bisection: equal sums
/// of `weights`, each cut across the longest extent. weights: [particles] or empty for equal
/// ones. A rank may end up with none. Collective; the answer depends on the particles and the number of ranks only.
std::vector<int> partition(const std::vector<Particle>& particles, const std::vector<double>& weights, int dimension,
                           const Communicator& communicator);

}  // namespace perinox::body
