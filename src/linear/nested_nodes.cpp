#include "nested_nodes.hpp"

#include <algorithm>
#include <utility>

#include "perinox/grid/disjoint_sets.hpp"

namespace perinox::linear {

namespace {

using Place = std::array<GlobalId, 3>;
/// A fine node between coarse ones has two of them on that axis. Slot s of a node: its parent that is the upper one
/// on axis a where bit a of s is set.
constexpr std::size_t slots = 8;

bool has_slot(const Place& fine, std::size_t slot) {
  for (std::size_t a = 0; a < 3; ++a)
    if ((slot >> a & 1) != 0 && fine[a] % 2 == 0) return false;
  return true;
}

Place parent_at(const Place& fine, std::size_t slot) {
  Place place;
  for (std::size_t a = 0; a < 3; ++a) place[a] = fine[a] / 2 + static_cast<GlobalId>(slot >> a & 1);
  return place;
}

/// The slot of a node in which the coarse place is, or `slots`.
std::size_t slot_of(const Place& fine, const Place& coarse) {
  std::size_t slot = 0;
  for (std::size_t a = 0; a < 3; ++a) {
    const GlobalId beyond = 2 * coarse[a] - fine[a];
    if (beyond < -1 || beyond > 1) return slots;
    if (beyond == 1) slot |= std::size_t{1} << a;
  }
  return slot;
}

/// [nodes * slots] For each parent of each node, the lowest id among the fine nodes that entries of the matrix join to
/// it through nodes with the same parent: together with the parent's place this names the copy.
std::vector<long long> labels(const Communicator& ranks, const grid::SharedNodes& shared, const GridNodes& fine,
                              const CoarseMatrix& joined) {
  const std::size_t nodes = fine.id.size();
  grid::DisjointSets sets(nodes * slots);
  for (std::size_t n = 0; n < nodes; ++n)
    for (std::size_t slot = 0; slot < slots; ++slot) {
      if (!has_slot(fine.place[n], slot)) continue;
      const Place coarse = parent_at(fine.place[n], slot);
      for (std::size_t k = joined.row_begin[n]; k < joined.row_begin[n + 1]; ++k) {
        const auto beside = static_cast<std::size_t>(joined.column[k]);
        if (beside >= n) break;  // columns ascend and the pattern is symmetric
        const std::size_t other = slot_of(fine.place[beside], coarse);
        if (other < slots)
          sets.join(static_cast<LocalIndex>(n * slots + slot), static_cast<LocalIndex>(beside * slots + other));
      }
    }
  std::vector<long long> label(nodes * slots);
  for (std::size_t k = 0; k < label.size(); ++k) label[k] = fine.id[k / slots];
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t k = 0; k < label.size(); ++k) {
      long long& root = label[sets.root(static_cast<LocalIndex>(k))];
      root = std::min(root, label[k]);
    }
    for (std::size_t k = 0; k < label.size(); ++k) label[k] = label[sets.root(static_cast<LocalIndex>(k))];
    std::vector<long long> before = label;
    shared.lowest(label.data(), slots);
    changed = ranks.any(before != label);
  }
  return label;
}

template <class Value>
void sort_once(std::vector<Value>& values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

}  // namespace

Nesting nest(const Communicator& ranks, const grid::SharedNodes& shared, const GridNodes& fine,
             const CoarseMatrix& joined) {
  const std::vector<long long> label = labels(ranks, shared, fine, joined);
  // Copies of all ranks as (place, label), numbered in their order.
  using Copy = std::array<long long, 4>;
  std::vector<Copy> local;
  for (std::size_t k = 0; k < label.size(); ++k) {
    if (!has_slot(fine.place[k / slots], k % slots)) continue;
    const Place place = parent_at(fine.place[k / slots], k % slots);
    local.push_back({place[2], place[1], place[0], label[k]});
  }
  const std::vector<Copy> every = local;
  sort_once(local);
  std::vector<Copy> all = local;
  if (ranks.size() > 1) {
    std::vector<long long> flat;
    for (const Copy& copy : local) flat.insert(flat.end(), copy.begin(), copy.end());
    flat = ranks.gather(flat);
    all.clear();
    for (std::size_t k = 0; k < flat.size(); k += 4) all.push_back({flat[k], flat[k + 1], flat[k + 2], flat[k + 3]});
    sort_once(all);
  }

  Nesting nesting;
  for (const Copy& copy : local) {
    nesting.coarse.id.push_back(std::lower_bound(all.begin(), all.end(), copy) - all.begin());
    nesting.coarse.place.push_back({copy[2], copy[1], copy[0]});
  }
  nesting.parent_begin.push_back(0);
  std::size_t next = 0;
  for (const Place& place : fine.place) {
    for (std::size_t slot = 0; slot < slots; ++slot) {
      if (!has_slot(place, slot)) continue;
      const auto at = std::lower_bound(local.begin(), local.end(), every[next++]) - local.begin();
      nesting.parent.push_back(static_cast<LocalIndex>(at));
    }
    const std::size_t count = nesting.parent.size() - nesting.parent_begin.back();
    nesting.weight.insert(nesting.weight.end(), count, 1.0 / static_cast<double>(count));
    nesting.parent_begin.push_back(nesting.parent.size());
  }
  return nesting;
}

