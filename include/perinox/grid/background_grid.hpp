#pragma once
#include <array>
#include <vector>

#include "perinox/bonds/bond_graph.hpp"
#include "perinox/grid/cells.hpp"

namespace perinox::grid {

/// The part of one grid cell that particles of one piece of the body fill on this rank (see NodeCopies for pieces).
struct GridElement {
  /// Indices into node_ids(); bit a of a corner's number: upper end on axis a; 2-D: 4 used.
  std::array<LocalIndex, 8> node;
  std::array<double, 3> corner;  ///< lower corner of the cell, length
  LocalIndex begin, end;         ///< range of its particles in BackgroundGrid's order
};

/// The space of functions that are d-linear on the cells of a background grid and continuous across them. Only cells
/// that hold particles take part. A node is copied where the body is parted, so that no function ties the parts
/// together (NodeCopies). The interpolation P takes nodal values to the particles and gives zero on prescribed
/// unknowns. A rank holds the nodes that its own particles need. The coarse level of the preconditioner uses this space
/// today; other discretisations may use it too.
class BackgroundGrid {
 public:
  /// Lays the grid around the body. prescribed: [at least owned * dimension] 1 where an unknown is prescribed. damage:
  /// [owned] broken share of each family, which tells where nodes may have to be copied. spacing: wanted edge of the
  /// cells, a length. Keeps references to the body and to `prescribed`. Collective.
  BackgroundGrid(const body::Body& body, const std::vector<char>& prescribed, const std::vector<double>& damage,
                 const bonds::BondGraph& graph, double spacing);

  int dimension() const { return cells_.dimension(); }
  const Cells& cells() const { return cells_; }
  const std::vector<GridElement>& elements() const { return elements_; }
  /// Local index of particle k in the order of the elements.
  LocalIndex particle(LocalIndex k) const { return order_[k]; }
  /// Ids of this rank's nodes, ascending. A node has the same id on every rank.
  const std::vector<GlobalId>& node_ids() const { return node_ids_; }
  /// Reference positions of these nodes. [nodes * dimension], length
  const std::vector<double>& node_positions() const { return node_positions_; }
  std::size_t unknowns() const { return node_ids_.size() * static_cast<std::size_t>(dimension()); }
  /// Values at the point x [dimension] of an element's functions, in the order of its nodes. values: [4 in 2-D, 8 in
  /// 3-D]
  void shape_values(const GridElement& element, const double* x, double* values) const;

  /// Computes this rank's share of nodal = P^T r. r: [owned * dimension]; coarse (the nodal values): [unknowns()].
  void restrict_to_nodes(const double* r, double* coarse) const;
  /// Adds P applied to nodal values to z. coarse (the nodal values): [unknowns()]; z: [owned * dimension].
  void add_interpolated(const double* coarse, double* z) const;

  std::size_t bytes() const;

 private:
  void clear_monomials() const;
  double* monomials() const;  ///< [elements][corners][4, in 2-D 2] monomials of the function at hand

  const body::Body& body_;
  const std::vector<char>& prescribed_;
  Cells cells_;
  std::vector<GridElement> elements_;
  std::vector<LocalIndex> order_;          ///< [owned] particles by element
  std::vector<LocalIndex> element_;        ///< [owned] element of each particle
  mutable std::vector<double> monomials_;  ///< memory that monomials() points into
  std::vector<GlobalId> node_ids_;
  std::vector<double> node_positions_;
};

}  // namespace perinox::grid
