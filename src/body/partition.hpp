#pragma once
#include <vector>

#include "perinox/body/particles.hpp"
#include "perinox/core/communicator.hpp"

namespace perinox::body {

/// Zoltan2's geometric methods: recursive coordinate bisection, its variant that cuts into several slabs at once, and
/// runs of a Hilbert space-filling curve. perinox runs with the first; bench/partition.cpp compares them.
enum class PartitionMethod { rcb, multijagged, hsfc };

/// The rank each of this rank's particles should go to, by Zoltan2's recursive coordinate bisection: equal sums
/// of `weights`, each cut across the longest extent. weights: [particles] or empty for equal
/// ones. A rank may end up with none. Collective; the answer depends on the particles and the number of ranks only.
std::vector<int> partition(const std::vector<Particle>& particles, const std::vector<double>& weights, int dimension,
                           const Communicator& communicator);

/// The same for any number of parts, 0 .. parts-1, by any of the methods: any number of ranks can cut for any other.
std::vector<int> partition(const std::vector<Particle>& particles, const std::vector<double>& weights, int dimension,
                           const Communicator& communicator, int parts, PartitionMethod method);

}  // namespace perinox::body
