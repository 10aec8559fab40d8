/// How well Zoltan2's geometric methods cut a cube: imbalance, ghosts and messages a part, and what they cost a
/// product.
///     bench_partition [EDGE] [PARTS ...]      default 256 and 64 512 4096; one rank; about 400 bytes a particle
/// Prints the tables of docs/partition.md.
#include "body/partition.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <Tpetra_Core.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <numeric>

namespace {

using namespace perinox;

constexpr double horizon = 3.015;  // of the spacing, which is 1
constexpr int reach = 3;

// The projection's assumptions: the product of docs/performance.md, and a network of ordinary make.
constexpr double seconds_a_bond = 10.3e-9;
constexpr double latency = 2e-6;   // of a message, s
constexpr double bandwidth = 5e9;  // of a rank, bytes/s

struct Offset {
  int x, y, z;
};

std::vector<Offset> family() {
  std::vector<Offset> all;
  for (int z = -reach; z <= reach; ++z)
    for (int y = -reach; y <= reach; ++y)
      for (int x = -reach; x <= reach; ++x)
        if ((x || y || z) && x * x + y * y + z * z <= horizon * horizon) all.push_back({x, y, z});
  return all;
}

/// A cube of edge^3 lattice particles, and the family size of each.
struct Cube {
  int edge;
  std::vector<Offset> offsets = family();
  std::vector<body::Particle> particles;
  std::vector<double> sizes;

  bool inside(int x, int y, int z) const { return x >= 0 && y >= 0 && z >= 0 && x < edge && y < edge && z < edge; }
  std::size_t index(int x, int y, int z) const {
    return (static_cast<std::size_t>(z) * static_cast<std::size_t>(edge) + static_cast<std::size_t>(y)) *
               static_cast<std::size_t>(edge) +
           static_cast<std::size_t>(x);
  }
  template <class Visit>
  void each(Visit&& visit) const {
    for (int z = 0; z < edge; ++z)
      for (int y = 0; y < edge; ++y)
        for (int x = 0; x < edge; ++x) visit(x, y, z);
  }
  bool deep(int x, int y, int z) const { return std::min({x, y, z}) >= reach && std::max({x, y, z}) < edge - reach; }

  explicit Cube(int along) : edge(along) {
    const auto count = index(0, 0, edge);
    particles.reserve(count);
    sizes.reserve(count);
    each([&](int x, int y, int z) {
      const auto id = static_cast<GlobalId>(particles.size());
      particles.push_back({id, {x + 0.5, y + 0.5, z + 0.5}, 1.0, 0});
      sizes.push_back(static_cast<double>(deep(x, y, z) ? offsets.size()
                                                        : std::count_if(offsets.begin(), offsets.end(), [&](Offset o) {
                                                            return inside(x + o.x, y + o.y, z + o.z);
                                                          })));
    });
  }
};

struct Spread {
  double mean = 0, max = 0;
};
template <class Values>
Spread spread(const Values& values) {
  Spread s;
  for (const auto value : values) {
    s.mean += static_cast<double>(value) / static_cast<double>(values.size());
    s.max = std::max(s.max, static_cast<double>(value));
  }
  return s;
}

struct Quality {
  Spread particles, bonds, ghosts, neighbors;
};

Quality quality(const Cube& cube, const std::vector<int>& part_of, int parts) {
  const auto count = static_cast<std::size_t>(parts);
  std::vector<double> particles(count), bonds(count), ghosts(count);
  std::vector<std::vector<int>> neighbors(count);  // sorted
  std::vector<int> others;
  cube.each([&](int x, int y, int z) {
    const std::size_t i = cube.index(x, y, z);
    const int own = part_of[i];
    particles[own] += 1;
    bonds[own] += cube.sizes[i];
    others.clear();
    const bool deep = cube.deep(x, y, z);
    for (const Offset& o : cube.offsets) {
      if (!deep && !cube.inside(x + o.x, y + o.y, z + o.z)) continue;
      const int other = part_of[cube.index(x + o.x, y + o.y, z + o.z)];
      if (other != own && std::find(others.begin(), others.end(), other) == others.end()) others.push_back(other);
    }
    for (const int other : others) {  // the particle is a ghost there
      ghosts[other] += 1;
      const auto place = std::lower_bound(neighbors[own].begin(), neighbors[own].end(), other);
      if (place == neighbors[own].end() || *place != other) neighbors[own].insert(place, other);
    }
  });
  std::vector<std::size_t> messages;
  for (const auto& some : neighbors) messages.push_back(some.size());
  return {spread(particles), spread(bonds), spread(ghosts), spread(messages)};
}

const char* name_of(body::PartitionMethod method) {
  return method == body::PartitionMethod::rcb ? "rcb" : method == body::PartitionMethod::hsfc ? "hsfc" : "multijagged";
}

/// One product and what conjugate gradients add to it on `ranks` ranks, s: slowest part, no overlap of the two.
struct Iteration {
  double product, halo, reductions;
};
Iteration iteration(const Quality& q, double ranks) {
  const double bytes = 2 * 3 * 8 * q.ghosts.max;  // forward and back
  return {q.bonds.max * seconds_a_bond, 2 * q.neighbors.max * latency + bytes / bandwidth,
          3 * 2 * std::ceil(std::log2(ranks)) * latency};
}

double gigabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1e6;
}

}  // namespace

