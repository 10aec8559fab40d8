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

std::uint64_t CutCells::key(const Cell& c) {
  constexpr long long mask = (1LL << 20) - 1;
  return static_cast<std::uint64_t>((c[0] & mask) << 40 | (c[1] & mask) << 20 | (c[2] & mask));
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

bool CutCells::empty(const Cell& cell) const {
  CellBox near = box(cell);
  for (std::size_t c = 0; c < static_cast<std::size_t>(lattice_.dimension); ++c) {
    near.lo[c] -= 100 * tolerance_;
    near.hi[c] += 100 * tolerance_;
  }
  return where(solid_, near) == Where::outside;
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
  owned_around(cell, [&](const Cell& other, double share) { volume += share * inside(other); });
  return volume;
}

void CutCells::find_far() {
  if (searched_) return;
  searched_ = true;
  Cell lo{}, hi{};  // a cell more than the lattice on each side
  for (std::size_t c = 0; c < static_cast<std::size_t>(lattice_.dimension); ++c) {
    lo[c] = -1;
    hi[c] = lattice_.cells[c];
  }
  find_far(lo, hi);
}

/// Halves blocks of cells that the surface cuts, down to single cells.
void CutCells::find_far(const Cell& lo, const Cell& hi) {
  CellBox block = box(lo);
  block.hi = box(hi).hi;
  if (where(solid_, block) != Where::cut) return;
  std::size_t longest = 0;
  for (std::size_t c = 1; c < 3; ++c)
    if (hi[c] - lo[c] > hi[longest] - lo[longest]) longest = c;
  if (hi[longest] > lo[longest]) {
    Cell below = hi, above = lo;
    below[longest] = lo[longest] + (hi[longest] - lo[longest]) / 2;
    above[longest] = below[longest] + 1;
    find_far(lo, below);
    find_far(above, hi);
    return;
  }
  if (kept(lo) || !owners(lo).empty() || inside(lo) == 0) return;
  const std::vector<Cell> nearest = nearest_kept(lo);
  for (const Cell& own : nearest) far_[key(own)].push_back({lo, 1 / static_cast<double>(nearest.size())});
}

/// By shells of cells around it.
std::vector<CutCells::Cell> CutCells::nearest_kept(const Cell& cell) const {
  const long long farthest = std::max({lattice_.cells[0], lattice_.cells[1], lattice_.cells[2]}) + 1;
  std::vector<Cell> nearest;
  long long least = std::numeric_limits<long long>::max();
  const long long flat = lattice_.dimension == 3 ? 1 : 0;
  for (long long r = 2; r <= farthest && r * r <= least; ++r)
    for (long long z = -r * flat; z <= r * flat; ++z)
      for (long long y = -r; y <= r; ++y)
        for (long long x = -r; x <= r; x += std::max(std::abs(y), std::abs(z)) == r ? 1 : 2 * r) {
          const long long square = x * x + y * y + z * z;
          const Cell other{cell[0] + x, cell[1] + y, cell[2] + z};
          if (square > least || !kept(other)) continue;
          if (square < least) nearest.clear();
          least = square;
          nearest.push_back(other);
        }
  return nearest;
}

}  // namespace perinox::body
