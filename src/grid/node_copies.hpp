#pragma once
#include <map>
#include <utility>
#include <vector>

#include "perinox/bonds/bond_graph.hpp"
#include "perinox/grid/cells.hpp"

namespace perinox::grid {

/// Where a body is parted inside the support of one grid node (by a crack, a gap, bodies that are not bonded): the
/// particles of each cell fall into pieces that intact bonds hold together, and among the pieces around a node each
/// connected component gets a copy of the node of its own. Without it one coarse function would tie both faces of a
/// crack together. The same on every rank, for any partition.
class NodeCopies {
 public:
  /// Looks only where something may be parted: around cut families, poorly filled cells and cells of several bodies.
  /// Collective.
  NodeCopies(const body::Body& body, const std::vector<double>& damage, const Cells& cells,
             const bonds::BondGraph& graph);

  /// Piece of its cell that owned particle i is in: the lowest particle id of the piece; -1 where nobody looked.
  GlobalId piece(LocalIndex i) const { return piece_.empty() ? -1 : piece_[i]; }
  /// Id of the copy of a grid node that serves a piece: the node's key for the first copy, ids from
  /// Cells::node_count() on for the others.
  GlobalId copy_of(GlobalId node, GlobalId piece) const;
  /// Copies beyond the first, over all nodes.
  GlobalId extra_copies() const { return extra_copies_; }
  /// The grid node that an id is a copy of.
  GlobalId original(GlobalId id) const;

 private:
  std::vector<GlobalId> piece_;                             ///< [owned], or empty
  std::map<std::pair<GlobalId, GlobalId>, GlobalId> copy_;  ///< (node, piece) to id; first copies are left out
  std::vector<GlobalId> original_;                          ///< [extra copies] node
  GlobalId first_extra_ = 0, extra_copies_ = 0;
};

}  // namespace perinox::grid
