#pragma once
#include "owned_operator.hpp"
#include "perinox/body/body.hpp"

namespace perinox::linear {

/// A few steps of Chebyshev's iteration for K z = r from zero, preconditioned by M, as a preconditioner themselves:
///     z = q(M K) M r,   1 - x q(x) = T_n((middle - x)/half) / T_n(middle/half),
/// T_n: Chebyshev's polynomial over an interval of M K's eigenvalues, `middle` give or take `half`. An iteration of the
/// Krylov method then takes n products and n applications of M; their number falls to little more than an n-th, and
/// with it that of the sums over all ranks and of the vectors that GMRES keeps. For odd n, q is positive everywhere:
/// symmetric and positive definite where M is, however good the estimate of the largest eigenvalue.
class ChebyshevAcceleration : public OwnedOperator {
 public:
  /// prescribed: [at least owned * dimension]. All but the map are kept by reference. steps: odd; throws
  /// std::logic_error otherwise.
  ChebyshevAcceleration(Teuchos::RCP<const tpetra::Map> map, const body::Body& body,
                        const std::vector<char>& prescribed, const OwnedOperator& k, const OwnedOperator& m, int steps);

  /// The eigenvalues that the polynomial is made for. highest: 0 where there is no estimate.
  struct Interval {
    double lowest = 0, highest = 0;
  };
  /// Finds the interval for M K as they are now, in at most 15 products. Without one (nothing is free, or K is not
  /// finite) multiply() is M alone. Collective.
  void estimate();
  const Interval& interval() const { return interval_; }
  void set_interval(const Interval& interval) { interval_ = interval; }
  void multiply(const double* x, double* y) const override;

 private:
  const body::Body& body_;
  const std::vector<char>& prescribed_;
  const OwnedOperator& k_;
  const OwnedOperator& m_;
  int steps_;
  Interval interval_;
  mutable std::vector<double> left_, corrected_, direction_;
};

}  // namespace perinox::linear
