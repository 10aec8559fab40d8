#include "perinox/solve/newton.hpp"

#include <NOX.H>
#include <NOX_Solver_LineSearchBased.H>
#include <NOX_StatusTest_Generic.H>
#include <NOX_Thyra.H>
#include <fmt/format.h>

#include <NOX_SolverStats.hpp>
#include <Stratimikos_DefaultLinearSolverBuilder.hpp>
#include <Thyra_LinearOpWithSolveFactoryHelpers.hpp>
#include <cmath>

#include "perinox/core/error.hpp"
#include "perinox/solve/equilibrium_model.hpp"

namespace perinox::solve {

namespace {

using Teuchos::RCP;
using Teuchos::rcp;

/// Converged when the residual is small against the reactions and the last update is small against the step; or when
/// nothing but rounding is left. Also tells the observer of every iterate.
class Equilibrium : public NOX::StatusTest::Generic {
 public:
  Equilibrium(EquilibriumModel& model, const mechanics::Committed& committed, const deck::Newton& settings, int step,
              double t, Observer& observer, const Teuchos::ParameterList& linear)
      : model_(model),
        committed_(committed),
        settings_(settings),
        step_(step),
        t_(t),
        observer_(observer),
        linear_(linear) {}

  NOX::StatusTest::StatusType checkStatus(const NOX::Solver::Generic& solver, NOX::StatusTest::CheckType) override {
    const int iteration = solver.getNumIterations();
    if (iteration == seen_) return status_;
    seen_ = iteration;
    NewtonIteration row;
    row.step = step_;
    row.t = t_;
    row.iteration = iteration;
    // The balance of the accepted iterate: a rejected trial of the line search may have been evaluated last.
    const auto& x = vector(solver.getSolutionGroup().getX());
    const ForceBalance& balance = model_.evaluate(x.data());
    row.residual = balance.residual;
    row.relative_residual = balance.relative();
    if (iteration > 0) {
      const auto& before = vector(solver.getPreviousSolutionGroup().getX());
      std::vector<double> squares(2, 0.0);
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
    }
    last = row;
    observer_.newton_iteration(row);
    finite = balance.finite;
    const bool small = row.relative_residual <= settings_.tolerance &&
                       (iteration == 0 || row.relative_update <= settings_.update_tolerance);
    status_ = !finite                                            ? NOX::StatusTest::Failed
              : small || row.residual <= model_.rounding_floor() ? NOX::StatusTest::Converged
              : iteration >= settings_.max_iterations            ? NOX::StatusTest::Failed
                                                                 : NOX::StatusTest::Unconverged;
    return status_;
  }
  NOX::StatusTest::StatusType getStatus() const override { return status_; }
  std::ostream& print(std::ostream& stream, int) const override { return stream; }

  NewtonIteration last;
  bool finite = true;

 private:
  static std::vector<double> vector(const NOX::Abstract::Vector& x) {
    const auto& thyra = dynamic_cast<const NOX::Thyra::Vector&>(x);
    const auto tpetra = Thyra::TpetraOperatorVectorExtraction<double, LocalIndex, GlobalId>::getConstTpetraVector(
        Teuchos::rcpFromRef(thyra.getThyraVector()));
    const auto view = tpetra->getLocalViewHost(Tpetra::Access::ReadOnly);
    return std::vector<double>(view.data(), view.data() + view.extent(0));
  }

  EquilibriumModel& model_;
  const mechanics::Committed& committed_;
  const deck::Newton& settings_;
  int step_;
  double t_;
  Observer& observer_;
  const Teuchos::ParameterList& linear_;
  int seen_ = -1;
  NOX::StatusTest::StatusType status_ = NOX::StatusTest::Unevaluated;
};

RCP<Thyra::LinearOpWithSolveFactoryBase<double>> belos_factory(const deck::Linear& linear, bool symmetric) {
  const bool cg =
      linear.method == deck::LinearMethod::cg || (linear.method == deck::LinearMethod::automatic && symmetric);
  const std::string solver = cg ? "Pseudo Block CG" : "Pseudo Block GMRES";
  auto parameters = rcp(new Teuchos::ParameterList);
  parameters->set("Linear Solver Type", "Belos");
  parameters->set("Preconditioner Type", "None");
  auto& belos = parameters->sublist("Linear Solver Types").sublist("Belos");
  belos.set("Solver Type", solver);
  auto& settings = belos.sublist("Solver Types").sublist(solver);
  settings.set("Maximum Iterations", linear.max_iterations);
  settings.set("Convergence Tolerance", linear.tolerance);
  settings.set("Verbosity", 0);
  settings.set("Output Frequency", -1);
  if (!cg) settings.set("Num Blocks", std::min(linear.max_iterations, 200));
  belos.sublist("VerboseObject").set("Verbosity Level", "none");
  Stratimikos::DefaultLinearSolverBuilder builder;
  builder.setParameterList(parameters);
  auto factory = builder.createLinearSolveStrategy("");
  factory->setVerbLevel(Teuchos::VERB_NONE);
  return factory;
}

}  // namespace

struct Newton::Parts {
  Parts(const deck::Deck& deck_, const mechanics::Scene& scene_, const Boundary& boundary_)
      : deck(deck_),
        scene(scene_),
        boundary(boundary_),
        system(scene_, boundary_.prescribed(), deck_.solver),
        model(rcp(new EquilibriumModel(scene_, boundary_, system))),
        factory(belos_factory(deck_.solver.linear, system.symmetric())),
        external(scene_.owned_unknowns()) {}

