#include "perinox/bonds/cell_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "perinox/body/spacing.hpp"

namespace perinox::bonds {

namespace {
constexpr std::int64_t lanes = 8;  // cells that the widest vectors hold
constexpr double emptiest = 16;    // most cells of the box a particle
// Rows along another axis than x must be this much better: they make access by particles slower.
constexpr double clearly = 0.95;

/// Padded cells over cells of a row of n cells.
double padding(double n) { return std::ceil(n / lanes) * lanes / n; }
}  // namespace

std::optional<CellGrid> find_grid(const body::Body& body) {
  const int local = body.local();
  if (local == 0) return std::nullopt;
  // All bodies have one spacing, or all are clouds. Anything else that lies on one grid by chance weights its bonds
  // differently.
  if (body.spacing == 0 &&
      std::any_of(body.lattice_spacing.begin(), body.lattice_spacing.end(), [](double spacing) { return spacing > 0; }))
    return std::nullopt;
  const int d = body.dimension;
  CellGrid grid;
  grid.dimension = d;
  grid.spacing = body.spacing > 0 ? body.spacing : body::edge_of(body.volume[0], d);
  const double h = grid.spacing;
  const double tiny = 1e-12 * body.volume[0];
  for (const double volume : body.volume)
    if (body.spacing == 0 && std::abs(volume - body.volume[0]) > tiny) return std::nullopt;

  std::array<double, 3> low{}, high{};
  for (int c = 0; c < d; ++c) low[c] = high[c] = body.reference[c];
  for (int i = 0; i < local; ++i)
    for (int c = 0; c < d; ++c) {
      low[c] = std::min(low[c], body.position(i)[c]);
      high[c] = std::max(high[c], body.position(i)[c]);
    }
  double box = 1;
  std::array<double, 3> extent{1, 1, 1};
  for (int c = 0; c < d; ++c) {
    extent[c] = std::round((high[c] - low[c]) / h) + 1;
    box *= extent[c];
    if (!(box <= emptiest * local + 4096)) return std::nullopt;
  }
  for (int c = 1; c < d; ++c)
    if (padding(extent[c]) < clearly * padding(extent[grid.axis[0]])) std::swap(grid.axis[0], grid.axis[c]);
  for (int k = 0; k < d; ++k) grid.cells[k] = static_cast<std::int64_t>(extent[grid.axis[k]]);
  grid.row = (grid.cells[0] + lanes - 1) / lanes * lanes;
  grid.plane = grid.row * grid.cells[1];
  grid.particle.assign(static_cast<std::size_t>(grid.plane * grid.cells[2]), -1);
  grid.cell.resize(static_cast<std::size_t>(local));
  const std::int64_t strides[3] = {1, grid.row, grid.plane};
  for (int i = 0; i < local; ++i) {
    std::int64_t cell = 0;
    for (int k = 0; k < d; ++k) {
      const int c = grid.axis[k];
      const double x = body.position(i)[c];
      const double steps = std::round((x - low[c]) / h);
      const double rounding = 8 * std::numeric_limits<double>::epsilon() * (std::abs(x) + std::abs(low[c]));
      if (std::abs(x - low[c] - steps * h) > 1e-11 * h + rounding) return std::nullopt;
      cell += static_cast<std::int64_t>(steps) * strides[k];
    }
    if (grid.particle[cell] >= 0) return std::nullopt;
    grid.particle[cell] = i;
    grid.cell[i] = cell;
  }
  return grid;
}

}  // namespace perinox::bonds
