#pragma once
#include <memory>
#include <vector>

#include "perinox/core/types.hpp"

namespace perinox::body {

/// A k-d tree (nanoflann) over points, for many searches. The points must outlive it.
class NeighborSearch {
 public:
  /// points: [count * dimension], length. O(count log count). dimension: 2 or 3.
  NeighborSearch(const std::vector<double>& points, int dimension);
  ~NeighborSearch();

  /// Finds the points within `radius` of `center` (the center's own point too), in ascending order of index. A point at
  /// exactly the radius counts as inside (relative tolerance 1e-10). Replaces what is in `found`.
  void within(const double* center, double radius, std::vector<LocalIndex>& found) const;
  /// The point nearest to `center` other than `except` (-1: no exception), and its distance. It is -1 if there is none.
  LocalIndex nearest(const double* center, double& distance, LocalIndex except = -1) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

/// Finds, for each of the first `queries` points, all points (except itself) within `radius` of it, in ascending order
/// of local index. points: [count * dimension]. It uses one k-d tree (nanoflann), O(count log count).
std::vector<std::vector<LocalIndex>> neighbors_within(const std::vector<double>& points, int dimension, int queries,
                                                      double radius);

}  // namespace perinox::body
