#pragma once
#include <map>
#include <utility>
#include <vector>

#include "perinox/bonds/bond_graph.hpp"
#include "perinox/grid/cells.hpp"
#include "perinox/grid/disjoint_sets.hpp"

namespace perinox::grid {

/// Copies of the nodes of a background grid where a body is parted within one node's support, as by a crack, a gap or
/// bodies that are not bonded. The particles of each cell fall into pieces that intact bonds hold together. Among the
/// pieces around a node each connected component gets its own copy of the node. Without copies one function of the grid
/// would tie both faces of a crack together. The result is the same on every rank and for any partition.
class NodeCopies {
 public:
  /// Looks only where the body may be parted: around damaged families, in poorly filled cells and in cells that hold
  /// several bodies. damage: [owned] broken share of each family. Collective.
  NodeCopies(const body::Body& body, const std::vector<double>& damage, const Cells& cells,
             const bonds::BondGraph& graph);

  /// The piece of its cell to which owned particle i belongs, named by the lowest particle id in it; -1 in cells that
  /// were not looked at.
  GlobalId piece(LocalIndex i) const { return piece_.empty() ? -1 : piece_[i]; }
  /// Id of the copy of a grid node that serves a piece. It is the node's key for the first copy; the others have ids
  /// from Cells::node_count() on.
  GlobalId copy_of(GlobalId node, GlobalId piece) const;
  /// Number of copies beyond the first, over all nodes.
  GlobalId extra_copies() const { return extra_copies_; }
  /// Key of the grid node that an id is a copy of.
  GlobalId original(GlobalId id) const;

 private:
  /// members: pieces around a node, ascending; component: which of them belong together.
  void copy_node(GlobalId node, const std::vector<GlobalId>& members, DisjointSets component);

  std::vector<GlobalId> piece_;                             ///< [owned], or empty
  std::map<std::pair<GlobalId, GlobalId>, GlobalId> copy_;  ///< (node, piece) to id; first copies are left out
  std::vector<GlobalId> original_;                          ///< [extra copies] node
  GlobalId first_extra_ = 0, extra_copies_ = 0;
};

}  // namespace perinox::grid
