#pragma once
/// When a step counts as converged, for NOX. A heavy header: only newton.cpp includes it.
#include <NOX_StatusTest_Generic.H>

#include <Teuchos_ParameterList.hpp>
#include <ostream>

#include "perinox/solve/equilibrium_model.hpp"

namespace perinox::solve {

/// Converged when the residual is small against the reactions and the last update is small against the step; or when
/// nothing but rounding is left. Also tells the observer of every iterate, and sets the tolerance of the next linear
/// solve where it adapts to Newton's progress.
class EquilibriumTest : public NOX::StatusTest::Generic {
 public:
  /// newton: NOX's list of the direction, with the bounds of the forcing term; its "Linear Solver" holds the term.
  /// Everything is kept by reference.
  EquilibriumTest(const EquilibriumModel& model, const mechanics::Committed& committed, const deck::Newton& settings,
                  int step, double t, Observer& observer, Teuchos::ParameterList& newton);

  NOX::StatusTest::StatusType checkStatus(const NOX::Solver::Generic& solver, NOX::StatusTest::CheckType) override;
  NOX::StatusTest::StatusType getStatus() const override { return status_; }
  std::ostream& print(std::ostream& stream, int) const override { return stream; }

  /// The last iterate that was judged.
  const NewtonIteration& last() const { return last_; }
  /// False if its force balance had an infinity or was not a number.
  bool finite() const { return finite_; }

 private:
  NewtonIteration describe(const NOX::Solver::Generic& solver);
  void set_forcing();

  const EquilibriumModel& model_;
  const mechanics::Committed& committed_;
  const deck::Newton& settings_;
  int step_;
  double t_;
  Observer& observer_;
  Teuchos::ParameterList& newton_;
  double before_ = 0;  ///< residual of the iterate before
  NewtonIteration last_;
  bool finite_ = true;
  int judged_ = -1;
  NOX::StatusTest::StatusType status_ = NOX::StatusTest::Unevaluated;
};

}  // namespace perinox::solve
