#pragma once
#include <vector>

#include "coarse_elasticity.hpp"
#include "perinox/grid/shared_nodes.hpp"

namespace perinox::linear {

/// A matrix of blocks over nodes, and Chebyshev's smoother of it in the scale of its diagonal blocks. The blocks are
/// kept in single precision, which is all the time their reading takes; everything is computed in double precision, or
/// GMRES would not find the smoother linear enough near a limit point. Vectors have four numbers a node, of which the
/// first `dimension` count and the others are zero. A share adds up over the ranks; anything else is the same on all
/// ranks that hold a node.
class NodeSmoother {
 public:
  using Vector = std::vector<double>;

  /// matrix: this rank's share. degree: products a smoothing, from a guess that is not zero. ratio: of the largest
  /// eigenvalue to the lowest one that it shall treat. id: of the nodes. Collective.
  NodeSmoother(const Communicator& ranks, const grid::SharedNodes& shared, const std::vector<GlobalId>& id,
               const CoarseMatrix& matrix, int degree, double ratio);

  std::size_t size() const { return begin_.empty() ? 0 : 4 * (begin_.size() - 1); }
  /// Brings x nearer to the solution of A x = right; x is taken for zero if it is said to be. right: share. Collective.
  void smooth(const Vector& right, Vector& x, bool from_zero) const;
  /// left = right - A x, all of them shares but x.
  void residual(const Vector& right, const Vector& x, Vector& left) const;
  std::size_t bytes() const;

 private:
  void multiply_diagonal(const Vector& x, Vector& y) const;

  const grid::SharedNodes& shared_;
  int dimension_, degree_;
  std::vector<LocalIndex> begin_, column_;
  std::vector<float> blocks_;  ///< [blocks][dimension] columns of four
  Vector inverse_diagonal_;    ///< [nodes][dimension] columns of four
  double lowest_ = 0, highest_ = 0;
  mutable Vector work_, direction_, scaled_;
};

}  // namespace perinox::linear
