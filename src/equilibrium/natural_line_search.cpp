#include "natural_line_search.hpp"

#include <NOX_Solver_Generic.H>

#include <cmath>
#include <limits>

namespace perinox::equilibrium {

namespace {
constexpr double shortest = 1e-3;
constexpr double correction_tolerance = 0.1;
}  // namespace

bool NaturalLineSearch::compute(NOX::Abstract::Group& trial, double& step, const NOX::Abstract::Vector& direction,
                                const NOX::Solver::Generic& solver) {
  const NOX::Abstract::Group& before = solver.getPreviousSolutionGroup();
  const double residual = before.getNormF(), length = direction.norm();
  for (step = 1; step >= shortest; step *= 0.5) {
    if (step * length > reach_) continue;
    trial.computeX(before, direction, step);
    if (trial.computeF() != NOX::Abstract::Group::Ok) continue;
    const double now = trial.getNormF();
    if (!std::isfinite(now)) continue;
    // The test with a quarter: what a linear solve to a tenth leaves of Deuflhard's half.
    if (now < residual || next_correction(trial) <= (1 - 0.25 * step) * length) return true;
  }
  step = 0;
  trial = before;
  return false;
}

double NaturalLineSearch::next_correction(const NOX::Abstract::Group& trial) {
  const std::vector<double> right = dynamic_cast<const EquilibriumGroup&>(trial).f_values();
  std::vector<double> left;
  const linear::LinearOutcome outcome = solve_.linear.solve(solve_.model.system(), right, correction_tolerance, left);
  linear_iterations_ += outcome.iterations;
  return outcome.converged ? std::sqrt(solve_.model.dot(left, left)) : std::numeric_limits<double>::infinity();
}

}  // namespace perinox::equilibrium
