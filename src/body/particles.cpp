#include "perinox/body/particles.hpp"

#include <algorithm>
#include <numeric>
#include <type_traits>

namespace perinox::body {

static_assert(std::is_trivially_copyable_v<Particle>, "particles travel as bytes");

std::vector<Particle> exchange(const std::vector<Particle>& particles, const std::vector<std::vector<LocalIndex>>& send,
                               const Communicator& communicator) {
  const auto ranks = static_cast<std::size_t>(communicator.size());
  std::vector<int> send_counts(ranks), send_starts(ranks), receive_counts(ranks), receive_starts(ranks);
  std::vector<Particle> outgoing;
  for (std::size_t rank = 0; rank < ranks; ++rank) {
    send_starts[rank] = static_cast<int>(outgoing.size());
    send_counts[rank] = static_cast<int>(send[rank].size());
    for (const LocalIndex i : send[rank]) outgoing.push_back(particles[i]);
  }
  MPI_Alltoall(send_counts.data(), 1, MPI_INT, receive_counts.data(), 1, MPI_INT, communicator.mpi());
  std::exclusive_scan(receive_counts.begin(), receive_counts.end(), receive_starts.begin(), 0);
  std::vector<Particle> incoming(static_cast<std::size_t>(receive_starts.back() + receive_counts.back()));

  // An MPI type of its own keeps the counts in particles. Counts in bytes would pass 2^31 at some 45 million particles.
  MPI_Datatype type;
  MPI_Type_contiguous(static_cast<int>(sizeof(Particle)), MPI_BYTE, &type);
  MPI_Type_commit(&type);
  MPI_Alltoallv(outgoing.data(), send_counts.data(), send_starts.data(), type, incoming.data(), receive_counts.data(),
                receive_starts.data(), type, communicator.mpi());
  MPI_Type_free(&type);
  std::sort(incoming.begin(), incoming.end(), [](const Particle& a, const Particle& b) { return a.id < b.id; });
  return incoming;
}

std::vector<Particle> migrate(const std::vector<Particle>& particles, const std::vector<int>& destination,
                              const Communicator& communicator) {
  std::vector<std::vector<LocalIndex>> send(static_cast<std::size_t>(communicator.size()));
  for (std::size_t i = 0; i < particles.size(); ++i) send[destination[i]].push_back(static_cast<LocalIndex>(i));
  return exchange(particles, send, communicator);
}

std::vector<double> coordinates(const std::vector<Particle>& particles, int dimension) {
  std::vector<double> points;
  points.reserve(particles.size() * static_cast<std::size_t>(dimension));
  for (const Particle& particle : particles) {
    points.insert(points.end(), particle.position.begin(), particle.position.begin() + dimension);
  }
  return points;
}

}  // namespace perinox::body
