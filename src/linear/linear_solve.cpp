#include "perinox/linear/linear_solve.hpp"

#include <fmt/format.h>

#include <Thyra_BelosLinearOpWithSolveFactory.hpp>
#include <Thyra_LinearOpWithSolveFactoryHelpers.hpp>
#include <Thyra_TpetraThyraWrappers.hpp>
#include <algorithm>

namespace perinox::linear {

Teuchos::RCP<LinearSolverFactory> belos_factory(const deck::Linear& linear, bool symmetric) {
  const bool cg =
      linear.method == deck::LinearMethod::cg || (linear.method == deck::LinearMethod::automatic && symmetric);
  // A direct solve is the preconditioner; gmres takes it in one iteration whether the tangent is definite or not.
  const bool direct = linear.method == deck::LinearMethod::direct;
  const std::string solver = cg ? "Pseudo Block CG" : "Pseudo Block GMRES";
  auto parameters = Teuchos::parameterList();
  parameters->set("Solver Type", solver);
  auto& settings = parameters->sublist("Solver Types").sublist(solver);
  settings.set("Maximum Iterations", linear.max_iterations);
  settings.set("Convergence Tolerance", linear.tolerance);
  settings.set("Verbosity", 0);
  settings.set("Output Frequency", -1);
  if (!cg) settings.set("Num Blocks", std::min(linear.max_iterations, direct ? 10 : 200));
  parameters->sublist("VerboseObject").set("Verbosity Level", "none");
  // Stratimikos' builder would do the same, but its library brings those of Epetra, ML, AztecOO and Amesos, which cost
  // every start a twentieth of a second.
  auto factory = Teuchos::rcp(new Thyra::BelosLinearOpWithSolveFactory<double>());
  factory->setParameterList(parameters);
  factory->setVerbLevel(Teuchos::VERB_NONE);
  return factory;
}

Failure failure_of(const std::exception& failure) {
  const std::string text = failure.what();
  if (text.find("p^H*A*p") != std::string::npos) return Failure::negative_curvature;
  if (text.find("NaN has been detected") != std::string::npos) return Failure::not_finite;
  return Failure::other;
}

std::string sentence_of(const std::exception& failure) {
  std::string text = failure.what();
  if (failure_of(failure) == Failure::negative_curvature)
    return "conjugate gradients met negative curvature: the tangent is not positive definite here, the body may be "
           "losing its "
           "stability (smaller steps, or solver.linear.method: gmres, go further)";
  if (text.rfind("the direct solver", 0) == 0) return text;  // perinox' own words
  // "file:line:\n\nThrow number = 1\n\nThrow test that evaluated to true: ...\n\nthe message"
  while (!text.empty() && text.back() == '\n') text.pop_back();
  const std::size_t last = text.find_last_of('\n');
  return "Trilinos stopped: " + (last == std::string::npos ? text : text.substr(last + 1));
}

LinearOutcome solve_linear(const LinearSolverFactory& factory, const Teuchos::RCP<const Thyra::LinearOpBase<double>>& a,
                           const Teuchos::RCP<const Thyra::PreconditionerBase<double>>& preconditioner,
                           double tolerance, const Teuchos::RCP<tpetra::Vector>& right,
                           const Teuchos::RCP<tpetra::Vector>& left) {
  LinearOutcome outcome;
  left->putScalar(0.0);
  if (right->norm2() == 0) {
    outcome.converged = true;
    return outcome;
  }
  const auto solver = factory.createOp();
  if (preconditioner.is_null())
    Thyra::initializeOp<double>(factory, a, solver.ptr());
  else
    Thyra::initializePreconditionedOp<double>(factory, a, preconditioner, solver.ptr());
  Thyra::SolveCriteria<double> criteria;
  criteria.requestedTol = tolerance;
  criteria.solveMeasureType.set(Thyra::SOLVE_MEASURE_NORM_RESIDUAL, Thyra::SOLVE_MEASURE_NORM_RHS);
  criteria.extraParameters = Teuchos::parameterList();
  const auto b = Thyra::createVector<double, LocalIndex, GlobalId>(right, a->range());
  const auto x = Thyra::createVector<double, LocalIndex, GlobalId>(left, a->domain());
  try {
    const auto status = Thyra::solve<double>(*solver, Thyra::NOTRANS, *b, x.ptr(), Teuchos::ptr(&criteria));
    outcome.converged = status.solveStatus != Thyra::SOLVE_STATUS_UNCONVERGED;
    if (!status.extraParameters.is_null()) outcome.iterations = status.extraParameters->get("Iteration Count", 0);
    if (!outcome.converged) {
      outcome.failure = Failure::linear_iterations;
      outcome.reason =
          fmt::format("the linear solver did not reach {:g} in {} iterations", tolerance, outcome.iterations);
    }
  } catch (const std::exception& failure) {  // Belos throws where conjugate gradients meet negative curvature
    outcome.failure = failure_of(failure);
    outcome.reason = sentence_of(failure);
  }
  return outcome;
}

}  // namespace perinox::linear
