#include "perinox/equilibrium/newton.hpp"

#include <NOX.H>
#include <fmt/format.h>

#include <Teuchos_oblackholestream.hpp>
#include <algorithm>
#include <cmath>

#include "energy_descent.hpp"
#include "equilibrium_group.hpp"
#include "equilibrium_test.hpp"
#include "natural_line_search.hpp"
#include "perinox/linear/linear_solve.hpp"

namespace perinox::equilibrium {

using Teuchos::RCP;
using Teuchos::rcp;

namespace {
/// Tolerance of the linear solves where looser ones have not led to equilibrium.
constexpr double careful_tolerance = 1e-5;
/// Linear iterations of one solve from which on a direct solver is taken in scenes of at most so many particles.
constexpr int slow_iterations = 300;
constexpr GlobalId most_direct_plane = 60000, most_direct_solid = 1000;
}  // namespace

struct Newton::Parts {
  Parts(const deck::Solver& solver_, medium::Medium& medium_, const loads::Boundary& boundary_)
      : solver(solver_),
        medium(medium_),
        boundary(boundary_),
        system(medium_, boundary_.prescribed(), solver_),
        model(medium_, boundary_, system, solver.newton),
        linear_solver(solver_.linear, system.symmetric()),
        external(medium_.model().owned_unknowns()) {}

  /// False if a load or a prescribed displacement is infinite or not a number, on any rank. Collective.
  bool loads_finite(const std::vector<double>& x) const;
  /// Solution of the tangent system at the committed state for the step's change of load and prescribed displacement:
  /// the first guess of the step, added to x.
  linear::LinearOutcome predict(std::vector<double>& x);
  RCP<Teuchos::ParameterList> nox_parameters(const RCP<NaturalLineSearch>& natural) const;
  /// NOX's iteration from a displacement. On convergence the model was evaluated at the solution last.
  NewtonResult iterate(const medium::Displacement& start, int step, bool linear_limit_fails, Observer& observer);

