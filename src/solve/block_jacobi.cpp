#include "perinox/solve/block_jacobi.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/LU>

namespace perinox::solve {

BlockJacobi::BlockJacobi(Teuchos::RCP<const tpetra::Map> map, int dimension, const std::vector<char>& prescribed)
    : OwnedOperator(std::move(map)), d_(dimension), prescribed_(prescribed) {}

void BlockJacobi::set(const std::vector<double>& blocks, double diagonal) {
  inverse_.resize(blocks.size());
  if (d_ == 3)
    invert<3>(blocks, diagonal);
  else
    invert<2>(blocks, diagonal);
}

template <int d>
void BlockJacobi::invert(const std::vector<double>& blocks, double diagonal) {
  using Block = Eigen::Matrix<double, d, d, Eigen::RowMajor>;
  const std::size_t size = d * d;
  for (std::size_t i = 0; i < blocks.size() / size; ++i) {
    Block block = Eigen::Map<const Block>(&blocks[i * size]);
    for (int c = 0; c < d; ++c) {
      if (!prescribed_[i * d + c]) continue;
      block.row(c).setZero();
      block.col(c).setZero();
      block(c, c) = diagonal;
    }
    // A preconditioner for conjugate gradients must be definite: where a softened block is not, the absolute values of
    // its diagonal stand in.
    if (Eigen::LLT<Block>(block).info() != Eigen::Success) {
      const Eigen::Matrix<double, d, 1> positive = block.diagonal().cwiseAbs().cwiseMax(1e-3 * diagonal);
      block = positive.asDiagonal();
    }
    Eigen::Map<Block> inverse(&inverse_[i * size]);
    inverse = block.inverse();
  }
}

template <int d>
void BlockJacobi::multiply_blocks(const double* x, double* y) const {
  for (std::size_t i = 0; i < inverse_.size() / (d * d); ++i)
    for (std::size_t c = 0; c < d; ++c) {
      double sum = 0;
      for (std::size_t e = 0; e < d; ++e) sum += inverse_[(i * d + c) * d + e] * x[i * d + e];
      y[i * d + c] = sum;
    }
}

void BlockJacobi::multiply(const double* x, double* y) const {
  if (d_ == 3)
    multiply_blocks<3>(x, y);
  else
    multiply_blocks<2>(x, y);
}

}  // namespace perinox::solve
