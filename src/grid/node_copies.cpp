#include "node_copies.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <unordered_map>
#include <unordered_set>

#include "perinox/grid/disjoint_sets.hpp"

namespace perinox::grid {

namespace {

using Keys = std::unordered_set<GlobalId>;

/// A cell that is filled less than this may hide a gap wider than the horizon, across which no bond was ever made: if
/// such a gap, one cell wide, runs through two cells, one of them is filled to a half at most. Interior cells of
/// jittered clouds are filled more than this.
constexpr double poorly_filled = 0.7;

std::vector<std::array<int, 3>> offsets_around(int dimension) {
  std::vector<std::array<int, 3>> all;
  const int deep = dimension == 3 ? 1 : 0;
  for (int z = -deep; z <= deep; ++z)
    for (int y = -1; y <= 1; ++y)
      for (int x = -1; x <= 1; ++x) all.push_back({x, y, z});
  return all;
}

/// Volume of this rank's particles in each cell that they reach into. Each particle is taken as a cube.
std::unordered_map<GlobalId, double> filled_volumes(const body::Body& body, const Cells& cells) {
  std::unordered_map<GlobalId, double> volume;
  const auto d = static_cast<std::size_t>(body.dimension);
  for (LocalIndex i = 0; i < body.owned; ++i) {
    const double edge = std::pow(body.volume[i], 1.0 / body.dimension);
    const GlobalId own = cells.cell_at(body.position(i));
    const Cells::Place place = cells.cell_place(own);
    const std::array<double, 3> corner = cells.position(place);
    // For each axis: the share of the particle's cube that sticks out of the cell, and the side on which it does.
    std::array<double, 3> out{};
    std::array<int, 3> side{};
    for (std::size_t a = 0; a < d; ++a) {
      const double below = corner[a] - (body.position(i)[a] - edge / 2),
                   above = body.position(i)[a] + edge / 2 - corner[a] - cells.size()[a];
      side[a] = below > above ? -1 : 1;
      out[a] = std::clamp(std::max(below, above) / edge, 0.0, 1.0);
    }
    for (int beside = 0; beside < 1 << d; ++beside) {
      double share = body.volume[i];
      std::array<int, 3> offset{};
      for (std::size_t a = 0; a < d; ++a) {
        const bool outside = (beside >> a & 1) != 0;
        share *= outside ? out[a] : 1 - out[a];
        offset[a] = outside ? side[a] : 0;
      }
      const GlobalId cell = share > 0 ? cells.cell_beside(place, offset) : -1;
      if (cell >= 0) volume[cell] += share;
    }
  }
  return volume;
}

/// Cells in which the body may be parted, collected over all ranks.
Keys suspects(const body::Body& body, const std::vector<double>& damage, const Cells& cells,
              const std::vector<GlobalId>& cell) {
  Keys found;
  std::unordered_map<GlobalId, int> part;  // -1: several
  std::set<GlobalId> held;                 // cells that hold particles of this rank
  for (LocalIndex i = 0; i < body.local(); ++i) {
    if (i < body.owned) {
      held.insert(held.end(), cell[i]);
      if (damage[i] > 0) found.insert(cell[i]);
    }
    const auto [at, is_new] = part.emplace(cell[i], body.part[i]);
    if (!is_new && at->second != body.part[i]) at->second = -1;
  }
  const auto around = offsets_around(body.dimension);
  for (const GlobalId key : held) {
    const int own = part.at(key);
    for (const auto& offset : around) {
      const auto other = part.find(cells.cell_beside(cells.cell_place(key), offset));
      if (other != part.end() && (own < 0 || other->second != own)) found.insert(key);
    }
  }
  // A cell at a rank's border may be filled up by other ranks. The volumes of cells that one rank finds poorly filled
  // are therefore added up over the ranks.
  const std::unordered_map<GlobalId, double> volume = filled_volumes(body, cells);
  const double enough = poorly_filled * cells.volume();
  std::vector<long long> poor;
  for (const GlobalId key : held)
    if (volume.at(key) < enough) poor.push_back(key);
  poor = body.communicator.gather(poor);
  std::sort(poor.begin(), poor.end());
  poor.erase(std::unique(poor.begin(), poor.end()), poor.end());
  std::vector<double> sums(poor.size(), 0.0);
  for (std::size_t k = 0; k < poor.size(); ++k) {
    const auto at = volume.find(poor[k]);
    if (at != volume.end()) sums[k] = at->second;
  }
  body.communicator.sum(sums);
  std::vector<long long> own_suspects(found.begin(), found.end());
  const auto gathered = body.communicator.gather(own_suspects);
  Keys all(gathered.begin(), gathered.end());
  for (std::size_t k = 0; k < poor.size(); ++k)
    if (sums[k] < enough) all.insert(poor[k]);
  return all;
}

/// Cells that are looked at for pieces: the suspect ones and those around them.
Keys with_neighbors(const Keys& suspect, const Cells& cells, const std::vector<std::array<int, 3>>& around) {
  Keys looked_at;
  for (const GlobalId key : suspect)
    for (const auto& offset : around) {
      const GlobalId beside = cells.cell_beside(cells.cell_place(key), offset);
      if (beside >= 0) looked_at.insert(beside);
    }
  return looked_at;
}

/// Which piece of its cell each particle belongs to, named by the lowest particle id in it: [local], whole numbers
/// below 2^53. Bonds join particles on this rank, then the owners' labels go to the ghosts until no label falls any
/// more. (A bond is in both ends' families, so the owner of a ghost sees the same bond from its side.) Collective.
std::vector<double> label_pieces(const body::Body& body, const std::vector<GlobalId>& cell,
                                 const std::vector<char>& inside, const bonds::BondGraph& graph) {
  const auto local = static_cast<std::size_t>(body.local());
  DisjointSets joined(local);
  std::vector<LocalIndex> neighbors;
  for (LocalIndex i = 0; i < body.owned; ++i) {
    if (!inside[i]) continue;
    graph(i, neighbors);
    for (const LocalIndex j : neighbors)
      if (cell[j] == cell[i]) joined.join(i, j);
  }
  std::vector<double> label(local);
  for (std::size_t i = 0; i < local; ++i) label[i] = static_cast<double>(body.id[i]);
  bool changed = true;
  while (changed) {
    changed = false;
    for (LocalIndex i = 0; i < body.local(); ++i) {
      double& root = label[joined.root(i)];
      if (label[i] < root) root = label[i];
    }
    for (LocalIndex i = 0; i < body.local(); ++i) {
      const double root = label[joined.root(i)];
      changed = changed || (i < body.owned && root < label[i]);
      label[i] = root;
    }
    body.halo.update_ghosts(label.data(), 1);
    changed = body.communicator.any(changed);
  }
  return label;
}

using Pairs = std::set<std::pair<GlobalId, GlobalId>>;

Pairs gather_pairs(const Communicator& ranks, const Pairs& pairs) {
  std::vector<long long> flat;
  for (const auto& [a, b] : pairs) flat.insert(flat.end(), {a, b});
  flat = ranks.gather(flat);
  Pairs all;
  for (std::size_t k = 0; k + 1 < flat.size(); k += 2) all.insert({flat[k], flat[k + 1]});
  return all;
}

/// The pieces of all ranks, and which of them bonds tie together from cell to cell.
struct Pieces {
  std::unordered_map<GlobalId, std::vector<GlobalId>> of_cell, tied_to;  ///< tied_to: of a lower piece, higher ones

