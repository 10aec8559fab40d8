#include "perinox/bonds/components.hpp"

#include <algorithm>
#include <numeric>

namespace perinox::bonds {

namespace {

/// Disjoint sets of local particles. A set is named by its smallest member.
class Sets {
 public:
  explicit Sets(int size) : parent_(static_cast<std::size_t>(size)) {
    std::iota(parent_.begin(), parent_.end(), LocalIndex{0});
  }
  LocalIndex find(LocalIndex i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  /// Unites the set of `root`, which must be a root, with the set of j and returns the root of the union.
  LocalIndex unite(LocalIndex root, LocalIndex j) {
    if (parent_[j] == root) return root;  // this is so nearly always, once a piece has grown
    const LocalIndex other = find(j);
    const LocalIndex smaller = std::min(root, other);
    parent_[std::max(root, other)] = smaller;
    return smaller;
  }

 private:
  std::vector<LocalIndex> parent_;
};

Sets local_pieces(const body::Body& body, const BondGraph& graph) {
  Sets sets(body.local());
  std::vector<LocalIndex> neighbors;
  for (LocalIndex i = 0; i < body.owned; ++i) {
    graph(i, neighbors);
    LocalIndex root = sets.find(i);
    for (const LocalIndex j : neighbors)
      if (j > i) root = sets.unite(root, j);  // j sees the other half; ghosts are above every owned particle
  }
  return sets;
}

/// Smallest id of the whole piece, for every local particle. [owned + ghosts]; ids below 2^53 are exact in a double.
std::vector<double> smallest_ids(const body::Body& body, Sets sets) {
  std::vector<double> smallest(static_cast<std::size_t>(body.local())), label(smallest.size());
  for (LocalIndex i = 0; i < body.local(); ++i) smallest[i] = static_cast<double>(body.id[i]);
  for (LocalIndex i = 0; i < body.local(); ++i) {
    double& least = smallest[sets.find(i)];
    least = std::min(least, static_cast<double>(body.id[i]));
  }
  const auto spread = [&] {
    for (LocalIndex i = 0; i < body.local(); ++i) label[i] = smallest[sets.find(i)];
  };
  spread();
  if (body.communicator.size() == 1) return label;
  // Both ranks hold a bond between them, so what an owner knows of its piece is enough.
  for (bool changed = true; body.communicator.any(changed);) {
    changed = false;
    body.halo.update_ghosts(label.data(), 1);
    for (LocalIndex g = body.owned; g < body.local(); ++g) {
      double& least = smallest[sets.find(g)];
      if (label[g] >= least) continue;
      least = label[g];
      changed = true;
    }
    spread();
  }
  return label;
}

/// The values of all ranks one after another, on every rank.
std::vector<GlobalId> gather_all(const std::vector<GlobalId>& mine, const Communicator& communicator) {
  std::vector<int> counts, starts;
  int total = 0;
  for (const long long count : communicator.gather(static_cast<long long>(mine.size()))) {
    counts.push_back(static_cast<int>(count));
    starts.push_back(total);
    total += counts.back();
  }
  std::vector<GlobalId> all(static_cast<std::size_t>(total));
  MPI_Allgatherv(mine.data(), static_cast<int>(mine.size()), MPI_LONG_LONG, all.data(), counts.data(), starts.data(),
                 MPI_LONG_LONG, communicator.mpi());
  return all;
}

}  // namespace

BondGraph bond_graph(const Bonds& bonds) {
  return [&bonds](LocalIndex i, std::vector<LocalIndex>& neighbors) {
    const auto begin = bonds.neighbor.begin();
    neighbors.assign(begin + bonds.offset[i], begin + bonds.offset[i + 1]);
  };
}

Components connected_components(const body::Body& body, const BondGraph& graph) {
  const std::vector<double> label = smallest_ids(body, local_pieces(body, graph));
  std::vector<GlobalId> mine;
  for (LocalIndex i = 0; i < body.owned; ++i)
    if (static_cast<GlobalId>(label[i]) == body.id[i]) mine.push_back(body.id[i]);
  Components components;
  components.first = gather_all(mine, body.communicator);
  std::sort(components.first.begin(), components.first.end());

  std::vector<double> particles(components.first.size(), 0.0);
  components.of.reserve(label.size());
  for (std::size_t i = 0; i < label.size(); ++i) {
    const auto found =
        std::lower_bound(components.first.begin(), components.first.end(), static_cast<GlobalId>(label[i]));
    components.of.push_back(static_cast<int>(found - components.first.begin()));
    if (i < static_cast<std::size_t>(body.owned)) particles[components.of.back()] += 1;
  }
  body.communicator.sum(particles);
  for (const double count : particles) components.particles.push_back(static_cast<long long>(count));
  return components;
}

}  // namespace perinox::bonds
