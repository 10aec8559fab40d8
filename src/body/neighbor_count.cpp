#include "neighbor_count.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace perinox::body {

namespace {

/// Points sorted into equal cells. Cells grow where the points lie far apart, so that there are not more cells than
/// points.
struct Cells {
  std::array<double, 3> low{}, size{1, 1, 1};
  std::array<std::int64_t, 3> count{1, 1, 1};
  std::vector<std::int64_t> begin;
  std::vector<double> sorted;  ///< [points * 3]

  std::array<std::int64_t, 3> at(const double* x, int dimension) const {
    std::array<std::int64_t, 3> cell{};
    for (int c = 0; c < dimension; ++c)
      cell[c] = std::clamp<std::int64_t>(static_cast<std::int64_t>((x[c] - low[c]) / size[c]), 0, count[c] - 1);
    return cell;
  }
  std::int64_t number(const std::array<std::int64_t, 3>& cell) const {
    return (cell[2] * count[1] + cell[1]) * count[0] + cell[0];
  }
};

Cells sort_into_cells(const std::vector<double>& points, int dimension, double reach) {
  const auto total = static_cast<std::int64_t>(points.size()) / dimension;
  Cells cells;
  for (int c = 0; c < dimension; ++c) {
    double low = points[c], high = points[c];
    for (std::int64_t i = 0; i < total; ++i) {
      low = std::min(low, points[i * dimension + c]);
      high = std::max(high, points[i * dimension + c]);
    }
    const double most = std::floor(std::pow(static_cast<double>(total), 1.0 / dimension)) + 1;
    cells.low[c] = low;
    cells.count[c] = static_cast<std::int64_t>(std::clamp(std::floor((high - low) / reach), 1.0, most));
    cells.size[c] = std::max((high - low) / static_cast<double>(cells.count[c]), reach);
  }
  cells.begin.assign(static_cast<std::size_t>(cells.count[0] * cells.count[1] * cells.count[2]) + 1, 0);
  for (std::int64_t i = 0; i < total; ++i) ++cells.begin[cells.number(cells.at(&points[i * dimension], dimension)) + 1];
  for (std::size_t k = 1; k < cells.begin.size(); ++k) cells.begin[k] += cells.begin[k - 1];
  std::vector<std::int64_t> next(cells.begin.begin(), cells.begin.end() - 1);
  cells.sorted.assign(static_cast<std::size_t>(total) * 3, 0.0);
  for (std::int64_t i = 0; i < total; ++i) {
    const std::int64_t to = next[cells.number(cells.at(&points[i * dimension], dimension))]++;
    for (int c = 0; c < dimension; ++c) cells.sorted[to * 3 + c] = points[i * dimension + c];
  }
  return cells;
}

}  // namespace

std::vector<double> count_within(const std::vector<double>& points, int dimension, int queries, double reach) {
  std::vector<double> counts(static_cast<std::size_t>(queries), 0.0);
  if (points.empty()) return counts;
  const double limit = reach * (1 + 1e-10);  // a point at exactly the reach is inside, as for NeighborSearch
  const double square = limit * limit;
  const Cells cells = sort_into_cells(points, dimension, limit);
  for (int i = 0; i < queries; ++i) {
    const double* x = &points[static_cast<std::size_t>(i) * dimension];
    const double y[3] = {x[0], x[1], dimension == 3 ? x[2] : 0};
    const auto here = cells.at(x, dimension);
    std::array<std::int64_t, 3> first{}, last{};
    for (std::size_t c = 0; c < 3; ++c) {
      first[c] = std::max<std::int64_t>(here[c] - 1, 0);
      last[c] = std::min<std::int64_t>(here[c] + 1, cells.count[c] - 1);
    }
    std::int64_t count = -1;
    for (std::int64_t cz = first[2]; cz <= last[2]; ++cz)
      for (std::int64_t cy = first[1]; cy <= last[1]; ++cy) {
        // Neighbouring cells of a row lie one after the other in memory.
        const std::int64_t begin = cells.begin[cells.number({first[0], cy, cz})];
        const std::int64_t end = cells.begin[cells.number({last[0], cy, cz}) + 1];
        for (std::int64_t k = begin; k < end; ++k) {
          const double* p = &cells.sorted[k * 3];
          const double dx = p[0] - y[0], dy = p[1] - y[1], dz = p[2] - y[2];
          count += dx * dx + dy * dy + dz * dz <= square ? 1 : 0;
        }
      }
    counts[i] = static_cast<double>(count);
  }
  return counts;
}

}  // namespace perinox::body
