#include "perinox/body/neighbor_search.hpp"

#include <algorithm>
#include <cmath>
#include <nanoflann.hpp>
#include <utility>

namespace perinox::body {

namespace {

constexpr double kTie = 1e-10;  ///< a point this much (relative) beyond the radius is still at the radius

/// The points in the form that nanoflann expects.
template <int Dimension>
struct Points {
  const std::vector<double>& values;
  std::size_t kdtree_get_point_count() const { return values.size() / Dimension; }
  double kdtree_get_pt(std::size_t point, std::size_t axis) const { return values[point * Dimension + axis]; }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};

template <int Dimension>
struct DimensionTree {
  using Index = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Points<Dimension>>,
                                                    Points<Dimension>, Dimension, std::uint32_t>;
  Points<Dimension> points;
  Index index;
  explicit DimensionTree(const std::vector<double>& values)
      : points{values}, index(Dimension, points, nanoflann::KDTreeSingleIndexAdaptorParams(16)) {}
};

/// Collects indices only. nanoflann's own radius set also keeps distances, which nobody needs here.
struct Within {
  double squared;
  std::vector<LocalIndex>& found;
  bool full() const { return true; }
  std::size_t size() const { return found.size(); }
  double worstDist() const { return squared; }
  bool addPoint(double distance, std::uint32_t index) {
    if (distance < squared) found.push_back(static_cast<LocalIndex>(index));
    return true;
  }
};

/// Finds the nearest point, leaving one out.
struct Nearest {
  LocalIndex except;
  double squared = std::numeric_limits<double>::max();
  LocalIndex best = -1;
  bool full() const { return best >= 0; }
  std::size_t size() const { return best >= 0 ? 1 : 0; }
  double worstDist() const { return squared; }
  bool addPoint(double distance, std::uint32_t index) {
    const auto candidate = static_cast<LocalIndex>(index);
    if (candidate != except && distance < squared) {
      squared = distance;
      best = candidate;
    }
    return true;
  }
};

}  // namespace

struct NeighborSearch::Tree {
  std::unique_ptr<DimensionTree<2>> flat;
  std::unique_ptr<DimensionTree<3>> solid;

  template <class Result>
  void find(Result& result, const double* center) const {
    const nanoflann::SearchParams parameters(0, 0.0F, false);
    if (flat) flat->index.findNeighbors(result, center, parameters);
    if (solid) solid->index.findNeighbors(result, center, parameters);
  }
};

NeighborSearch::NeighborSearch(const std::vector<double>& points, int dimension) : tree_(std::make_unique<Tree>()) {
  if (points.empty()) return;  // nothing to find, and nanoflann wants at least one point
  if (dimension == 2) tree_->flat = std::make_unique<DimensionTree<2>>(points);
  if (dimension == 3) tree_->solid = std::make_unique<DimensionTree<3>>(points);
}

NeighborSearch::~NeighborSearch() = default;

void NeighborSearch::within(const double* center, double radius, std::vector<LocalIndex>& found) const {
  found.clear();
  const double padded = radius * (1 + kTie);
  Within result{padded * padded, found};
  tree_->find(result, center);
  std::sort(found.begin(), found.end());
}

LocalIndex NeighborSearch::nearest(const double* center, double& distance, LocalIndex except) const {
  Nearest result{except};
  tree_->find(result, center);
  distance = std::sqrt(result.squared);
  return result.best;
}

std::vector<std::vector<LocalIndex>> neighbors_within(const std::vector<double>& points, int dimension, int queries,
                                                      double radius) {
  const NeighborSearch search(points, dimension);
  std::vector<std::vector<LocalIndex>> neighbors(static_cast<std::size_t>(queries));
  std::vector<LocalIndex> found;
  for (LocalIndex i = 0; i < queries; ++i) {
    search.within(&points[static_cast<std::size_t>(i) * static_cast<std::size_t>(dimension)], radius, found);
    found.erase(std::remove(found.begin(), found.end(), i), found.end());
    neighbors[i] = found;
  }
  return neighbors;
}

}  // namespace perinox::body
