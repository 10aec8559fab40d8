#include "natural_line_search.hpp"

#include <NOX_Solver_Generic.H>
#include <NOX_Thyra.H>

#include <Thyra_TpetraThyraWrappers.hpp>
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
  using Converter = Thyra::TpetraOperatorVectorExtraction<double, LocalIndex, GlobalId>;
  const auto& residual = dynamic_cast<const NOX::Thyra::Vector&>(trial.getF());
  const auto from = Converter::getConstTpetraVector(Teuchos::rcpFromRef(residual.getThyraVector()));
  const auto right = Teuchos::rcp(new tpetra::Vector(*from, Teuchos::Copy));
  const auto left = Teuchos::rcp(new tpetra::Vector(from->getMap()));
  const linear::LinearOutcome outcome =
      linear::solve_linear(factory_, model_.create_W_op(), model_.create_W_prec(), correction_tolerance, right, left);
  linear_iterations_ += outcome.iterations;
  return outcome.converged ? left->norm2() : std::numeric_limits<double>::infinity();
}

}  // namespace perinox::equilibrium
