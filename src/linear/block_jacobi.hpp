#pragma once
#include <vector>

#include "owned_operator.hpp"

namespace perinox::linear {

/// Inverse of every particle's own diagonal block of the tangent, prescribed unknowns left out: the preconditioner of
/// the matrix-free tangent. Needs no communication, so its iterations do not depend on the number of ranks.
class BlockJacobi : public OwnedOperator {
 public:
  /// prescribed: [at least owned * dimension]; kept by reference.
  BlockJacobi(Teuchos::RCP<const tpetra::Map> map, int dimension, const std::vector<char>& prescribed);

  /// blocks: [owned * dimension^2], row-major. `diagonal` (positive) stands on the diagonal of prescribed unknowns.
  void set(const std::vector<double>& blocks, double diagonal);
  void multiply(const double* x, double* y) const override;

 private:
  template <int d>
  void multiply_blocks(const double* x, double* y) const;
  template <int d>
  void invert(const std::vector<double>& blocks, double diagonal);

  int d_;
  const std::vector<char>& prescribed_;
  std::vector<float> inverse_;  ///< [owned * dimension^2]
};

}  // namespace perinox::linear
