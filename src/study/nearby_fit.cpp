#include "nearby_fit.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <nanoflann.hpp>

namespace perinox::study {

struct NearbyFit::Tree {
  std::vector<double> positions, values;
  int columns, dimension;

  // The following members are those that nanoflann asks of a set of points.
  std::size_t kdtree_get_point_count() const { return positions.size() / 3; }
  double kdtree_get_pt(std::size_t point, std::size_t axis) const { return positions[point * 3 + axis]; }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
  using Index = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Tree>, Tree, 3, std::size_t>;
  std::unique_ptr<Index> index;
};

NearbyFit::NearbyFit(std::vector<double> positions, std::vector<double> values, int columns, int dimension)
    : tree_(new Tree{std::move(positions), std::move(values), columns, dimension, nullptr}) {
  tree_->index = std::make_unique<Tree::Index>(3, *tree_);
  tree_->index->buildIndex();
}

NearbyFit::~NearbyFit() = default;

std::vector<double> NearbyFit::at(const double* place) const {
  const bool solid = tree_->dimension == 3;
  const std::size_t wanted = std::min<std::size_t>(solid ? 27 : 12, tree_->kdtree_get_point_count());
  std::vector<std::size_t> found(wanted);
  std::vector<double> square(wanted);
  const auto count = static_cast<Eigen::Index>(tree_->index->knnSearch(place, wanted, found.data(), square.data()));
  const double size = std::sqrt(square[static_cast<std::size_t>(count) - 1]);
  const double scale = size > 0 ? size : 1;
  Eigen::MatrixXd terms(count, solid ? 10 : 6);
  Eigen::MatrixXd right(count, tree_->columns);
  for (Eigen::Index k = 0; k < count; ++k) {
    const std::size_t point = found[static_cast<std::size_t>(k)];
    const double d2 = square[static_cast<std::size_t>(k)] / (scale * scale);
    const double weight = 1 / std::sqrt(d2 + 1e-6);
    double d[3];
    for (std::size_t c = 0; c < 3; ++c) d[c] = (tree_->positions[point * 3 + c] - place[c]) / scale;
    Eigen::Index t = 0;
    const auto add = [&](double value) { terms(k, t++) = weight * value; };
    add(1);
    const int axes = solid ? 3 : 2;
    for (int a = 0; a < axes; ++a) add(d[a]);
    for (int a = 0; a < axes; ++a)
      for (int b = a; b < axes; ++b) add(d[a] * d[b]);
    for (int c = 0; c < tree_->columns; ++c)
      right(k, c) =
          weight * tree_->values[point * static_cast<std::size_t>(tree_->columns) + static_cast<std::size_t>(c)];
  }
  // This is the solution of least norm where the points do not decide every term, as near corners of thin bodies.
  const Eigen::MatrixXd fitted = terms.completeOrthogonalDecomposition().solve(right);
  std::vector<double> values(static_cast<std::size_t>(tree_->columns));
  for (int c = 0; c < tree_->columns; ++c) values[static_cast<std::size_t>(c)] = fitted(0, c);
  return values;
}

}  // namespace perinox::study
