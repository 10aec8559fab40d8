#pragma once
#include <array>
#include <vector>

#include "perinox/bonds/bond_graph.hpp"
#include "perinox/grid/cells.hpp"

namespace perinox::grid {

/// Part of a grid cell filled by particles of one piece of the body on this rank.
struct GridElement {
  std::array<LocalIndex, 8> node;  ///< local coarse nodes; bit a of the corner's number: upper end on axis a; 2-D: 4
  std::array<double, 3> corner;    ///< lower corner, length
  LocalIndex begin, end;           ///< its particles in BackgroundGrid's order
};

/// The coarse space: d-linear functions on the background grid's cells that hold particles, one copy of a node for each
/// part of the body it must not tie together (NodeCopies). P interpolates from the nodes to the particles, and is
/// zero on prescribed unknowns; a rank holds the nodes its own particles need.
class BackgroundGrid {
 public:
  /// damage: [owned] broken share of each family, where nodes may have to be copied. spacing: edge of the cells,
  /// length. Keeps references to the body and to prescribed [at least owned * dimension]. Collective.
  BackgroundGrid(const body::Body& body, const std::vector<char>& prescribed, const std::vector<double>& damage,
                 const bonds::BondGraph& graph, double spacing);

  int dimension() const { return cells_.dimension(); }
  const Cells& cells() const { return cells_; }
  const std::vector<GridElement>& elements() const { return elements_; }
  /// Particle k of the elements' order.
  LocalIndex particle(LocalIndex k) const { return order_[k]; }
  /// Ids of this rank's coarse nodes, ascending; the same node has the same id on every rank.
  const std::vector<GlobalId>& node_ids() const { return node_ids_; }
  /// Positions of them. [nodes * dimension], length
  const std::vector<double>& node_positions() const { return node_positions_; }
  std::size_t unknowns() const { return node_ids_.size() * static_cast<std::size_t>(dimension()); }
  /// Values at x of an element's functions, in the order of its nodes.
  void shape_values(const GridElement& element, const double* x, double* values) const;

  /// coarse = P^T r, this rank's share: [unknowns()]; r: [owned * dimension].
  void restrict_to_nodes(const double* r, double* coarse) const;
  /// z += P coarse. coarse: [unknowns()]; z: [owned * dimension].
  void add_interpolated(const double* coarse, double* z) const;

  std::size_t bytes() const;

 private:
  void clear_monomials() const;
  double* monomials() const;  ///< [elements][corners][4, in 2-D 2] of the function at hand

  const body::Body& body_;
  const std::vector<char>& prescribed_;
  Cells cells_;
  std::vector<GridElement> elements_;
  std::vector<LocalIndex> order_;          ///< [owned] particles by element
  std::vector<LocalIndex> element_;        ///< [owned] element of each particle
  mutable std::vector<double> monomials_;  ///< the room for them
  std::vector<GlobalId> node_ids_;
  std::vector<double> node_positions_;
};

}  // namespace perinox::grid
