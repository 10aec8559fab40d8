#include "coarse_elasticity.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "perinox/grid/element_stiffness.hpp"

namespace perinox::linear {

namespace {

/// Moduli of a particle: its material's, or where several materials are in use the mean over it and its family.
class Moduli {
 public:
  Moduli(const medium::Model& model, const bonds::BondGraph& graph)
      : material_(model.body().material), graph_(graph), moduli_(model.local_elasticity()->moduli) {}
  materials::ElasticModuli of(LocalIndex i) const {
    if (moduli_.size() == 1) return moduli_.front();
    graph_(i, neighbors_);
    materials::ElasticModuli mean = moduli_[static_cast<std::size_t>(material_[i])];
    for (const LocalIndex j : neighbors_) {
      mean.bulk += moduli_[static_cast<std::size_t>(material_[j])].bulk;
      mean.shear += moduli_[static_cast<std::size_t>(material_[j])].shear;
    }
    const auto count = static_cast<double>(neighbors_.size() + 1);
    return {mean.bulk / count, mean.shear / count};
  }

 private:
  const std::vector<int>& material_;
  const bonds::BondGraph& graph_;
  std::vector<materials::ElasticModuli> moduli_;
  mutable std::vector<LocalIndex> neighbors_;
};

CoarseMatrix pattern(const grid::BackgroundGrid& grid) {
  const std::size_t nodes = grid.node_ids().size(), corners = static_cast<std::size_t>(grid.cells().corners());
  std::vector<std::vector<LocalIndex>> beside(nodes);
  for (const grid::GridElement& element : grid.elements())
    for (std::size_t a = 0; a < corners; ++a) {
      auto& row = beside[element.node[a]];
      row.insert(row.end(), element.node.begin(), element.node.begin() + static_cast<std::ptrdiff_t>(corners));
    }
  CoarseMatrix matrix;
  matrix.dimension = grid.dimension();
  matrix.row_begin.push_back(0);
  for (std::size_t n = 0; n < nodes; ++n) {
    auto& row = beside[n];
    std::sort(row.begin(), row.end());
    matrix.column.insert(matrix.column.end(), row.begin(), std::unique(row.begin(), row.end()));
    matrix.row_begin.push_back(matrix.column.size());
    std::vector<LocalIndex>().swap(row);
  }
  matrix.value.assign(matrix.column.size() * static_cast<std::size_t>(matrix.dimension * matrix.dimension), 0.0);
  return matrix;
}

}  // namespace

double* CoarseMatrix::block(LocalIndex row, LocalIndex column_node) {
  const auto first = column.begin() + static_cast<std::ptrdiff_t>(row_begin[row]);
  const auto last = column.begin() + static_cast<std::ptrdiff_t>(row_begin[row + 1]);
  const auto at = std::lower_bound(first, last, column_node) - column.begin();
  return &value[static_cast<std::size_t>(at) * static_cast<std::size_t>(dimension * dimension)];
}

namespace {
template <int d>
void add_elements(const medium::Model& model, const grid::BackgroundGrid& grid, const bonds::BondGraph& graph,
                  double bulk_limit, const std::vector<double>& shear_left, CoarseMatrix& matrix) {
  const body::Body& body = model.body();
  const std::array<double, 3>& size = grid.cells().size();
  const Moduli moduli(model, graph);
  const auto stiffness = std::make_unique<grid::ElementStiffness<d>>(size);
  typename grid::ElementStiffness<d>::Blocks blocks;
  grid::CellMoments<d> moments;
  double volume = 0;
  std::array<double, d> edge{}, place{};
  for (const grid::GridElement& element : grid.elements()) {
    moments.clear();
    for (LocalIndex k = element.begin; k < element.end; ++k) {
      const LocalIndex i = grid.particle(k);
      if (body.volume[i] != volume) {
        volume = body.volume[i];
        for (int a = 0; a < d; ++a) edge[a] = std::pow(volume, 1.0 / d) / size[a];
      }
      for (int a = 0; a < d; ++a) place[a] = (body.position(i)[a] - element.corner[a]) / size[a];
      const materials::ElasticModuli own = moduli.of(i);
      moments.add(place, edge, volume * std::min(own.bulk, bulk_limit * own.shear),
                  volume * own.shear * (shear_left.empty() ? 1 : shear_left[i]));
    }
    stiffness->blocks(moments, blocks);
    for (std::size_t a = 0; a < blocks.size(); ++a)
      for (std::size_t b = 0; b < blocks.size(); ++b) {
        double* block = matrix.block(element.node[a], element.node[b]);
        for (std::size_t p = 0; p < d; ++p)
          for (std::size_t q = 0; q < d; ++q) block[p * d + q] += blocks[a][b][p][q];
      }
  }
}
}  // namespace

CoarseMatrix coarse_elasticity(const medium::Model& model, const grid::BackgroundGrid& grid,
                               const bonds::BondGraph& graph, double bulk_limit,
                               const std::vector<double>& shear_left) {
  CoarseMatrix matrix = pattern(grid);
  (grid.dimension() == 3 ? add_elements<3> : add_elements<2>)(model, grid, graph, bulk_limit, shear_left, matrix);
  return matrix;
}

void add_springs(const medium::Model& model, const grid::BackgroundGrid& grid, const std::vector<double>& stiffness,
                 CoarseMatrix& matrix) {
  const int d = grid.dimension(), corners = grid.cells().corners();
  std::array<double, 8> shape{};
  for (const grid::GridElement& element : grid.elements())
    for (LocalIndex k = element.begin; k < element.end; ++k) {
      const LocalIndex i = grid.particle(k);
      const double* springs = &stiffness[static_cast<std::size_t>(i) * static_cast<std::size_t>(d)];
      if (std::all_of(springs, springs + d, [](double s) { return s == 0; })) continue;
      grid.shape_values(element, model.body().position(i), shape.data());
      for (int a = 0; a < corners; ++a)
        for (int b = 0; b < corners; ++b) {
          double* block = matrix.block(element.node[a], element.node[b]);
          for (int c = 0; c < d; ++c) block[c * d + c] += springs[c] * shape[a] * shape[b];
        }
    }
}

}  // namespace perinox::linear
