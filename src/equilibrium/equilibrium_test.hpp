#pragma once
/// When a step counts as converged, for NOX. A heavy header: only the sources around NOX include it.
#include <NOX_StatusTest_Generic.H>

#include <ostream>

#include "equilibrium_group.hpp"

namespace perinox::equilibrium {

/// Converged when the residual is small against the reactions and what another update would change is small against the
/// step, or when nothing but rounding is left (NewtonProgress). Each iterate is judged once.
class EquilibriumTest : public NOX::StatusTest::Generic {
 public:
  /// solve: kept by reference.
  EquilibriumTest(EquilibriumSolve& solve, const deck::Newton& settings, int step)
      : solve_(solve), settings_(settings), step_(step) {}

  NOX::StatusTest::StatusType checkStatus(const NOX::Solver::Generic& solver, NOX::StatusTest::CheckType) override;
  NOX::StatusTest::StatusType getStatus() const override { return status_; }
  std::ostream& print(std::ostream& stream, int) const override { return stream; }

  /// False if the force balance of the last iterate had an infinity or was not a number.
  bool finite() const { return finite_; }

 private:
  NewtonIteration describe(const NOX::Solver::Generic& solver);

  EquilibriumSolve& solve_;
  const deck::Newton& settings_;
  int step_;
  bool finite_ = true;
  int judged_ = -1;
  NOX::StatusTest::StatusType status_ = NOX::StatusTest::Unevaluated;
};

}  // namespace perinox::equilibrium
