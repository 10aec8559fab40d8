#include "ghosts.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "perinox/body/neighbor_search.hpp"

namespace perinox::body {

namespace {

constexpr double kTie = 1e-10;  ///< as in NeighborSearch: a particle at exactly the reach is within it

/// Bounding boxes (min x, y, z, max x, y, z) of every rank's particles. Nothing is inside the box of an empty rank.
std::vector<std::array<double, 6>> bounding_boxes(const std::vector<Particle>& owned, double reach,
                                                  const Communicator& communicator) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  std::array<double, 6> mine{infinite, infinite, infinite, -infinite, -infinite, -infinite};
  for (const Particle& particle : owned) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      mine[axis] = std::min(mine[axis], particle.position[axis] - reach);
      mine[axis + 3] = std::max(mine[axis + 3], particle.position[axis] + reach);
    }
  }
  std::vector<std::array<double, 6>> all(static_cast<std::size_t>(communicator.size()));
  MPI_Allgather(mine.data(), 6, MPI_DOUBLE, all.data(), 6, MPI_DOUBLE, communicator.mpi());
  return all;
}

bool inside(const std::array<double, 6>& box, const deck::Point& point) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (point[axis] < box[axis] || point[axis] > box[axis + 3]) return false;
  }
  return true;
}

}  // namespace

std::vector<Particle> find_ghosts(const std::vector<Particle>& owned, double reach, int dimension,
                                  const Communicator& communicator) {
  if (communicator.size() == 1) return {};
  const auto boxes = bounding_boxes(owned, reach * (1 + 10 * kTie), communicator);
  std::vector<std::vector<LocalIndex>> send(boxes.size());
  for (int rank = 0; rank < communicator.size(); ++rank) {
    if (rank == communicator.rank()) continue;
    for (std::size_t i = 0; i < owned.size(); ++i) {
      if (inside(boxes[rank], owned[i].position)) send[rank].push_back(static_cast<LocalIndex>(i));
    }
  }
  std::vector<Particle> candidates = exchange(owned, send, communicator);

  const std::vector<double> points = coordinates(owned, dimension);
  const NeighborSearch search(points, dimension);
  const auto too_far = [&](const Particle& candidate) {
    double distance = 0;
    return search.nearest(candidate.position.data(), distance) < 0 || distance > reach * (1 + kTie);
  };
  candidates.erase(std::remove_if(candidates.begin(), candidates.end(), too_far), candidates.end());
  return candidates;
}

}  // namespace perinox::body
