#include "equilibrium_test.hpp"

#include <NOX_Solver_LineSearchBased.H>

#include <cmath>

namespace perinox::equilibrium {

NOX::StatusTest::StatusType EquilibriumTest::checkStatus(const NOX::Solver::Generic& solver,
                                                         NOX::StatusTest::CheckType) {
  const int iteration = solver.getNumIterations();
  if (iteration == judged_) return status_;  // NOX asks more than once an iteration
  judged_ = iteration;
  const NewtonIteration row = describe(solver);
  solve_.progress.add(row, solve_.model.rounding_floor());
  status_ = !finite_ || solve_.progress.at_linear_limit() ? NOX::StatusTest::Failed
            : solve_.progress.converged()                 ? NOX::StatusTest::Converged
            : iteration >= settings_.max_iterations       ? NOX::StatusTest::Failed
                                                          : NOX::StatusTest::Unconverged;
  return status_;
}

NewtonIteration EquilibriumTest::describe(const NOX::Solver::Generic& solver) {
  NewtonIteration row;
  row.step = step_;
  row.t = solve_.model.t();
  row.iteration = solver.getNumIterations();
  // The balance of the accepted iterate: a rejected trial of the line search may have been evaluated last.
  const auto& group = dynamic_cast<const EquilibriumGroup&>(solver.getSolutionGroup());
  const ForceBalance& balance = solve_.model.evaluate(group.at());
  finite_ = balance.finite;
  row.residual = balance.residual;
  row.relative_residual = solve_.model.relative_residual();
  if (row.iteration == 0) return row;

  const std::vector<double>& x = group.displacement();
  std::vector<double> update = dynamic_cast<const EquilibriumGroup&>(solver.getPreviousSolutionGroup()).displacement();
  for (std::size_t u = 0; u < x.size(); ++u) update[u] = x[u] - update[u];
  row.update = std::sqrt(solve_.model.dot(update, update));
  const double increment = solve_.model.away_from_start(x);
  row.relative_update = increment > 0 ? row.update / increment : 0;
  row.linear_iterations = solve_.linear_iterations;
  row.forcing = solve_.forcing;
  row.step_length = dynamic_cast<const NOX::Solver::LineSearchBased&>(solver).getStepSize();
  return row;
}

}  // namespace perinox::equilibrium
