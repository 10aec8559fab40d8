#pragma once
#include <cstddef>
#include <vector>

#include "perinox/core/types.hpp"

namespace perinox::linear {

/// Cholesky factors L L^T of a symmetric positive definite matrix of dimension x dimension blocks, themselves of
/// blocks, the nodes in an order of little fill. A solve takes half the time of Eigen's, whose columns are of single
/// numbers. (Blocks in single precision are no faster, and break the symmetry of symmetric bodies: some take iterations
/// more.)
class BlockFactors {
 public:
  /// One block of the lower half, node row >= column. Blocks at the same place add up.
  struct Place {
    LocalIndex row, column;
  };
  /// blocks: [places.size() * dimension^2], row-major; of those on the diagonal the lower half counts. Throws
  /// std::runtime_error where the matrix is not positive definite.
  BlockFactors(int dimension, std::size_t nodes, const std::vector<Place>& places, const std::vector<double>& blocks);

  /// Numbers a node in the vectors of solve(), of which the first `dimension` count and the others are zero.
  std::size_t lanes() const { return dimension_ == 3 ? 4 : 2; }
  std::size_t size() const { return order_.size() * lanes(); }
  /// Where a node's numbers begin in them.
  std::size_t at(std::size_t node) const { return order_[node] * lanes(); }
  /// In place. x: [size()].
  void solve(double* x) const;
  std::size_t bytes() const;

 private:
  int dimension_;
  std::vector<std::size_t> order_;  ///< [nodes] place in the order of elimination
  std::vector<LocalIndex> begin_;   ///< [nodes + 1] blocks below the diagonal of each column
  std::vector<LocalIndex> row_;     ///< ascending within a column
  std::vector<double> blocks_;      ///< [blocks][dimension] columns of lanes()
  std::vector<double> inverse_;     ///< [nodes][dimension] columns of lanes(): of the blocks on the diagonal
};

}  // namespace perinox::linear
