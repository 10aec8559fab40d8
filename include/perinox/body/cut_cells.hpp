#pragma once
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "perinox/body/lattice.hpp"

namespace perinox::body {

/// What a shape's surface leaves of the cells of its lattice. A particle stands for the part of its own cell that is
/// inside and, in equal shares, for that of the cells around whose centres are outside and that have no particle
/// nearer; it stays at its cell's centre. Volumes and areas are sampled: to about 1 % of a cell. Every rank can ask for
/// any cell: nothing depends on where the particles are.
class CutCells {
 public:
  using Cell = std::array<long long, 3>;  ///< number of spacings from Lattice::first

  CutCells(const deck::BodyPart& part, int dimension);

  /// True where the body is a box that its cells fill: no cell is cut.
  bool none() const { return none_; }
  Cell cell_of(const deck::Point& position) const;
  /// The cell has a particle: its centre is inside the shape.
  bool kept(const Cell& cell) const;
  /// What is inside of the cell, 0 to 1.
  double inside(const Cell& cell);
  /// Of the cell's particle, over a whole cell's volume: 1 inside.
  double volume(const Cell& cell);
  /// Cells with particles that stand for what is inside of a cell without one: the nearest of those around it.
  std::vector<Cell> owners(const Cell& cell) const;

  /// The surface within a cell.
  struct Patch {
    deck::Point area{};  ///< vector of area, along the outward normal (2-D: of length)
    deck::Point center{};
  };
  /// What of it is not a face of a whole cell (exposed_faces.hpp); its area is zero where there is nothing.
  Patch patch(const Cell& cell);
  /// True where the face towards `axis`, on `side` (-1 or 1) of a particle's cell is all surface: the cell is whole,
  /// and nothing is inside of the next one.
  bool whole_face(const Cell& cell, int axis, int side);

  /// visit(cell, square of the distance in spacings) for the 26 cells (2-D: 8) around one.
  template <class Visit>
  void around(const Cell& cell, const Visit& visit) const;

 private:
  enum class Kind : std::uint8_t { empty, cut, full };
  deck::Point center(const Cell& cell) const;
  bool contains_point(const deck::Point& point) const;
  Kind corners(const Cell& cell) const;
  double sampled(const Cell& cell) const;
  struct Face {
    double inside = 0;    ///< share of the face
    deck::Point first{};  ///< its first moment about the face's centre, over spacing times the face's size
  };
  /// The face on the upper side of a cell along an axis.
  const Face& upper_face(const Cell& cell, int axis);
  const deck::BodyPart& part_;
  Lattice lattice_;
  bool none_ = false;
  std::unordered_map<std::uint64_t, double> inside_;
  std::unordered_map<std::uint64_t, Face> faces_;
};

template <class Visit>
void CutCells::around(const Cell& cell, const Visit& visit) const {
  const long long flat = lattice_.dimension == 3 ? 1 : 0;
  for (long long z = -flat; z <= flat; ++z)
    for (long long y = -1; y <= 1; ++y)
      for (long long x = -1; x <= 1; ++x)
        if (x != 0 || y != 0 || z != 0) visit(Cell{cell[0] + x, cell[1] + y, cell[2] + z}, x * x + y * y + z * z);
}

}  // namespace perinox::body
