#pragma once
#include <vector>

#include "perinox/body/particles.hpp"
#include "perinox/core/communicator.hpp"

namespace perinox::body {

/// The geometric methods of Zoltan2: recursive coordinate bisection, its variant that cuts into several slabs at once,
/// and runs of a Hilbert space-filling curve. perinox runs with the first one; bench/partition.cpp compares them.
enum class PartitionMethod { rcb, multijagged, hsfc };

/// The rank to which each of this rank's particles should go, by Zoltan2's recursive coordinate bisection: equal sums
/// of `weights`, each cut across the longest extent. weights: [particles], or empty for equal ones. A rank may end up
/// with no particle. Collective. The answer depends on the particles and the number of ranks only.
std::vector<int> partition(const std::vector<Particle>& particles, const std::vector<double>& weights, int dimension,
                           const Communicator& communicator);

/// The same partition for any number of parts, 0 .. parts-1, by any of the methods. Any number of ranks can cut for any
/// other number.
std::vector<int> partition(const std::vector<Particle>& particles, const std::vector<double>& weights, int dimension,
                           const Communicator& communicator, int parts, PartitionMethod method);

}  // namespace perinox::body
