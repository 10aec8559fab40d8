#pragma once
#include <array>

#include "perinox/body/body.hpp"

namespace perinox::grid {

/// The regular background grid of the coarse level: equal box-shaped cells over the box around a body. Cells and nodes
/// go by a key, their number in the full grid, which is the same on every rank; most keys of a slender body are unused.
class Cells {
 public:
  using Place = std::array<GlobalId, 3>;

  /// Cells of `spacing` (length) at most, or hardly more, on each axis, so that a whole number of them fills the box.
  /// Collective.
  Cells(const body::Body& body, double spacing);

  int dimension() const { return dimension_; }
  int corners() const { return dimension_ == 3 ? 8 : 4; }
  const std::array<double, 3>& size() const { return size_; }
  /// Cells on each axis; 1 in z in 2-D.
  const Place& counts() const { return cells_; }
  /// Product of the edges, length^dimension.
  double volume() const;
  /// Nodes of the full grid: keys of nodes are smaller.
  GlobalId node_count() const;

  /// The cell that holds x, or the nearest one.
  GlobalId cell_at(const double* x) const;
  Place cell_place(GlobalId cell) const { return place(cell, cells_); }
  Place node_place(GlobalId node) const { return place(node, nodes_); }
  /// Lower corner of a cell, or position of a node.
  std::array<double, 3> position(const Place& place) const;
  /// Corner c of a cell: bit a of c set means the upper end on axis a.
  GlobalId node_at(const Place& cell, int corner) const;
  /// The cell `offset` away from a cell, or -1 outside the grid.
  GlobalId cell_beside(const Place& cell, const std::array<int, 3>& offset) const;

 private:
  static Place place(GlobalId key, const Place& counts);

  int dimension_;
  std::array<double, 3> origin_{}, size_{};
  Place cells_{1, 1, 1}, nodes_{1, 1, 1};
};

}  // namespace perinox::grid
