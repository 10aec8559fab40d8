/// The coarse system: factors where it is small, else one V-cycle over nested grids.
#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>

#include "coarse_solver.hpp"
#include "nested_nodes.hpp"
#include "node_smoother.hpp"

namespace perinox::linear {

namespace {

/// Of the largest eigenvalue to the lowest that smoothers treat. 4 costs iterations, 12 to 35 are the same.
constexpr double smoothed_ratio = 20;

GridNodes nodes_of(const grid::BackgroundGrid& grid) {
  const auto d = static_cast<std::size_t>(grid.dimension());
  const std::array<double, 3> origin = grid.cells().position({0, 0, 0});
  GridNodes nodes;
  nodes.id = grid.node_ids();
  for (std::size_t n = 0; n < nodes.id.size(); ++n) {
    std::array<GlobalId, 3> place{};
    for (std::size_t a = 0; a < d; ++a)
      place[a] = std::llround((grid.node_positions()[n * d + a] - origin[a]) / grid.cells().size()[a]);
    nodes.place.push_back(place);
  }
  return nodes;
}

class Nested : public CoarseSolver {
 public:
  Nested(const Communicator& ranks, const grid::BackgroundGrid& grid, CoarseMatrix matrix, int smoothing,
         long long factorised_up_to)
      : dimension_(static_cast<std::size_t>(matrix.dimension)) {
    // In units of its largest entry: single precision, in which the smoothers keep it, has a narrow range.
    for (const double value : matrix.value) scale_ = std::max(scale_, std::abs(value));
    scale_ = ranks.max(scale_);
    for (double& value : matrix.value) value /= scale_;
    GridNodes nodes = nodes_of(grid);
    long long count = grid::SharedNodes(ranks, nodes.id).total();
    unknowns_ = count * matrix.dimension;
    while (count * matrix.dimension > factorised_up_to) {
      levels_.emplace_back(ranks, nodes, matrix, smoothing);
      const Nesting& nesting = levels_.back().nesting;
      const long long next_count = grid::SharedNodes(ranks, nesting.coarse.id).total();
      if (4 * next_count > 3 * count) {  // little but copies is left, which nothing ties together
        levels_.pop_back();
        break;
      }
      matrix = galerkin(nesting, matrix);
      nodes = nesting.coarse;
      count = next_count;
    }
    last_nodes_ = nodes.id.size();
    last_ = factorised_coarse_solver(ranks, nodes.id, matrix);
  }

  void solve(const double* right, double* solution) override {
    const std::size_t d = dimension_;
    if (levels_.empty()) {
      last_->solve(right, solution);
      for (std::size_t u = 0; u < last_nodes_ * d; ++u) solution[u] /= scale_;
      return;
    }
    Level& top = levels_.front();
    for (std::size_t n = 0; n < top.smoother.size() / 4; ++n)
      for (std::size_t c = 0; c < d; ++c) top.right[4 * n + c] = right[n * d + c];
    cycle(0);
    for (std::size_t n = 0; n < top.smoother.size() / 4; ++n)
      for (std::size_t c = 0; c < d; ++c) solution[n * d + c] = top.x[4 * n + c] / scale_;
  }
  bool exact() const override { return levels_.empty(); }
  long long unknowns() const override { return unknowns_; }
  std::size_t bytes() const override {
    std::size_t sum = last_->bytes();
    for (const Level& level : levels_) sum += level.smoother.bytes();
    return sum;
  }

 private:
  struct Level {
    Level(const Communicator& ranks, const GridNodes& nodes, const CoarseMatrix& matrix, int smoothing)
        : shared(ranks, nodes.id),
          smoother(ranks, shared, nodes.id, matrix, smoothing, smoothed_ratio),
          nesting(nest(ranks, shared, nodes, matrix)),
          right(smoother.size(), 0),
          x(smoother.size(), 0),
          left(smoother.size(), 0) {}
    grid::SharedNodes shared;
    NodeSmoother smoother;
    Nesting nesting;
    NodeSmoother::Vector right, x, left;
  };

  void cycle(std::size_t depth) {
    Level& level = levels_[depth];
    const Nesting& nesting = level.nesting;
    const std::size_t nodes = level.smoother.size() / 4;
    level.smoother.smooth(level.right, level.x, true);
    level.smoother.residual(level.right, level.x, level.left);

    const bool last = depth + 1 == levels_.size();
    coarse_.assign(4 * nesting.coarse.id.size(), 0);
    for (std::size_t n = 0; n < nodes; ++n)
      for (std::size_t p = nesting.parent_begin[n]; p < nesting.parent_begin[n + 1]; ++p) {
        double* to = &coarse_[4 * static_cast<std::size_t>(nesting.parent[p])];
        for (std::size_t c = 0; c < 4; ++c) to[c] += nesting.weight[p] * level.left[4 * n + c];
      }
    if (last) {
      solve_last(coarse_);
    } else {
      levels_[depth + 1].right.swap(coarse_);
      cycle(depth + 1);
    }
    const NodeSmoother::Vector& correction = last ? coarse_ : levels_[depth + 1].x;
    for (std::size_t n = 0; n < nodes; ++n)
      for (std::size_t p = nesting.parent_begin[n]; p < nesting.parent_begin[n + 1]; ++p) {
        const double* from = &correction[4 * static_cast<std::size_t>(nesting.parent[p])];
        for (std::size_t c = 0; c < 4; ++c) level.x[4 * n + c] += nesting.weight[p] * from[c];
      }
    level.smoother.smooth(level.right, level.x, false);
  }

  /// In place.
  void solve_last(NodeSmoother::Vector& values) {
    const std::size_t d = dimension_;
    last_right_.resize(last_nodes_ * d);
    last_solution_.resize(last_nodes_ * d);
    for (std::size_t n = 0; n < last_nodes_; ++n)
      for (std::size_t c = 0; c < d; ++c) last_right_[n * d + c] = values[4 * n + c];
    last_->solve(last_right_.data(), last_solution_.data());
    for (std::size_t n = 0; n < last_nodes_; ++n)
      for (std::size_t c = 0; c < d; ++c) values[4 * n + c] = last_solution_[n * d + c];
  }

  std::size_t dimension_;
  double scale_ = std::numeric_limits<double>::min();
  long long unknowns_ = 0;
  std::deque<Level> levels_;
  std::size_t last_nodes_ = 0;
  std::unique_ptr<CoarseSolver> last_;
  NodeSmoother::Vector coarse_;
  std::vector<double> last_right_, last_solution_;
};

}  // namespace

std::unique_ptr<CoarseSolver> make_coarse_solver(const Communicator& ranks, const grid::BackgroundGrid& grid,
                                                 CoarseMatrix matrix, int smoothing, long long factorised_up_to) {
  return std::make_unique<Nested>(ranks, grid, std::move(matrix), smoothing, factorised_up_to);
}

}  // namespace perinox::linear
