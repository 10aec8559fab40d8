#pragma once
#include <array>

#include "perinox/body/body.hpp"

namespace perinox::grid {

/// A regular background grid of equal box-shaped cells over the bounding box of a body. Cells and nodes are numbered by
/// a key, which is their number in the full grid and the same on every rank. Most keys of a slender body are unused.
class Cells {
 public:
  using Place = std::array<GlobalId, 3>;

  /// Divides the box into a whole number of cells on each axis. Their edge is at most `spacing` (a length) or hardly
  /// more. Collective.
  Cells(const body::Body& body, double spacing);

  int dimension() const { return dimension_; }
  int corners() const { return dimension_ == 3 ? 8 : 4; }
  const std::array<double, 3>& size() const { return size_; }
  /// Number of cells on each axis; it is 1 in z in 2-D.
  const Place& counts() const { return cells_; }
  /// Product of the edges of one cell, length^dimension.
  double volume() const;
  /// Number of nodes of the full grid; every node's key is smaller.
  GlobalId node_count() const;

  /// Key of the cell that holds x, or of the nearest one if x is outside the grid.
  GlobalId cell_at(const double* x) const;
  Place cell_place(GlobalId cell) const { return place(cell, cells_); }
  Place node_place(GlobalId node) const { return place(node, nodes_); }
  /// Position of the lower corner of a cell, or of a node. Length.
  std::array<double, 3> position(const Place& place) const;
  /// Key of the node at a corner of a cell. Bit a of the corner's number is set if it lies at the upper end on axis a.
  GlobalId node_at(const Place& cell, int corner) const;
  /// Key of the cell that is `offset` cells away from a cell, or -1 if it would be outside the grid.
  GlobalId cell_beside(const Place& cell, const std::array<int, 3>& offset) const;

 private:
  static Place place(GlobalId key, const Place& counts);

  int dimension_;
  std::array<double, 3> origin_{}, size_{};
  Place cells_{1, 1, 1}, nodes_{1, 1, 1};
};

}  // namespace perinox::grid
