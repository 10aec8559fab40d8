#pragma once
#include <algorithm>
#include <numeric>
#include <vector>

#include "perinox/core/types.hpp"

namespace perinox::grid {

/// A partition of the numbers 0..n-1 into disjoint sets (union-find). The root of a set is its smallest member.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), 0); }
  LocalIndex root(LocalIndex i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(LocalIndex a, LocalIndex b) {
    const LocalIndex ra = root(a), rb = root(b);
    parent_[std::max(ra, rb)] = std::min(ra, rb);
  }

 private:
  std::vector<LocalIndex> parent_;
};

}  // namespace perinox::grid
