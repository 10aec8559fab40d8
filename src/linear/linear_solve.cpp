#include "perinox/linear/linear_solve.hpp"

#include <fmt/format.h>

#include <Thyra_BelosLinearOpWithSolveFactory.hpp>
#include <Thyra_DefaultPreconditioner.hpp>
#include <Thyra_LinearOpWithSolveFactoryHelpers.hpp>
#include <Thyra_TpetraLinearOp.hpp>
#include <Thyra_TpetraThyraWrappers.hpp>
#include <Tpetra_Vector.hpp>
#include <algorithm>
#include <exception>

#include "perinox/core/tpetra.hpp"
#include "perinox/linear/tangent_operators.hpp"

namespace perinox::linear {

namespace {

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

Teuchos::RCP<tpetra::Vector> vector_of(const Teuchos::RCP<const tpetra::Map>& map, const std::vector<double>& values) {
  auto vector = Teuchos::rcp(new tpetra::Vector(map));
  const auto view = vector->getLocalViewHost(Tpetra::Access::OverwriteAll);
  for (std::size_t u = 0; u < values.size(); ++u) view(u, 0) = values[u];
  return vector;
}

}  // namespace

LinearOutcome outcome_of(const std::exception& failure) {
  LinearOutcome outcome;
  outcome.failure = failure_of(failure);
  outcome.reason = sentence_of(failure);
  return outcome;
}

struct LinearSolver::Factory {
  Thyra::BelosLinearOpWithSolveFactory<double> belos;
};

LinearSolver::LinearSolver(const deck::Linear& linear, bool symmetric) : factory_(std::make_unique<Factory>()) {
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
  factory_->belos.setParameterList(parameters);
  factory_->belos.setVerbLevel(Teuchos::VERB_NONE);
}

LinearSolver::~LinearSolver() = default;

LinearOutcome LinearSolver::solve(const TangentSystem& system, const std::vector<double>& right, double tolerance,
                                  std::vector<double>& left) const {
  LinearOutcome outcome;
  const Teuchos::RCP<tpetra::Vector> from = vector_of(system.map(), right),
                                     to = Teuchos::rcp(new tpetra::Vector(system.map()));
  left.assign(right.size(), 0.0);
  if (from->norm2() == 0) {
    outcome.converged = true;
    return outcome;
  }
  const auto a = Thyra::createLinearOp<double, LocalIndex, GlobalId>(system.linear_operator());
  const auto solver = factory_->belos.createOp();
  if (system.preconditioner().is_null()) {
    Thyra::initializeOp<double>(factory_->belos, a, solver.ptr());
  } else {
    const Teuchos::RCP<const Thyra::PreconditionerBase<double>> preconditioner =
        Teuchos::rcp(new Thyra::DefaultPreconditioner<double>(
            Thyra::createLinearOp<double, LocalIndex, GlobalId>(system.preconditioner())));
    Thyra::initializePreconditionedOp<double>(factory_->belos, a, preconditioner, solver.ptr());
  }
  Thyra::SolveCriteria<double> criteria;
  criteria.requestedTol = tolerance;
  criteria.solveMeasureType.set(Thyra::SOLVE_MEASURE_NORM_RESIDUAL, Thyra::SOLVE_MEASURE_NORM_RHS);
  criteria.extraParameters = Teuchos::parameterList();
  const auto b = Thyra::createVector<double, LocalIndex, GlobalId>(from, a->range());
  const auto x = Thyra::createVector<double, LocalIndex, GlobalId>(to, a->domain());
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
    outcome = outcome_of(failure);
  }
  const auto values = to->getLocalViewHost(Tpetra::Access::ReadOnly);
  for (std::size_t u = 0; u < left.size(); ++u) left[u] = values(u, 0);
  return outcome;
}

}  // namespace perinox::linear