  /// label: of label_pieces(). Collective.
  Pieces(const body::Body& body, const std::vector<GlobalId>& cell, const std::vector<char>& inside,
         const std::vector<double>& label, const bonds::BondGraph& graph) {
    Pairs pieces, ties;  // (cell, piece); (lower piece, higher piece)
    std::vector<LocalIndex> neighbors;
    for (LocalIndex i = 0; i < body.owned; ++i) {
      if (!inside[i]) continue;
      const auto piece = static_cast<GlobalId>(label[i]);
      pieces.insert({cell[i], piece});
      graph(i, neighbors);
      GlobalId last = -1;
      for (const LocalIndex j : neighbors) {
        if (cell[j] == cell[i] || !inside[j]) continue;
        const auto other = static_cast<GlobalId>(label[j]);
        if (other == last) continue;  // neighbours of one piece often follow each other
        last = other;
        ties.insert({std::min(piece, other), std::max(piece, other)});
      }
    }
    for (const auto& [key, piece] : gather_pairs(body.communicator, pieces)) of_cell[key].push_back(piece);
    for (const auto& [a, b] : gather_pairs(body.communicator, ties)) tied_to[a].push_back(b);
  }

  /// Joins those of the members, ascending, that are tied together.
  DisjointSets components(const std::vector<GlobalId>& members) const {
    DisjointSets joined(members.size());
    for (std::size_t k = 0; k < members.size(); ++k) {
      const auto found = tied_to.find(members[k]);
      if (found == tied_to.end()) continue;
      for (const GlobalId other : found->second) {
        const auto at = std::lower_bound(members.begin(), members.end(), other);
        if (at != members.end() && *at == other)
          joined.join(static_cast<LocalIndex>(k), static_cast<LocalIndex>(at - members.begin()));
      }
    }
    return joined;
  }
};

}  // namespace

GlobalId NodeCopies::copy_of(GlobalId node, GlobalId piece) const {
  if (piece < 0) return node;
  const auto found = copy_.find({node, piece});
  return found == copy_.end() ? node : found->second;
}

GlobalId NodeCopies::original(GlobalId id) const {
  return id < first_extra_ ? id : original_[static_cast<std::size_t>(id - first_extra_)];
}

NodeCopies::NodeCopies(const body::Body& body, const std::vector<double>& damage, const Cells& cells,
                       const bonds::BondGraph& graph)
    : first_extra_(cells.node_count()) {
  const auto local = static_cast<std::size_t>(body.local());
  std::vector<GlobalId> cell(local);
  for (LocalIndex i = 0; i < body.local(); ++i) cell[i] = cells.cell_at(body.position(i));
  const Keys suspect = suspects(body, damage, cells, cell);
  if (suspect.empty()) return;

  const auto around = offsets_around(body.dimension);
  const Keys looked_at = with_neighbors(suspect, cells, around);
  std::vector<char> inside(local);
  for (std::size_t i = 0; i < local; ++i) inside[i] = looked_at.count(cell[i]) > 0;
  const std::vector<double> label = label_pieces(body, cell, inside, graph);
  piece_.assign(static_cast<std::size_t>(body.owned), -1);
  for (LocalIndex i = 0; i < body.owned; ++i)
    if (inside[i]) piece_[i] = static_cast<GlobalId>(label[i]);
  const Pieces pieces(body, cell, inside, label, graph);

  std::set<GlobalId> nodes;
  for (const GlobalId key : suspect)
    for (int c = 0; c < cells.corners(); ++c) nodes.insert(cells.node_at(cells.cell_place(key), c));
  for (const GlobalId node : nodes) {
    std::vector<GlobalId> members;
    for (const auto& offset : around) {
      if (offset[0] > 0 || offset[1] > 0 || offset[2] > 0) continue;  // the cells whose upper corners meet here
      const auto found = pieces.of_cell.find(cells.cell_beside(cells.node_place(node), offset));
      if (found != pieces.of_cell.end()) members.insert(members.end(), found->second.begin(), found->second.end());
    }
    std::sort(members.begin(), members.end());
    copy_node(node, members, pieces.components(members));
  }
}

// The copies are numbered in the order of their lowest particle. The first one is the node itself.
void NodeCopies::copy_node(GlobalId node, const std::vector<GlobalId>& members, DisjointSets component) {
  std::map<LocalIndex, GlobalId> id_of_root;
  for (std::size_t k = 0; k < members.size(); ++k) {
    const LocalIndex root = component.root(static_cast<LocalIndex>(k));
    if (root == 0) continue;
    const auto [at, is_new] = id_of_root.emplace(root, first_extra_ + extra_copies_);
    if (is_new) {
      original_.push_back(node);
      ++extra_copies_;
    }
    copy_[{node, members[k]}] = at->second;
  }
}

}  // namespace perinox::grid