  deck::Solver solver;
  medium::Medium& medium;
  const loads::Boundary& boundary;
  linear::TangentSystem system;
  EquilibriumModel model;
  linear::LinearSolver linear_solver;
  std::vector<double> external;
  double iterations_when_made = 0;  ///< linear iterations a solve in the first step
  double last_iterations = 0;       ///< linear iterations a solve in the last step
  int most_iterations = 0;          ///< of one linear solve, in the last step
};

Newton::Newton(const deck::Deck& deck, medium::Medium& medium, const loads::Boundary& boundary)
    : deck_(deck), medium_(medium), boundary_(boundary) {
  make_parts();
}
Newton::~Newton() = default;

void Newton::make_parts() {
  deck::Solver solver = deck_.solver;
  if (direct_) {
    solver.tangent = deck::TangentKind::assembled;
    solver.linear.method = deck::LinearMethod::direct;
  }
  parts_ = std::make_unique<Parts>(solver, medium_, boundary_);
  set_tolerance();
}

void Newton::set_tolerance() {
  const double asked = deck_.solver.linear.tolerance;
  parts_->solver.linear.tolerance = careful_ ? std::min(asked, careful_tolerance) : asked;
}

bool Newton::may_take_direct() const {
  const deck::Solver& asked = deck_.solver;
  const GlobalId most = medium_.model().dimension() == 3 ? most_direct_solid : most_direct_plane;
  return !direct_ && asked.tangent == deck::TangentKind::automatic &&
         asked.linear.method == deck::LinearMethod::automatic &&
         asked.linear.preconditioner == deck::Preconditioner::automatic && deck_.steps.control == deck::Control::load &&
         medium_.model().body().total <= most;
}

void Newton::bonds_changed(bool supports_too) {
  Parts& p = *parts_;
  const bool slower = p.iterations_when_made > 0 && p.last_iterations > 1.5 * p.iterations_when_made + 5;
  if (!supports_too && !p.solver.assembled() && !slower) return;
  make_parts();
}

void Newton::save(StateWriter& writer) const {
  writer.number("newton/iterations_when_made", parts_->iterations_when_made);
  writer.number("newton/last_iterations", parts_->last_iterations);
  parts_->system.save(writer);
}

void Newton::save_remedies(StateWriter& writer) const {
  writer.integer("newton/careful", careful_ ? 1 : 0);
  writer.integer("newton/in_vain", in_vain_ ? 1 : 0);
  writer.integer("newton/direct", direct_ ? 1 : 0);
}

void Newton::restore_remedies(StateReader& reader) {
  careful_ = reader.integer("newton/careful") != 0;
  in_vain_ = reader.integer("newton/in_vain") != 0;
  direct_ = reader.integer("newton/direct") != 0;
  if (direct_) make_parts();
  set_tolerance();
}

void Newton::restore(StateReader& reader) {
  if (reader.has("newton/last_iterations")) {
    parts_->iterations_when_made = reader.number("newton/iterations_when_made");
    parts_->last_iterations = reader.number("newton/last_iterations");
  }
  parts_->system.restore(reader);
}

const linear::TangentSystem& Newton::system() const { return parts_->system; }
linear::TangentSystem& Newton::system() { return parts_->system; }

bool Newton::Parts::loads_finite(const std::vector<double>& x) const {
  double sum = 0;
  for (std::size_t u = 0; u < x.size(); ++u) sum += std::abs(external[u]) + std::abs(x[u]);
  return !medium.model().body().communicator.any(!std::isfinite(sum));
}

linear::LinearOutcome Newton::Parts::predict(std::vector<double>& x) {
  const std::vector<double>& start = medium.displacement();
  const std::vector<char>& fixed = boundary.prescribed();
  linear::LinearOutcome outcome = model.linearise(medium.at());
  if (!outcome.converged) return outcome;
  model.evaluate(medium.at());
  std::vector<double> jump(x.size(), 0.0), stiff(x.size());
  for (std::size_t u = 0; u < x.size(); ++u)
    if (fixed[u]) jump[u] = x[u] - start[u];
  system.tangent().apply(jump.data(), stiff.data());

  std::vector<double> right = model.out_of_balance(), change;
  for (std::size_t u = 0; u < x.size(); ++u)
    if (!fixed[u]) right[u] -= stiff[u];
  outcome = linear_solver.solve(system, right, solver.linear.tolerance, change);
  if (!outcome.converged) return outcome;
  for (std::size_t u = 0; u < x.size(); ++u)
    if (!fixed[u]) x[u] = start[u] + change[u];
  return outcome;
}

RCP<Teuchos::ParameterList> Newton::Parts::nox_parameters(const RCP<NaturalLineSearch>& natural) const {
  auto all = Teuchos::parameterList();
  all->set("Nonlinear Solver", "Line Search Based");
  auto& newton = all->sublist("Direction").sublist("Newton");
  all->sublist("Direction").set("Method", "Newton");
  newton.set("Forcing Term Method", "Constant");  // NewtonProgress has the tolerance of every solve
  newton.set("Rescue Bad Newton Solve", true);
  auto& search = all->sublist("Line Search");
  if (solver.newton.line_search == deck::LineSearch::backtrack) {
    search.set("Method", "User Defined");
    search.set<RCP<NOX::LineSearch::UserDefinedFactory>>("User Defined Line Search Factory",
                                                         rcp(new GivenLineSearch(natural)));
  } else {
    search.set("Method", "Full Step");
  }
  // What NOX would print is said in perinox' own words.
  const RCP<std::ostream> nowhere = rcp(new Teuchos::oblackholestream);
  all->sublist("Printing").set("Output Information", 0).set("Output Stream", nowhere).set("Error Stream", nowhere);
  all->sublist("Solver Options").set("Status Test Check Type", "Complete");
  return all;
}

NewtonResult Newton::solve(double t, int step, const std::vector<double>& guess, Observer& observer,
                           std::vector<double>& force) {
  NewtonResult result = attempt(t, step, guess, observer, force);
  const auto again = [&](const std::string& how) {
    observer.step_rejected(medium_.t(), t, result.reason + "; " + how);
    result = attempt(t, step, guess, observer, force);
  };
  const bool inexact = result.failure == linear::Failure::negative_curvature ||
                       result.failure == linear::Failure::no_progress ||
                       result.failure == linear::Failure::newton_iterations;
  if (inexact && !careful_ && !in_vain_ && !direct_ && deck_.solver.linear.tolerance > careful_tolerance &&
      deck_.steps.control == deck::Control::load) {
    careful_ = true;
    set_tolerance();
    again(fmt::format("again with linear solves to {:g}", careful_tolerance));
    in_vain_ = !result.converged;
    careful_ = !in_vain_;
    set_tolerance();
  }
  if (result.failure == linear::Failure::linear_iterations && may_take_direct()) {
    direct_ = true;
    make_parts();
    again("again with a direct solver");
  } else if (result.converged && parts_->most_iterations > slow_iterations && may_take_direct()) {
    observer.note(
        fmt::format("a linear solve has taken {} iterations: goes on with a direct solver", parts_->most_iterations));
    direct_ = true;
    make_parts();
  }
  if (result.converged) in_vain_ = false;
  return result;
}

NewtonResult Newton::attempt(double t, int step, const std::vector<double>& guess, Observer& observer,
                             std::vector<double>& force) {
  Parts& p = *parts_;
  NewtonResult result;
  p.boundary.external_force(t, p.external.data());
  p.model.set_step(p.external, t);

  std::vector<double> x = medium::owned_displacement(medium_);
  // A rank without particles has an empty guess also where there is one.
  const bool guessed = p.medium.model().body().communicator.any(!guess.empty());
  if (guessed) x = guess;
  p.boundary.impose(t, x.data());
  if (!p.loads_finite(x)) {
    result.failure = linear::Failure::not_finite;
    result.reason = p.boundary.not_finite(t);
    return result;
  }
  medium::Displacement start(x);
  bool good_guess = p.boundary.free_count() == 0;
  if (guessed) {
    // After bonds have broken the guess is where the body is, and its strains are there.
    const bool moved = !std::equal(x.begin(), x.end(), medium_.displacement().begin());
    if (!p.medium.model().body().communicator.any(moved)) p.model.take_for_committed(start.at());
    const ForceBalance& balance = p.model.evaluate(start.at());
    good_guess = good_guess || (balance.finite && p.model.relative_residual() < 0.1);
  }
  int iterations = 0;
  if (!good_guess) {
    const linear::LinearOutcome outcome = p.predict(x);
    if (!outcome.converged) {
      result.failure = outcome.failure;
      result.reason = "no first guess: " + outcome.reason;
      return result;
    }
    iterations = outcome.iterations;
    start.change() = x;
  }
  result = p.iterate(start, step, may_take_direct(), observer);
  result.linear_iterations += iterations;
  if (result.newton_iterations > 0) {
    p.last_iterations = static_cast<double>(result.linear_iterations) / result.newton_iterations;
    if (p.iterations_when_made == 0) p.iterations_when_made = p.last_iterations;
  }
  if (!result.converged) return result;
  force = p.model.force();
  return result;
}

NewtonResult Newton::Parts::iterate(const medium::Displacement& start, int step, bool linear_limit_fails,
                                    Observer& observer) {
  NewtonResult result;
  NewtonProgress progress(solver, observer);
  if (linear_limit_fails) progress.fail_at_linear_limit();
  EquilibriumSolve shared{model, linear_solver, progress};
  const auto natural = rcp(new NaturalLineSearch(shared, model.reach()));
  const auto test = rcp(new EquilibriumTest(shared, solver.newton, step));
  NOX::StatusTest::StatusType status = NOX::StatusTest::Failed;
  try {
    const auto nox = NOX::Solver::buildSolver(rcp(new EquilibriumGroup(shared, start)), test, nox_parameters(natural));
    status = nox->solve();
    result.newton_iterations = nox->getNumIterations();
    result.linear_iterations = shared.all_iterations + natural->linear_iterations();
  } catch (const LinearFailure& failure) {
    result.failure = failure.failure;
    result.reason = failure.what();
  } catch (const std::exception& failure) {
    const linear::LinearOutcome outcome = linear::outcome_of(failure);
    result.failure = outcome.failure;
    result.reason = outcome.reason;
  } catch (const char* failure) {  // NOX throws bare strings
    result.failure = linear::Failure::other;
    result.reason = std::string("NOX stopped: ") + failure;
  }
  most_iterations = progress.most_linear_iterations();
  result.converged = status == NOX::StatusTest::Converged;
  if (result.converged || !result.reason.empty()) return result;
  const NewtonIteration& last = progress.last();
  if (!test->finite()) {
    result.failure = linear::Failure::not_finite;
    result.reason = model.not_finite();
  } else if (progress.at_linear_limit()) {
    result.failure = linear::Failure::linear_iterations;
    result.reason =
        fmt::format("the linear solver did not reach {:.1g} in {} iterations", last.forcing, last.linear_iterations);
  } else if (last.iteration >= solver.newton.max_iterations) {
    result.failure = linear::Failure::newton_iterations;
    result.reason = fmt::format("Newton did not converge in {} iterations (relative residual {:.2e})", last.iteration,
                                last.relative_residual);
  } else {
    result.failure = linear::Failure::no_progress;
    result.reason = fmt::format("no step length along Newton's direction makes progress (relative residual {:.2e})",
                                last.relative_residual);
  }
  return result;
}

NewtonResult Newton::descend(double t, int step, Observer& observer, std::vector<double>& force) {
  NewtonResult result;
  if (!parts_->system.symmetric() || deck_.solver.assembled()) return result;
  std::unique_ptr<Parts> without_matrix;
  if (direct_) without_matrix = std::make_unique<Parts>(deck_.solver, medium_, boundary_);
  Parts& p = direct_ ? *without_matrix : *parts_;
  p.boundary.external_force(t, p.external.data());
  p.model.set_step(p.external, t);
  std::vector<double> x = medium::owned_displacement(medium_);
  p.boundary.impose(t, x.data());
  result = EnergyDescent(p.solver, p.model, p.linear_solver).run(p.external, step, observer, x);
  if (!result.converged) return result;
  force = p.model.force();
  return result;
}

}  // namespace perinox::equilibrium