int main(int argc, char** argv) {
  const Tpetra::ScopeGuard guard(&argc, &argv);
  const Communicator ranks;
  const int edge = argc > 1 ? std::atoi(argv[1]) : 256;
  std::vector<int> cuts{64, 512, 4096};
  if (argc > 2) cuts.clear();
  for (int k = 2; k < argc; ++k) cuts.push_back(std::atoi(argv[k]));
  if (ranks.size() > 1 || edge < 1 || std::any_of(cuts.begin(), cuts.end(), [](int parts) { return parts < 1; })) {
    fmt::print(stderr, "usage, on one rank: bench_partition [EDGE] [PARTS ...]\n");
    return 2;
  }
  const Cube cube(edge);
  fmt::print("{}^3 particles, {:.4g} directed bonds\n\n", edge,
             std::accumulate(cube.sizes.begin(), cube.sizes.end(), 0.0));
  fmt::print(
      "| method | parts | particles a part | imbalance, bonds | imbalance, particles | ghosts a part, mean | max "
      "| ghosts/owned, mean | neighbours, mean | max | s |\n|---|---|---|---|---|---|---|---|---|---|---|\n");
  std::vector<std::pair<int, Quality>> of_rcb;
  for (const auto method :
       {body::PartitionMethod::rcb, body::PartitionMethod::multijagged, body::PartitionMethod::hsfc})
    for (const int parts : cuts) {
      const auto begin = std::chrono::steady_clock::now();
      const std::vector<int> part_of = body::partition(cube.particles, cube.sizes, 3, ranks, parts, method);
      const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
      const Quality q = quality(cube, part_of, parts);
      fmt::print("| {} | {} | {:.0f} | {:.4f} | {:.4f} | {:.0f} | {:.0f} | {:.2f} | {:.1f} | {:.0f} | {:.0f} |\n",
                 name_of(method), parts, q.particles.mean, q.bonds.max / q.bonds.mean,
                 q.particles.max / q.particles.mean, q.ghosts.mean, q.ghosts.max, q.ghosts.mean / q.particles.mean,
                 q.neighbors.mean, q.neighbors.max, seconds);
      std::fflush(stdout);
      if (method == body::PartitionMethod::rcb) of_rcb.emplace_back(parts, q);
    }
  fmt::print(
      "\n| particles a part | ranks | kB a rank | messages | product, ms | halo, ms | reductions, ms | efficiency "
      "| coarse unknowns, all | a part |\n|---|---|---|---|---|---|---|---|---|---|\n");
  for (const auto& [parts, q] : of_rcb)
    for (const double many : {64.0, 512.0, 4096.0, 32768.0}) {
      const Iteration i = iteration(q, many);
      const double coarse = q.particles.mean / 27 * 3;
      fmt::print("| {:.0f} | {:.0f} | {:.0f} | {:.0f} | {:.2f} | {:.3f} | {:.3f} | {:.3f} | {:.3g} | {:.3g} |\n",
                 q.particles.mean, many, 48 * q.ghosts.max / 1e3, 2 * q.neighbors.max, 1e3 * i.product, 1e3 * i.halo,
                 1e3 * i.reductions, q.bonds.mean * seconds_a_bond / (i.product + i.halo + i.reductions), coarse * many,
                 coarse);
    }
  fmt::print("\nmost memory: {:.1f} GB\n", gigabytes());
  return 0;
}
