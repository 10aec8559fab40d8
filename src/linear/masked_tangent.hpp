#pragma once
#include "owned_operator.hpp"
#include "perinox/medium/tangent.hpp"

namespace perinox::linear {

/// K + shift * diagonal on the free unknowns, `diagonal` on the prescribed ones: coupled to nothing, which keeps it
/// symmetric.
class MaskedTangent : public OwnedOperator {
 public:
  /// tangent, prescribed [at least owned * dimension]: kept by reference.
  MaskedTangent(Teuchos::RCP<const tpetra::Map> map, const medium::Tangent& tangent,
                const std::vector<char>& prescribed)
      : OwnedOperator(std::move(map)), tangent_(tangent), prescribed_(prescribed) {}

  void multiply(const double* x, double* y) const override {
    const std::size_t unknowns = getDomainMap()->getNodeNumElements();
    free_.assign(x, x + unknowns);
    for (std::size_t u = 0; u < unknowns; ++u)
      if (prescribed_[u]) free_[u] = 0;
    tangent_.apply(free_.data(), y);
    for (std::size_t u = 0; u < unknowns; ++u)
      if (prescribed_[u])
        y[u] = diagonal * x[u];
      else if (shift > 0)
        y[u] += shift * diagonal * x[u];
  }

  double diagonal = 1, shift = 0;

 private:
  const medium::Tangent& tangent_;
  const std::vector<char>& prescribed_;
  mutable std::vector<double> free_;
};

}  // namespace perinox::linear
