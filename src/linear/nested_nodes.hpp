#pragma once
#include <array>
#include <utility>
#include <vector>

#include "coarse_elasticity.hpp"
#include "perinox/grid/shared_nodes.hpp"

namespace perinox::linear {

/// Nodes of a regular grid on one rank, each part of a body that a crack or a gap cuts off with its own copies.
struct GridNodes {
  std::vector<GlobalId> id;                    ///< ascending; the same node has the same id on every rank
  std::vector<std::array<GlobalId, 3>> place;  ///< number along each axis; copies have the same
};

/// The grid with every second node on each axis, and the d-linear interpolation from it: fine = (W x identity) coarse.
/// What the fine grid does not tie together the coarse one does not either: a coarse node serves those fine nodes
/// around it that entries of the matrix join among themselves, and each other such component gets a copy of it.
/// Linear fields are interpolated exactly, rotations too.
struct Nesting {
  GridNodes coarse;
  std::vector<std::size_t> parent_begin;  ///< [fine nodes + 1]
  std::vector<LocalIndex> parent;         ///< local coarse nodes
  std::vector<double> weight;             ///< of each parent, sum 1 over a node's parents

  /// Where the parents of fine node n begin and end.
  std::pair<std::size_t, std::size_t> parents(std::size_t n) const { return {parent_begin[n], parent_begin[n + 1]}; }
};

/// joined: a matrix over the fine nodes whose pattern says what is tied together on this rank. Collective.
Nesting nest(const Communicator& ranks, const grid::SharedNodes& shared, const GridNodes& fine,
             const CoarseMatrix& joined);

/// W^T A W: this rank's share, as A is. No communication.
CoarseMatrix galerkin(const Nesting& nesting, const CoarseMatrix& fine);

}  // namespace perinox::linear
