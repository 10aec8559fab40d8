#pragma once
#include <vector>

#include "perinox/core/communicator.hpp"
#include "perinox/core/types.hpp"
#include "perinox/deck/deck.hpp"

namespace perinox::body {

/// One particle on its way to the rank that will own it. It travels between ranks as plain bytes.
struct Particle {
  GlobalId id;
  deck::Point position;  ///< z = 0 in 2-D
  double volume;         ///< 2-D: area
  int part;              ///< index into deck.body
  int neighbors = 0;     ///< number of particles within reach, once they have been counted
};

/// Sends particles to other ranks: particles[send[r][k]] go to rank r. Returns what this rank receives, in ascending
/// id. send: [ranks][any]. Collective.
std::vector<Particle> exchange(const std::vector<Particle>& particles, const std::vector<std::vector<LocalIndex>>& send,
                               const Communicator& communicator);

/// Moves every particle to the one rank named for it and returns what this rank receives. destination: [particles].
/// Collective.
std::vector<Particle> migrate(const std::vector<Particle>& particles, const std::vector<int>& destination,
                              const Communicator& communicator);

/// Coordinates of the particles one after another, [particles * dimension].
std::vector<double> coordinates(const std::vector<Particle>& particles, int dimension);

}  // namespace perinox::body
