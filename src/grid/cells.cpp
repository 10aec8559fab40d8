#include "perinox/grid/cells.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace perinox::grid {

namespace {
/// Cells may be wider than asked for as long as all of them together exceed it by no more than this share of a cell.
constexpr double slack = 0.1;
}  // namespace

Cells::Cells(const body::Body& body, double spacing) : dimension_(body.dimension) {
  const Communicator& ranks = body.communicator;
  double volume = 0;
  for (LocalIndex i = 0; i < body.owned; ++i) volume += body.volume[i];
  const double edge = std::pow(ranks.sum(volume) / static_cast<double>(body.total), 1.0 / dimension_);
  for (std::size_t a = 0; a < static_cast<std::size_t>(dimension_); ++a) {
    double low = std::numeric_limits<double>::max(), high = std::numeric_limits<double>::lowest();
    for (LocalIndex i = 0; i < body.owned; ++i) {
      low = std::min(low, body.position(i)[a]);
      high = std::max(high, body.position(i)[a]);
    }
    low = ranks.min(low) - edge / 2;  // a particle stands for the volume around it
    high = ranks.max(high) + edge / 2;
    // Cells are rather a little narrower than `spacing` than wider, but not narrower than two particles.
    const GlobalId wanted = std::llround(std::ceil((high - low) / spacing - slack));
    const GlobalId most =
        std::max(std::llround((high - low) / spacing), std::llround(std::floor((high - low) / (2 * edge) + slack)));
    cells_[a] = std::max<GlobalId>(1, std::min(wanted, most));
    nodes_[a] = cells_[a] + 1;
    origin_[a] = low;
    size_[a] = (high - low) / static_cast<double>(cells_[a]);
  }
}

double Cells::volume() const {
  double product = 1;
  for (std::size_t a = 0; a < static_cast<std::size_t>(dimension_); ++a) product *= size_[a];
  return product;
}

GlobalId Cells::node_count() const { return nodes_[0] * nodes_[1] * nodes_[2]; }

GlobalId Cells::cell_at(const double* x) const {
  Place place{0, 0, 0};
  for (std::size_t a = 0; a < static_cast<std::size_t>(dimension_); ++a) {
    const auto along = static_cast<GlobalId>(std::floor((x[a] - origin_[a]) / size_[a]));
    place[a] = std::clamp<GlobalId>(along, 0, cells_[a] - 1);
  }
  return (place[2] * cells_[1] + place[1]) * cells_[0] + place[0];
}

Cells::Place Cells::place(GlobalId key, const Place& counts) {
  return {key % counts[0], key / counts[0] % counts[1], key / (counts[0] * counts[1])};
}

std::array<double, 3> Cells::position(const Place& place) const {
  std::array<double, 3> x{};
  for (std::size_t a = 0; a < static_cast<std::size_t>(dimension_); ++a)
    x[a] = origin_[a] + static_cast<double>(place[a]) * size_[a];
  return x;
}

GlobalId Cells::node_at(const Place& cell, int corner) const {
  const GlobalId x = cell[0] + (corner & 1), y = cell[1] + (corner >> 1 & 1), z = cell[2] + (corner >> 2 & 1);
  return (z * nodes_[1] + y) * nodes_[0] + x;
}

GlobalId Cells::cell_beside(const Place& cell, const std::array<int, 3>& offset) const {
  Place place = cell;
  for (std::size_t a = 0; a < 3; ++a) {
    place[a] += offset[a];
    if (place[a] < 0 || place[a] >= cells_[a]) return -1;
  }
  return (place[2] * cells_[1] + place[1]) * cells_[0] + place[0];
}

}  // namespace perinox::grid
