#pragma once
#include <Tpetra_MultiVector.hpp>
#include <Tpetra_Operator.hpp>
#include <Tpetra_Vector.hpp>
#include <vector>

#include "perinox/core/tpetra.hpp"

namespace perinox::linear {

/// Base of perinox's own operators: Tpetra's calling convention around y = A x on the owned unknowns of one vector.
class OwnedOperator : public tpetra::Operator {
 public:
  explicit OwnedOperator(Teuchos::RCP<const tpetra::Map> map) : map_(std::move(map)) {}

  Teuchos::RCP<const tpetra::Map> getDomainMap() const override { return map_; }
  Teuchos::RCP<const tpetra::Map> getRangeMap() const override { return map_; }
  bool hasTransposeApply() const override { return false; }
  void apply(const tpetra::MultiVector& x, tpetra::MultiVector& y, Teuchos::ETransp, double alpha,
             double beta) const override {
    result_.resize(map_->getNodeNumElements());
    for (std::size_t k = 0; k < x.getNumVectors(); ++k) {
      const auto from = x.getVector(k)->getLocalViewHost(Tpetra::Access::ReadOnly);
      multiply(from.data(), result_.data());
      const auto to = y.getVectorNonConst(k)->getLocalViewHost(Tpetra::Access::ReadWrite);
      for (std::size_t u = 0; u < result_.size(); ++u)
        to(u, 0) = beta == 0 ? alpha * result_[u] : alpha * result_[u] + beta * to(u, 0);
    }
  }

  /// y = A x. x, y: [owned unknowns], not overlapping.
  virtual void multiply(const double* x, double* y) const = 0;

 private:
  Teuchos::RCP<const tpetra::Map> map_;
  mutable std::vector<double> result_;
};

}  // namespace perinox::linear
