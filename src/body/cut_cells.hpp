#pragma once
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "lattice.hpp"
#include "perinox/body/solid.hpp"

namespace perinox::body {

/// A box with faces along the axes; in 2-D flat at z = 0.
struct CellBox {
  deck::Point lo{}, hi{};
};

/// Tells what a shape's surface leaves of the cells of its lattice (docs/theory.md, section 8). A particle stands for
/// the part of its own cell that is inside. It also stands, in equal shares, for that of cells without a particle that
/// have none nearer. These are mostly cells around its own, in thin fins also cells farther away. The particle stays at
/// its cell's centre. It does not stand for what a gap divides from it, within a cell or between two (bridged_gap).
/// Volumes of shapes with plane faces are exact, those of curved ones to about 1e-8. Every rank can ask for any cell:
/// nothing depends on where the particles are.
class CutCells {
 public:
  using Cell = std::array<long long, 3>;  ///< number of spacings from Lattice::first

  /// part: the body in the deck. Throws std::logic_error for a point cloud.
  CutCells(const deck::BodyPart& part, int dimension);

  /// True if all particles stand for whole cells, because the deck says so or the body is a box that its cells fill.
  bool none() const { return !cut_ || filled_; }
  /// True if the surface of what the particles stand for is the shape's own.
  bool exact() const { return cut_ || filled_; }
  double spacing() const { return lattice_.spacing; }
  /// Distance within which places count as one, length: 1e-9 of the spacing and the rounding of the coordinates.
  double tolerance() const { return tolerance_; }
  const Solid& solid() const { return solid_; }
  Cell cell_of(const deck::Point& position) const;
  CellBox box(const Cell& cell) const;
  /// True if the cell has a particle, which it has if its centre is inside the shape.
  bool kept(const Cell& cell) const;
  /// True if the cell and all cells around it are inside.
  bool deep(const Cell& cell) const;
  /// Share of the cell that is inside, 0 to 1.
  double inside(const Cell& cell);
  /// Volume of the cell's particle over that of a whole cell. It is 1 inside of the shape.
  double volume(const Cell& cell);
  /// One of the pieces into which gaps divide what is in a cell.
  struct Piece {
    std::optional<Solid> solid{};                   ///< the piece's part of the shape; none: all that is in the cell
    double inside = 0;                              ///< volume over a whole cell's
    std::vector<std::pair<Cell, double>> owners{};  ///< cells of the particles that stand for it, and their shares
    std::vector<deck::Point> samples{};             ///< points of the piece, if no particle around is joined to it
  };
  /// Calls visit(cell, piece, share) for every piece for which the cell's particle stands.
  template <class Visit>
  void visit_owned(const Cell& own, const Visit& visit);

 private:
  /// A hash key. It differs for cells less than 2^20 apart.
  static std::uint64_t key(const Cell& cell);
  /// Calls visit(cell, square of the distance in spacings) for the 26 cells (2-D: 8) around one.
  template <class Visit>
  void around(const Cell& cell, const Visit& visit) const;
  deck::Point center(const Cell& cell) const;
  /// The box of the cell and those around it.
  CellBox box_around(const Cell& cell) const;
  std::vector<Piece>& pieces_of(const Cell& cell);
  std::vector<Piece> divide(const Cell& cell);
  /// Cells with particles that stand for a piece of a cell: its own, or the nearest of those around it that no gap
  /// divides from the piece. samples: points of the piece; none: all particles are joined to it.
  std::vector<std::pair<Cell, double>> owners(const Cell& cell, const std::vector<deck::Point>& samples) const;
  /// True if nothing of the shape is in the cell or touches it.
  bool empty(const Cell& cell) const;
  /// A piece of a cell with no particle around it, for which a particle farther away stands.
  struct Far {
    Cell cell;
    std::size_t piece;
    double share;
  };
  void find_far();
  void find_far(const Cell& lo, const Cell& hi);
  /// The nearest cells with particles, in the given number of shells around a cell. samples: points to which the cells'
  /// particles have to be joined; none: they need not be.
  std::vector<Cell> nearest_kept(const Cell& cell, long long shells, const std::vector<deck::Point>& samples) const;
  long long farthest() const;

  Lattice lattice_;
  Solid solid_;
  double tolerance_ = 0;
  bool cut_ = false, filled_ = false;
  std::unordered_map<std::uint64_t, double> inside_;
  std::unordered_map<std::uint64_t, std::vector<Piece>> pieces_;
  bool searched_ = false;
  std::unordered_map<std::uint64_t, std::vector<Far>> far_;  ///< by the owner's cell
};

template <class Visit>
void CutCells::around(const Cell& cell, const Visit& visit) const {
  const long long flat = lattice_.dimension == 3 ? 1 : 0;
  for (long long z = -flat; z <= flat; ++z)
    for (long long y = -1; y <= 1; ++y)
      for (long long x = -1; x <= 1; ++x)
        if (x != 0 || y != 0 || z != 0) visit(Cell{cell[0] + x, cell[1] + y, cell[2] + z}, x * x + y * y + z * z);
}

template <class Visit>
void CutCells::visit_owned(const Cell& own, const Visit& visit) {
  const auto visit_cell = [&](const Cell& cell, long long) {
    if (empty(cell)) return;
    for (const Piece& piece : pieces_of(cell))
      for (const auto& [owner, share] : piece.owners)
        if (owner == own) visit(cell, piece, share);
  };
  find_far();  // pieces that have no owner around get their owners there
  visit_cell(own, 0);
  around(own, visit_cell);
  const auto found = far_.find(key(own));
  if (found == far_.end()) return;
  for (const Far& far : found->second) visit(far.cell, pieces_of(far.cell)[far.piece], far.share);
}

}  // namespace perinox::body
