#include "perinox/solve/equilibrium_test.hpp"

#include <NOX_Solver_LineSearchBased.H>
#include <NOX_Thyra.H>

#include <NOX_SolverStats.hpp>
#include <algorithm>
#include <cmath>

namespace perinox::solve {

namespace {

/// The last linear solve of a step aims at this share of the residual that counts as converged.
constexpr double safety = 0.1;

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
                                 const deck::Newton& settings, int step, double t, Observer& observer,
                                 Teuchos::ParameterList& newton)
    : model_(model),
      committed_(committed),
      settings_(settings),
      step_(step),
      t_(t),
      observer_(observer),
      newton_(newton) {}

NOX::StatusTest::StatusType EquilibriumTest::checkStatus(const NOX::Solver::Generic& solver,
                                                         NOX::StatusTest::CheckType) {
  const int iteration = solver.getNumIterations();
  if (iteration == judged_) return status_;  // NOX asks more than once an iteration
  judged_ = iteration;
  last_ = describe(solver);
  observer_.newton_iteration(last_);
  const bool small = last_.relative_residual <= settings_.tolerance &&
                     (iteration == 0 || last_.relative_update <= settings_.update_tolerance);
  status_ = !finite_                                             ? NOX::StatusTest::Failed
            : small || last_.residual <= model_.rounding_floor() ? NOX::StatusTest::Converged
            : iteration >= settings_.max_iterations              ? NOX::StatusTest::Failed
                                                                 : NOX::StatusTest::Unconverged;
  if (status_ == NOX::StatusTest::Unconverged && settings_.forcing == deck::Forcing::eisenstat_walker) set_forcing();
  return status_;
}

// Eisenstat and Walker's second choice; but Newton's steps converge quadratically, and so does the forcing term: without
// the last bound the last solve of a step would go many orders below the residual that is asked for.
void EquilibriumTest::set_forcing() {
  Teuchos::ParameterList& linear = newton_.sublist("Linear Solver");
  const double loosest = newton_.get<double>("Forcing Term Maximum Tolerance");
  double forcing = loosest;
  if (last_.iteration > 0 && last_.residual > 0 && before_ > 0)
    forcing = newton_.get<double>("Forcing Term Gamma") *
              std::pow(last_.residual / before_, newton_.get<double>("Forcing Term Alpha"));
  if (last_.relative_residual > 0) forcing = std::max(forcing, safety * settings_.tolerance / last_.relative_residual);
  forcing = std::max(forcing, newton_.get<double>("Forcing Term Minimum Tolerance"));
  linear.set("Tolerance", std::min(forcing, loosest));
  before_ = last_.residual;
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
  row.relative_residual = balance.relative();
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
  row.forcing = newton_.sublist("Linear Solver").get<double>("Tolerance");
  row.step_length = dynamic_cast<const NOX::Solver::LineSearchBased&>(solver).getStepSize();
  return row;
}

}  // namespace perinox::solve
