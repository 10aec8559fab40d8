#include "perinox/body/cut_cells.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "arrangement.hpp"
#include "perinox/body/shape.hpp"
#include "solid_volume.hpp"
#include "vectors.hpp"

namespace perinox::body {

namespace {
/// A particle whose cell the surface leaves next to nothing of still has a volume.
constexpr double least_volume = 1e-6;

/// Different for cells less than 2^20 apart.
std::uint64_t key(const CutCells::Cell& c) {
  constexpr long long mask = (1LL << 20) - 1;
  return static_cast<std::uint64_t>((c[0] & mask) << 40 | (c[1] & mask) << 20 | (c[2] & mask));
}

/// Along every axis the shape's bounding box is a whole number of cells.
bool filled_box(const deck::BodyPart& part, const Lattice& lattice, double tolerance) {
  const auto* box = std::get_if<deck::Box>(&part.shape.form);
  if (!box) return false;
  for (std::size_t c = 0; c < static_cast<std::size_t>(lattice.dimension); ++c) {
    const double filled = static_cast<double>(lattice.cells[c]) * lattice.spacing;
    if (std::abs(box->max[c] - box->min[c] - filled) > tolerance) return false;
  }
  return true;
}
}  // namespace

CutCells::CutCells(const deck::BodyPart& part, int dimension)
    : lattice_(part, dimension), solid_(solid_of(part.shape, dimension)), tolerance_(lattice_.tolerance(part)) {
  cut_ = part.cut_cells;
  filled_ = filled_box(part, lattice_, tolerance_);
}

CutCells::Cell CutCells::cell_of(const deck::Point& position) const {
  Cell cell{};
  for (std::size_t c = 0; c < static_cast<std::size_t>(lattice_.dimension); ++c)
    cell[c] = std::llround((position[c] - lattice_.first[c]) / lattice_.spacing);
  return cell;
}

deck::Point CutCells::center(const Cell& cell) const {
  deck::Point at = lattice_.first;
  for (std::size_t c = 0; c < static_cast<std::size_t>(lattice_.dimension); ++c)
    at[c] += static_cast<double>(cell[c]) * lattice_.spacing;
  return at;
}

CellBox CutCells::box(const Cell& cell) const {
  CellBox box;
  for (std::size_t c = 0; c < static_cast<std::size_t>(lattice_.dimension); ++c) {
    box.lo[c] = lattice_.first[c] + (static_cast<double>(cell[c]) - 0.5) * lattice_.spacing;
    box.hi[c] = lattice_.first[c] + (static_cast<double>(cell[c]) + 0.5) * lattice_.spacing;
  }
  return box;
}

bool CutCells::kept(const Cell& cell) const {
  for (std::size_t c = 0; c < 3; ++c)
    if (cell[c] < 0 || cell[c] >= lattice_.cells[c]) return false;
  return contains(solid_, center(cell));
}

double CutCells::inside(const Cell& cell) {
  const CellBox here = box(cell);
  const Where place = where(solid_, here);
  if (place != Where::cut) return place == Where::inside ? 1 : 0;
  const auto [found, fresh] = inside_.try_emplace(key(cell), 0.0);
  if (fresh) found->second = share_inside(solid_, here);
  return found->second;
}

std::vector<CutCells::Cell> CutCells::owners(const Cell& cell) const {
  std::vector<Cell> nearest;
  long long least = 4;
  around(cell, [&](const Cell& other, long long square) {
    if (square > least || !kept(other)) return;
    if (square < least) nearest.clear();
    least = square;
    nearest.push_back(other);
  });
  return nearest;
}

double CutCells::share_of(const Cell& own, const Cell& other) const {
  const std::vector<Cell> whose = owners(other);
  return std::find(whose.begin(), whose.end(), own) == whose.end() ? 0 : 1 / static_cast<double>(whose.size());
}

bool CutCells::deep(const Cell& cell) const {
  CellBox near = box(cell);
  for (std::size_t c = 0; c < static_cast<std::size_t>(lattice_.dimension); ++c) {
    near.lo[c] -= lattice_.spacing;
    near.hi[c] += lattice_.spacing;
  }
  return where(solid_, near) == Where::inside;
}

double CutCells::volume(const Cell& cell) {
  if (deep(cell)) return 1;
  double volume = std::max(inside(cell), least_volume);
  around(cell, [&](const Cell& other, long long) {
    if (kept(other)) return;
    if (const double part = inside(other); part > 0) volume += part * share_of(cell, other);
  });
  return volume;
}

}  // namespace perinox::body
