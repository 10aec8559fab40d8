#include "perinox/solve/coarse_elasticity.hpp"

#include <algorithm>
#include <cmath>

namespace perinox::solve {

namespace {

/// Stiffness of one full cell with unit modulus, [corners * d] squared, row-major.
struct UnitStiffness {
  int unknowns;
  std::vector<double> bulk, shear;
};

/// Gradients of the element's functions at the point s of the unit cell.
void gradients(const CoarseCells& cells, const std::array<double, 3>& s, std::vector<std::array<double, 3>>& gradient) {
  const int d = cells.dimension();
  for (int c = 0; c < cells.corners(); ++c)
    for (int a = 0; a < d; ++a) {
      double product = ((c >> a & 1) != 0 ? 1 : -1) / cells.size()[static_cast<std::size_t>(a)];
      for (int b = 0; b < d; ++b)
        if (b != a) product *= (c >> b & 1) != 0 ? s[static_cast<std::size_t>(b)] : 1 - s[static_cast<std::size_t>(b)];
      gradient[static_cast<std::size_t>(c)][static_cast<std::size_t>(a)] = product;
    }
}

UnitStiffness unit_stiffness(const CoarseCells& cells) {
  const auto d = static_cast<std::size_t>(cells.dimension()), corners = static_cast<std::size_t>(cells.corners());
  const std::size_t n = corners * d;
  UnitStiffness unit{static_cast<int>(n), std::vector<double>(n * n), std::vector<double>(n * n)};
  std::vector<std::array<double, 3>> g(corners);
  const auto add = [&](double weight) {
    for (std::size_t p = 0; p < n; ++p)
      for (std::size_t q = 0; q < n; ++q) {
        // Unknown p moves corner p/d along axis p%d: e = sym(g e_axis), div = g_axis.
        const auto &gp = g[p / d], &gq = g[q / d];
        const std::size_t a = p % d, b = q % d;
        const double divergence = gp[a] * gq[b];
        double dot = 0;
        for (std::size_t c = 0; c < d; ++c) dot += gp[c] * gq[c];
        const double strain = ((a == b ? dot : 0) + gp[b] * gq[a]) / 2;  // e(u) : e(v)
        unit.bulk[p * n + q] += weight * divergence;
        unit.shear[p * n + q] += weight * 2 * (strain - divergence / static_cast<double>(d));
      }
  };
  const double volume = cells.volume(), gauss = 0.5 / std::sqrt(3.0);
  for (int point = 0; point < cells.corners(); ++point) {
    std::array<double, 3> s{};
    for (std::size_t a = 0; a < d; ++a) s[a] = (point >> a & 1) != 0 ? 0.5 + gauss : 0.5 - gauss;
    gradients(cells, s, g);
    add(volume / static_cast<double>(corners));
  }
  return unit;
}

/// Moduli of a particle: its material's, or where several materials are in use the mean over it and its family.
class Moduli {
 public:
  Moduli(const mechanics::Scene& scene, const bonds::BondGraph& graph)
      : material_(scene.body().material), graph_(graph) {
    for (const auto& material : scene.materials()) moduli_.push_back(material->elastic_moduli(scene.dimension()));
  }
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

CoarseMatrix pattern(const CoarseGrid& grid) {
  const std::size_t nodes = grid.node_ids().size(), corners = static_cast<std::size_t>(grid.cells().corners());
  std::vector<std::vector<LocalIndex>> beside(nodes);
  for (const CoarseElement& element : grid.elements())
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

CoarseMatrix coarse_elasticity(const mechanics::Scene& scene, const CoarseGrid& grid, const bonds::BondGraph& graph,
                               double bulk_limit, const std::vector<double>& shear_left) {
  const UnitStiffness unit = unit_stiffness(grid.cells());
  const int d = grid.dimension(), corners = grid.cells().corners();
  const auto n = static_cast<std::size_t>(unit.unknowns);
  const Moduli moduli(scene, graph);
  CoarseMatrix matrix = pattern(grid);
  for (const CoarseElement& element : grid.elements()) {
    double bulk = 0, elastic_shear = 0, shear = 0;
    for (LocalIndex k = element.begin; k < element.end; ++k) {
      const LocalIndex i = grid.particle(k);
      const double share = scene.body().volume[i] / grid.cells().volume();
      const materials::ElasticModuli own = moduli.of(i);
      bulk += share * own.bulk;
      elastic_shear += share * own.shear;
      shear += share * own.shear * (shear_left.empty() ? 1 : shear_left[i]);
    }
    bulk = std::min(bulk, bulk_limit * elastic_shear);
    for (int a = 0; a < corners; ++a)
      for (int b = 0; b < corners; ++b) {
        double* block = matrix.block(element.node[a], element.node[b]);
        for (int p = 0; p < d; ++p)
          for (int q = 0; q < d; ++q) {
            const std::size_t entry = static_cast<std::size_t>(a * d + p) * n + static_cast<std::size_t>(b * d + q);
            block[p * d + q] += bulk * unit.bulk[entry] + shear * unit.shear[entry];
          }
      }
  }
  return matrix;
}

void add_springs(const mechanics::Scene& scene, const CoarseGrid& grid, const std::vector<double>& stiffness,
                 CoarseMatrix& matrix) {
  const int d = grid.dimension(), corners = grid.cells().corners();
  std::array<double, 8> shape{};
  for (const CoarseElement& element : grid.elements())
    for (LocalIndex k = element.begin; k < element.end; ++k) {
      const LocalIndex i = grid.particle(k);
      const double* springs = &stiffness[static_cast<std::size_t>(i) * static_cast<std::size_t>(d)];
      if (std::all_of(springs, springs + d, [](double s) { return s == 0; })) continue;
      grid.shape_values(element, scene.body().position(i), shape.data());
      for (int a = 0; a < corners; ++a)
        for (int b = 0; b < corners; ++b) {
          double* block = matrix.block(element.node[a], element.node[b]);
          for (int c = 0; c < d; ++c) block[c * d + c] += springs[c] * shape[a] * shape[b];
        }
    }
}

}  // namespace perinox::solve
