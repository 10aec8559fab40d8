#pragma once
#include <vector>

#include "perinox/body/particles.hpp"
#include "perinox/core/communicator.hpp"

namespace perinox::body {

/// Finds the ghosts: copies of the other ranks' particles that are within `reach` of one of `owned`, in ascending id.
/// Every rank sends each other rank what lies in its bounding box widened by `reach`; the receiver keeps what is truly
/// within reach. Collective.
std::vector<Particle> find_ghosts(const std::vector<Particle>& owned, double reach, int dimension,
                                  const Communicator& communicator);

}  // namespace perinox::body