namespace {

/// A row of A W at a time: the columns in which it has blocks.
class ProductRow {
 public:
  ProductRow(const Nesting& nesting, const CoarseMatrix& fine)
      : nesting_(nesting), fine_(fine), met_(nesting.coarse.id.size(), 0) {}

  const std::vector<LocalIndex>& columns(std::size_t n) {
    columns_.clear();
    for (std::size_t k = fine_.row_begin[n]; k < fine_.row_begin[n + 1]; ++k) {
      const auto [first, last] = nesting_.parents(static_cast<std::size_t>(fine_.column[k]));
      for (std::size_t p = first; p < last; ++p) {
        if (met_[nesting_.parent[p]]) continue;
        met_[nesting_.parent[p]] = 1;
        columns_.push_back(nesting_.parent[p]);
      }
    }
    for (const LocalIndex column : columns_) met_[column] = 0;
    return columns_;
  }

 private:
  const Nesting& nesting_;
  const CoarseMatrix& fine_;
  std::vector<LocalIndex> columns_;
  std::vector<char> met_;
};

/// The pattern of W^T A W, with zeros.
CoarseMatrix galerkin_pattern(const Nesting& nesting, const CoarseMatrix& fine, ProductRow& product) {
  std::vector<std::vector<LocalIndex>> beside(nesting.coarse.id.size());
  for (std::size_t n = 0; n + 1 < nesting.parent_begin.size(); ++n) {
    const std::vector<LocalIndex>& columns = product.columns(n);
    const auto [first, last] = nesting.parents(n);
    for (std::size_t p = first; p < last; ++p) {
      auto& row = beside[nesting.parent[p]];
      const std::size_t old = row.size();
      row.insert(row.end(), columns.begin(), columns.end());
      if (old >= 64) sort_once(row);
    }
  }
  CoarseMatrix coarse;
  coarse.dimension = fine.dimension;
  coarse.row_begin.push_back(0);
  for (auto& row : beside) {
    sort_once(row);
    coarse.column.insert(coarse.column.end(), row.begin(), row.end());
    coarse.row_begin.push_back(coarse.column.size());
  }
  coarse.value.assign(coarse.column.size() * static_cast<std::size_t>(fine.dimension * fine.dimension), 0.0);
  return coarse;
}

}  // namespace

CoarseMatrix galerkin(const Nesting& nesting, const CoarseMatrix& fine) {
  const auto entries = static_cast<std::size_t>(fine.dimension * fine.dimension);
  ProductRow product(nesting, fine);
  CoarseMatrix coarse = galerkin_pattern(nesting, fine, product);
  std::vector<double> blocks(nesting.coarse.id.size() * entries, 0.0);
  for (std::size_t n = 0; n + 1 < nesting.parent_begin.size(); ++n) {
    for (std::size_t k = fine.row_begin[n]; k < fine.row_begin[n + 1]; ++k) {
      const auto [first, last] = nesting.parents(static_cast<std::size_t>(fine.column[k]));
      for (std::size_t p = first; p < last; ++p)
        for (std::size_t e = 0; e < entries; ++e)
          blocks[nesting.parent[p] * entries + e] += nesting.weight[p] * fine.value[k * entries + e];
    }
    const auto [first, last] = nesting.parents(n);
    for (const LocalIndex column : product.columns(n)) {
      double* sum = &blocks[column * entries];
      for (std::size_t p = first; p < last; ++p) {
        double* to = coarse.block(nesting.parent[p], column);
        for (std::size_t e = 0; e < entries; ++e) to[e] += nesting.weight[p] * sum[e];
      }
      std::fill_n(sum, entries, 0.0);
    }
  }
  return coarse;
}

}  // namespace perinox::linear