  /// Solution of the tangent system at the committed state for the step's change of load and prescribed displacement:
  /// the first guess of the step. Returns linear iterations, or -1 if the linear solver failed.
  int predict(const mechanics::Committed& committed, std::vector<double>& x);
  RCP<Teuchos::ParameterList> nox_parameters() const;

  const deck::Deck& deck;
  const mechanics::Scene& scene;
  const Boundary& boundary;
  TangentSystem system;
  RCP<EquilibriumModel> model;
  RCP<Thyra::LinearOpWithSolveFactoryBase<double>> factory;
  std::vector<double> external;
};

Newton::Newton(const deck::Deck& deck, const mechanics::Scene& scene, const Boundary& boundary)
    : parts_(std::make_unique<Parts>(deck, scene, boundary)) {}
Newton::~Newton() = default;
const TangentSystem& Newton::system() const { return parts_->system; }
TangentSystem& Newton::system() { return parts_->system; }

int Newton::Parts::predict(const mechanics::Committed& committed, std::vector<double>& x) {
  const std::vector<double>& start = committed.displacement();
  const std::vector<char>& fixed = boundary.prescribed();
  const std::size_t unknowns = x.size();
  system.update(committed, start.data());
  system.update_preconditioner();
  model->evaluate(start.data());
  std::vector<double> jump(unknowns, 0.0), stiff(unknowns);
  for (std::size_t u = 0; u < unknowns; ++u)
    if (fixed[u]) jump[u] = x[u] - start[u];
  system.tangent().apply(jump.data(), stiff.data());

  auto right = rcp(new tpetra::Vector(system.map())), left = rcp(new tpetra::Vector(system.map()));
  {
    const auto values = right->getLocalViewHost(Tpetra::Access::OverwriteAll);
    for (std::size_t u = 0; u < unknowns; ++u) values(u, 0) = fixed[u] ? 0 : model->force()[u] + external[u] - stiff[u];
  }
  const auto space = model->get_x_space();
  auto solver = factory->createOp();
  const auto op = model->create_W_op();
  const auto preconditioner = model->create_W_prec();
  if (preconditioner.is_null())
    Thyra::initializeOp<double>(*factory, op, solver.ptr());
  else
    Thyra::initializePreconditionedOp<double>(*factory, op, preconditioner, solver.ptr());
  Thyra::SolveCriteria<double> criteria;
  criteria.requestedTol = deck.solver.linear.tolerance;
  criteria.solveMeasureType.set(Thyra::SOLVE_MEASURE_NORM_RESIDUAL, Thyra::SOLVE_MEASURE_NORM_RHS);
  criteria.extraParameters = Teuchos::parameterList();
  const auto solution = Thyra::createVector<double, LocalIndex, GlobalId>(left, space);
  const auto status =
      Thyra::solve<double>(*solver, Thyra::NOTRANS, *Thyra::createVector<double, LocalIndex, GlobalId>(right, space),
                           solution.ptr(), Teuchos::ptr(&criteria));
  if (status.solveStatus == Thyra::SOLVE_STATUS_UNCONVERGED) return -1;
  const auto values = left->getLocalViewHost(Tpetra::Access::ReadOnly);
  for (std::size_t u = 0; u < unknowns; ++u)
    if (!fixed[u]) x[u] = start[u] + values(u, 0);
  return status.extraParameters.is_null() ? 0 : status.extraParameters->get("Iteration Count", 0);
}

RCP<Teuchos::ParameterList> Newton::Parts::nox_parameters() const {
  const deck::Solver& solver = deck.solver;
  auto all = Teuchos::parameterList();
  all->set("Nonlinear Solver", "Line Search Based");
  auto& newton = all->sublist("Direction").sublist("Newton");
  all->sublist("Direction").set("Method", "Newton");
  const bool inexact = solver.newton.forcing == deck::Forcing::eisenstat_walker;
  newton.set("Forcing Term Method", inexact ? "Type 2" : "Constant");
  newton.set("Forcing Term Initial Tolerance", solver.linear.tolerance);
  newton.set("Forcing Term Maximum Tolerance", solver.linear.tolerance);
  newton.set("Forcing Term Minimum Tolerance", std::min(1e-8, solver.linear.tolerance));
  newton.set("Forcing Term Alpha", 1.5);
  newton.set("Forcing Term Gamma", 0.9);
  newton.set("Rescue Bad Newton Solve", true);
  newton.sublist("Linear Solver").set("Tolerance", solver.linear.tolerance);
  auto& search = all->sublist("Line Search");
  if (solver.newton.line_search == deck::LineSearch::backtrack) {
    search.set("Method", "Backtrack");
    search.sublist("Backtrack").set("Max Iters", 12);
    search.sublist("Backtrack").set("Minimum Step", 1e-3);
    search.sublist("Backtrack").set("Recovery Step", 1e-3);
  } else {
    search.set("Method", "Full Step");
  }
  all->sublist("Printing").set("Output Information", 0);
  all->sublist("Solver Options").set("Status Test Check Type", "Complete");
  return all;
}

NewtonResult Newton::solve(const mechanics::Committed& committed, double t, int step, const std::vector<double>& guess,
                           Observer& observer, mechanics::Trial& trial, std::vector<double>& force) {
  Parts& p = *parts_;
  NewtonResult result;
  p.boundary.external_force(t, p.external.data());
  p.model->set_step(committed, p.external, t);

  std::vector<double> x(committed.displacement().begin(),
                        committed.displacement().begin() + static_cast<std::ptrdiff_t>(p.scene.owned_unknowns()));
  if (!guess.empty()) x = guess;
  p.boundary.impose(t, x.data());
  bool good_guess = p.boundary.free_count() == 0;
  if (!guess.empty()) {
    const ForceBalance& balance = p.model->evaluate(x.data());
    good_guess = good_guess || (balance.finite && balance.relative() < 0.1);
  }
  if (!good_guess) {
    const int iterations = p.predict(committed, x);
    if (iterations < 0) {
      result.reason = fmt::format("the linear solver did not reach {:g} in {} iterations for the first guess",
                                  p.deck.solver.linear.tolerance, p.deck.solver.linear.max_iterations);
      return result;
    }
    result.linear_iterations += iterations;
  }

  auto start = rcp(new tpetra::Vector(p.system.map()));
  {
    const auto values = start->getLocalViewHost(Tpetra::Access::OverwriteAll);
    for (std::size_t u = 0; u < x.size(); ++u) values(u, 0) = x[u];
  }
  const auto space = p.model->get_x_space();
  const NOX::Thyra::Vector initial(Thyra::createVector<double, LocalIndex, GlobalId>(start, space));
  const RCP<Thyra::PreconditionerFactoryBase<double>> no_factory;
  auto group = rcp(
      new NOX::Thyra::Group(initial, p.model, p.model->create_W_op(), p.factory, p.model->create_W_prec(), no_factory));
  auto parameters = p.nox_parameters();
  auto test = rcp(new Equilibrium(*p.model, committed, p.deck.solver.newton, step, t, observer,
                                  parameters->sublist("Direction").sublist("Newton").sublist("Linear Solver")));
  NOX::StatusTest::StatusType status = NOX::StatusTest::Failed;
  std::string trouble;
  try {
    const auto solver = NOX::Solver::buildSolver(group, test, parameters);
    status = solver->solve();
    result.newton_iterations = solver->getNumIterations();
    result.linear_iterations += solver->getSolverStatistics()->linearSolve.allNonlinearSolves_NumLinearIterations;
  } catch (const std::exception& failure) {
    trouble = failure.what();
  } catch (const char* failure) {  // NOX throws bare strings
    trouble = failure;
  }
  if (status == NOX::StatusTest::Converged) {
    result.converged = true;
    trial = std::move(p.model->trial());
    force = p.model->force();
    return result;
  }
  if (!trouble.empty())
    result.reason = "the nonlinear solver gave up: " + trouble;
  else if (!test->finite)
    result.reason = p.model->not_finite();
  else if (test->last.iteration >= p.deck.solver.newton.max_iterations)
    result.reason = fmt::format("Newton did not converge in {} iterations (relative residual {:.2e})",
                                test->last.iteration, test->last.relative_residual);
  else
    result.reason =
        fmt::format("no step length along Newton's direction lowers the residual (relative residual {:.2e})",
                    test->last.relative_residual);
  return result;
}

}  // namespace perinox::solve
