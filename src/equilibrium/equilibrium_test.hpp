#pragma once
/// When a step counts as converged, for NOX. A heavy header: only newton.cpp includes it.
#include <NOX_StatusTest_Generic.H>

#include <Teuchos_ParameterList.hpp>
#include <ostream>

#include "equilibrium_model.hpp"

namespace perinox::equilibrium {

/// Converged when the residual is small against the reactions and what another update would change is small against the
/// step; or when nothing but rounding is left. Also tells the observer of every iterate.
class EquilibriumTest : public NOX::StatusTest::Generic {
 public:
  /// linear: the list from which NOX's next linear solve takes its tolerance, the forcing term, which this test sets.
  /// Everything is kept by reference.
  EquilibriumTest(const EquilibriumModel& model, const mechanics::Committed& committed, const deck::Solver& settings,
                  int step, double t, Observer& observer, Teuchos::ParameterList& linear);

  NOX::StatusTest::StatusType checkStatus(const NOX::Solver::Generic& solver, NOX::StatusTest::CheckType) override;
  NOX::StatusTest::StatusType getStatus() const override { return status_; }
  std::ostream& print(std::ostream& stream, int) const override { return stream; }

  /// The first linear solve that needs all its iterations fails the step, not only the second.
  void fail_at_linear_limit() { linear_limit_fails_ = true; }
  bool at_linear_limit() const { return at_linear_limit_; }
  /// The most that one linear solve has taken.
  int most_linear_iterations() const { return most_linear_iterations_; }
  /// The last iterate that was judged.
  const NewtonIteration& last() const { return last_; }
  /// False if its force balance had an infinity or was not a number.
  bool finite() const { return finite_; }

 private:
  NewtonIteration describe(const NOX::Solver::Generic& solver);

  const EquilibriumModel& model_;
  const mechanics::Committed& committed_;
  const deck::Solver& settings_;
  int step_;
  double t_;
  Observer& observer_;
  Teuchos::ParameterList& linear_;
  NewtonIteration last_;
  bool finite_ = true;
  bool linear_limit_fails_ = false, at_linear_limit_ = false;
  int most_linear_iterations_ = 0, linear_failures_ = 0;
  int judged_ = -1;
  NOX::StatusTest::StatusType status_ = NOX::StatusTest::Unevaluated;
};

}  // namespace perinox::equilibrium
