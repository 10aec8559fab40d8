#include "perinox/solve/equilibrium_test.hpp"

#include <NOX_Solver_LineSearchBased.H>
#include <NOX_Thyra.H>

#include <NOX_SolverStats.hpp>
#include <algorithm>
#include <cmath>

namespace perinox::solve {

namespace {

constexpr double tightest = 1e-8;

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
  // The next update would be about as much smaller than this one as the residual has become.
  const double contraction = iteration > 0 && before > 0 ? std::min(1.0, last_.residual / before) : 1;
  const bool small = last_.relative_residual <= settings_.newton.tolerance &&
                     (iteration == 0 || contraction * last_.relative_update <= settings_.newton.update_tolerance);
  status_ = !finite_                                             ? NOX::StatusTest::Failed
            : small || last_.residual <= model_.rounding_floor() ? NOX::StatusTest::Converged
            : iteration >= settings_.newton.max_iterations       ? NOX::StatusTest::Failed
                                                                 : NOX::StatusTest::Unconverged;
  if (settings_.newton.forcing == deck::Forcing::eisenstat_walker) linear_.set("Tolerance", next_forcing(before));
  return status_;
}

double EquilibriumTest::next_forcing(double before) const {
  const double loosest = settings_.linear.tolerance;
  double forcing = loosest;
  if (last_.iteration > 0 && before > 0) {
    // Eisenstat and Walker's choice 2: as much progress as Newton has just made.
    const double progress = last_.residual / before;
    forcing = std::min(loosest, 0.9 * std::pow(progress, 1.5));
  }
  // Never more than what convergence still needs: the last linear solve of a step is the dearest.
  const double needed = 0.3 * settings_.newton.tolerance / last_.relative_residual;
  return std::min(loosest, std::max({forcing, needed, tightest}));
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
  row.forcing = linear_.get<double>("Tolerance");
  row.step_length = dynamic_cast<const NOX::Solver::LineSearchBased&>(solver).getStepSize();
  return row;
}

}  // namespace perinox::solve
