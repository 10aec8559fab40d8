#include "equilibrium_test.hpp"

#include <NOX_Solver_LineSearchBased.H>
#include <NOX_Thyra.H>

#include <NOX_SolverStats.hpp>
#include <algorithm>
#include <cmath>

#include "convergence.hpp"

namespace perinox::equilibrium {

namespace {

/// The owned unknowns of one of NOX's vectors.
std::vector<double> values_of(const NOX::Abstract::Vector& x) {
  const auto& thyra = dynamic_cast<const NOX::Thyra::Vector&>(x);
  const auto tpetra = Thyra::TpetraOperatorVectorExtraction<double, LocalIndex, GlobalId>::getConstTpetraVector(
      Teuchos::rcpFromRef(thyra.getThyraVector()));
  const auto view = tpetra->getLocalViewHost(Tpetra::Access::ReadOnly);
  return std::vector<double>(view.data(), view.data() + view.extent(0));
}

}  // namespace

EquilibriumTest::EquilibriumTest(const EquilibriumModel& model, const mechanics::Committed& committed,
                                 const deck::Solver& settings, int step, double t, Observer& observer,
                                 Teuchos::ParameterList& linear)
    : model_(model),
      committed_(committed),
      settings_(settings),
      step_(step),
      t_(t),
      observer_(observer),
      linear_(linear) {}

NOX::StatusTest::StatusType EquilibriumTest::checkStatus(const NOX::Solver::Generic& solver,
                                                         NOX::StatusTest::CheckType) {
  const int iteration = solver.getNumIterations();
  if (iteration == judged_) return status_;  // NOX asks more than once an iteration
  judged_ = iteration;
  const double before = last_.residual;
  last_ = describe(solver);
  observer_.newton_iteration(last_);
  most_linear_iterations_ = std::max(most_linear_iterations_, last_.linear_iterations);
  // One bad linear solve may be a way to a better place; a second one is not.
  if (last_.linear_iterations >= settings_.linear.max_iterations) ++linear_failures_;
  at_linear_limit_ = linear_failures_ > (linear_limit_fails_ ? 0 : 1);
  status_ = !finite_ || at_linear_limit_                                          ? NOX::StatusTest::Failed
            : converged(settings_.newton, last_, before, model_.rounding_floor()) ? NOX::StatusTest::Converged
            : iteration >= settings_.newton.max_iterations                        ? NOX::StatusTest::Failed
                                                                                  : NOX::StatusTest::Unconverged;
  if (settings_.newton.forcing == deck::Forcing::eisenstat_walker)
    linear_.set("Tolerance", next_forcing(settings_, last_, before));
  return status_;
}

NewtonIteration EquilibriumTest::describe(const NOX::Solver::Generic& solver) {
  NewtonIteration row;
  row.step = step_;
  row.t = t_;
  row.iteration = solver.getNumIterations();
  // The balance of the accepted iterate: a rejected trial of the line search may have been evaluated last.
  const std::vector<double> x = values_of(solver.getSolutionGroup().getX());
  const ForceBalance& balance = model_.evaluate(x.data());
  finite_ = balance.finite;
  row.residual = balance.residual;
  row.relative_residual = model_.relative_residual();
  if (row.iteration == 0) return row;

  const std::vector<double> before = values_of(solver.getPreviousSolutionGroup().getX());
  std::vector<double> squares(2, 0.0);  // of the update, of the step's whole increment
  for (std::size_t u = 0; u < x.size(); ++u) {
    squares[0] += (x[u] - before[u]) * (x[u] - before[u]);
    squares[1] += (x[u] - committed_.displacement()[u]) * (x[u] - committed_.displacement()[u]);
  }
  model_.sum(squares);
  row.update = std::sqrt(squares[0]);
  row.relative_update = squares[1] > 0 ? std::sqrt(squares[0] / squares[1]) : 0;
  row.linear_iterations = solver.getSolverStatistics()->linearSolve.lastLinearSolve_NumIterations;
  row.forcing = linear_.get<double>("Tolerance");
  row.step_length = dynamic_cast<const NOX::Solver::LineSearchBased&>(solver).getStepSize();
  return row;
}

}  // namespace perinox::equilibrium
