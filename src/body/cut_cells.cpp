#include "cut_cells.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "arrangement.hpp"
#include "cell_pieces.hpp"
#include "perinox/body/shape.hpp"
#include "perinox/body/shape_intervals.hpp"
#include "solid_volume.hpp"
#include "vectors.hpp"

namespace perinox::body {

namespace {
/// Least volume of a particle over its cell's: it still has one where the surface leaves next to nothing of its cell.
constexpr double least_volume = 1e-6;

/// True if the shape is a box that is a whole number of cells long on every axis.
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

std::vector<CutCells::Piece>& CutCells::pieces_of(const Cell& cell) {
  const auto [found, fresh] = pieces_.try_emplace(key(cell));
  if (fresh) found->second = divide(cell);
  return found->second;
}

std::vector<CutCells::Piece> CutCells::divide(const Cell& cell) {
  const CellBox here = box(cell);
  const double bridged = bridged_gap * lattice_.spacing;
  std::vector<CellPiece> found = pieces_in(solid_, here, bridged);
  std::vector<Piece> pieces;
  double sum = 0;
  for (CellPiece& one : found) {
    pieces.push_back({std::move(one.solid), 0, {}, {}});
    pieces.back().inside = pieces.back().solid ? share_inside(*pieces.back().solid, here) : inside(cell);
    sum += pieces.back().inside;
  }
  // What the surfaces do not divide into parts of the right sum stays together.
  constexpr double rounding = 1e-9;
  if (std::abs(sum - inside(cell)) > rounding) {
    pieces.assign(1, {std::nullopt, inside(cell), {}, {}});
    found.assign(1, {});
  }
  const bool own = found.size() == 1 && kept(cell);
  // Near a convex corner there is no gap between anything.
  const bool anywhere = own || reduced(solid_, box_around(cell)).kind == Solid::Kind::convex;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    if (found[k].samples.empty() && !anywhere) found[k].samples = samples_in(solid_, here);
    pieces[k].owners = own ? std::vector<std::pair<Cell, double>>{{cell, 1.0}}
                           : owners(cell, anywhere ? std::vector<deck::Point>{} : found[k].samples);
    if (pieces[k].owners.empty()) pieces[k].samples = std::move(found[k].samples);
  }
  return pieces;
}

std::vector<std::pair<CutCells::Cell, double>> CutCells::owners(const Cell& cell,
                                                                const std::vector<deck::Point>& samples) const {
  std::vector<std::pair<long long, Cell>> near;
  const auto look = [&](const Cell& other, long long square) {
    if (kept(other)) near.emplace_back(square, other);
  };
  look(cell, 0);
  around(cell, look);
  std::sort(near.begin(), near.end());
  const double bridged = bridged_gap * lattice_.spacing;
  std::vector<std::pair<Cell, double>> owners;
  long long least = 4;
  for (const auto& [square, other] : near) {
    if (square > least) break;
    if (!samples.empty() && !joined(samples, solid_, center(other), bridged)) continue;
    least = square;
    owners.emplace_back(other, 1);
  }
  for (auto& owner : owners) owner.second /= static_cast<double>(owners.size());
  return owners;
}

CellBox CutCells::box_around(const Cell& cell) const {
  CellBox near = box(cell);
  for (std::size_t c = 0; c < static_cast<std::size_t>(lattice_.dimension); ++c) {
    near.lo[c] -= lattice_.spacing;
    near.hi[c] += lattice_.spacing;
  }
  return near;
}

bool CutCells::deep(const Cell& cell) const { return where(solid_, box_around(cell)) == Where::inside; }

double CutCells::volume(const Cell& cell) {
  if (deep(cell)) return 1;
  double volume = 0;
  visit_owned(cell, [&](const Cell&, const Piece& piece, double share) { volume += share * piece.inside; });
  return std::max(volume, least_volume);
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
  if ((kept(lo) && !may_be_divided(solid_, box(lo))) || inside(lo) == 0) return;
  std::vector<Piece>& found = pieces_of(lo);
  for (std::size_t k = 0; k < found.size(); ++k) {
    if (!found[k].owners.empty()) continue;
    // In a thin wedge or fin the particles that are joined to it may be farther away than others across a gap.
    constexpr long long shells = 4;
    std::vector<Cell> nearest;
    if (!found[k].samples.empty()) nearest = nearest_kept(lo, shells, found[k].samples);
    if (nearest.empty()) found[k].owners = owners(lo, {});
    if (nearest.empty() && found[k].owners.empty()) nearest = nearest_kept(lo, farthest(), {});
    for (const Cell& own : nearest) far_[key(own)].push_back({lo, k, 1 / static_cast<double>(nearest.size())});
  }
}

long long CutCells::farthest() const { return std::max({lattice_.cells[0], lattice_.cells[1], lattice_.cells[2]}) + 1; }

/// Looks in one shell of cells after the other around the cell.
std::vector<CutCells::Cell> CutCells::nearest_kept(const Cell& cell, long long shells,
                                                   const std::vector<deck::Point>& samples) const {
  const double bridged = bridged_gap * lattice_.spacing;
  std::vector<Cell> nearest;
  long long least = std::numeric_limits<long long>::max();
  const long long flat = lattice_.dimension == 3 ? 1 : 0;
  for (long long r = 2; r <= shells && r * r <= least; ++r)
    for (long long z = -r * flat; z <= r * flat; ++z)
      for (long long y = -r; y <= r; ++y)
        for (long long x = -r; x <= r; x += std::max(std::abs(y), std::abs(z)) == r ? 1 : 2 * r) {
          const long long square = x * x + y * y + z * z;
          const Cell other{cell[0] + x, cell[1] + y, cell[2] + z};
          if (square > least || !kept(other)) continue;
          if (!samples.empty() && !joined(samples, solid_, center(other), bridged)) continue;
          if (square < least) nearest.clear();
          least = square;
          nearest.push_back(other);
        }
  return nearest;
}

}  // namespace perinox::body
