#include "block_jacobi.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/LU>

namespace perinox::linear {

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
    const Block inverse = block.inverse();
    Eigen::Map<Eigen::Matrix<float, d, d>> kept(&inverse_[i * size]);
    kept = (0.5 * (inverse + inverse.transpose())).template cast<float>();
  }
}

template <int d>
void BlockJacobi::multiply_blocks(const double* x, double* y) const {
  for (std::size_t i = 0; i < inverse_.size() / (d * d); ++i)
    Eigen::Map<Eigen::Matrix<double, d, 1>>(y + i * d) =
        Eigen::Map<const Eigen::Matrix<float, d, d>>(&inverse_[i * d * d]).template cast<double>() *
        Eigen::Map<const Eigen::Matrix<double, d, 1>>(x + i * d);
}

void BlockJacobi::multiply(const double* x, double* y) const {
  if (d_ == 3)
    multiply_blocks<3>(x, y);
  else
    multiply_blocks<2>(x, y);
}

}  // namespace perinox::linear
