#include "perinox/equilibrium/bordered_newton.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "equilibrium_model.hpp"
#include "newton_progress.hpp"
#include "perinox/linear/linear_solve.hpp"

namespace perinox::equilibrium {

namespace {
/// Halvings of a Newton step that does not lower the residual.
constexpr int most_halvings = 6;
}  // namespace

struct BorderedNewton::Parts {
  Parts(const deck::Deck& deck_, medium::Medium& medium_, const loads::Boundary& boundary_,
        linear::TangentSystem& system_)
      : deck(deck_),
        medium(medium_),
        boundary(boundary_),
        system(system_),
        model(medium_, boundary_, system_, deck_.solver.newton),
        unknowns(medium_.model().owned_unknowns()),
        solver(deck_.solver.linear, system_.symmetric()),
        external(unknowns),
        load_rate(unknowns, 0.0) {
    if (deck_.solver.linear.method != deck::LinearMethod::automatic || !system_.symmetric()) return;
    deck::Linear gmres = deck_.solver.linear;
    gmres.method = deck::LinearMethod::gmres;
    indefinite_solver.emplace(gmres, false);
  }

  const ForceBalance& evaluate(const PathPoint& at);
  /// left = K^-1 right on the free unknowns, 0 on the prescribed ones, with what `right` has on the free ones.
  linear::LinearOutcome solve_tangent(std::vector<double> right, double tolerance, std::vector<double>& left);
  /// Derivatives with t of the external force and of the prescribed displacements at t.
  std::string differentiate(double t, std::vector<double>& force, std::vector<double>& displacement) const;
  /// load_rate = b at the point last linearised at.
  linear::LinearOutcome find_rate(double t, double tolerance);
  /// Newton's change of the point last evaluated and linearised at.
  linear::LinearOutcome direction(const PathPoint& at, const PathConstraint& constraint, double forcing,
                                  PathPoint& change);
  /// Moves `at` along the change, all of it or the half, quarter, ... that lowers the residual, and evaluates there.
  /// Returns the share; 0 if none does.
  double advance(const PathConstraint& constraint, const PathPoint& change, PathPoint& at);

  const deck::Deck& deck;
  medium::Medium& medium;
  const loads::Boundary& boundary;
  linear::TangentSystem& system;
  EquilibriumModel model;
  std::size_t unknowns;
  linear::LinearSolver solver;
  std::optional<linear::LinearSolver> indefinite_solver;  ///< where it may stand in for conjugate gradients
  bool indefinite = false;                                ///< conjugate gradients met negative curvature
  bool stiffening = true;                                 ///< more load moves its points along, q.b > 0
  std::vector<double> external;
  std::vector<double> load_rate;  ///< the last b: the next one starts from it
};

BorderedNewton::BorderedNewton(const deck::Deck& deck, medium::Medium& medium, const loads::Boundary& boundary,
                               linear::TangentSystem& system)
    : parts_(std::make_unique<Parts>(deck, medium, boundary, system)) {}
BorderedNewton::~BorderedNewton() = default;
bool BorderedNewton::indefinite() const { return parts_->indefinite; }

const ForceBalance& BorderedNewton::Parts::evaluate(const PathPoint& at) {
  boundary.external_force(at.t, external.data());
  model.set_step(external, at.t);
  return model.evaluate(at.displacement.at());
}

linear::LinearOutcome BorderedNewton::Parts::solve_tangent(std::vector<double> right, double tolerance,
                                                           std::vector<double>& left) {
  for (std::size_t u = 0; u < unknowns; ++u)
    if (boundary.prescribed()[u]) right[u] = 0;
  linear::LinearOutcome outcome;
  if (!indefinite) outcome = solver.solve(system, right, tolerance, left);
  if (!outcome.converged && indefinite_solver) {
    indefinite = true;
    const int wasted = outcome.iterations;
    outcome = indefinite_solver->solve(system, right, tolerance, left);
    outcome.iterations += wasted;
  }
  left.resize(unknowns);
  for (std::size_t u = 0; u < unknowns; ++u)
    if (boundary.prescribed()[u]) left[u] = 0;
  return outcome;
}

std::string BorderedNewton::Parts::differentiate(double t, std::vector<double>& force,
                                                 std::vector<double>& displacement) const {
  const double h = 1e-4 * deck.steps.end / deck.steps.count;
  const auto at = [&](double load, std::vector<double>& forces, std::vector<double>& displacements) {
    forces.assign(unknowns, 0.0);
    displacements.assign(unknowns, 0.0);
    boundary.external_force(load, forces.data());
    boundary.impose(load, displacements.data());
  };
  std::vector<double> force_below, displacement_below;
  // Where a formula holds on one side only (sqrt(t) at 0), or the loads turn back, the difference over a side.
  bool finite = false;
  for (const auto& [below, above] : {std::pair{t - h, t + h}, std::pair{t, t + h}, std::pair{t - h, t}}) {
    at(below, force_below, displacement_below);
    at(above, force, displacement);
    double check = 0;
    bool moves = false;  // by more than rounding: about a peak the two sides may cancel
    const auto differ = [](double a, double b) { return std::abs(a - b) > 1e-12 * std::max(std::abs(a), std::abs(b)); };
    for (std::size_t u = 0; u < unknowns; ++u) {
      moves = moves || differ(force[u], force_below[u]) || differ(displacement[u], displacement_below[u]);
      force[u] = (force[u] - force_below[u]) / (above - below);
      displacement[u] = (displacement[u] - displacement_below[u]) / (above - below);
      check += force[u] + displacement[u];
    }
    if (medium.model().body().communicator.any(!std::isfinite(check))) continue;
    finite = true;
    if (medium.model().body().communicator.any(moves)) return "";
  }
  if (finite) {  // they do not change
    force.assign(unknowns, 0.0);
    displacement.assign(unknowns, 0.0);
    return "";
  }
  return fmt::format("the loads have no derivative with t at t = {:g}", t);
}

linear::LinearOutcome BorderedNewton::Parts::find_rate(double t, double tolerance) {
  linear::LinearOutcome outcome;
  std::vector<double> force, start;
  outcome.reason = differentiate(t, force, start);
  if (!outcome.reason.empty()) return outcome;
  const auto left_over = [&](const std::vector<double>& rate) {  // of the rate of the loads, on free unknowns
    std::vector<double> rest(unknowns);
    system.tangent().apply(rate.data(), rest.data());
    for (std::size_t u = 0; u < unknowns; ++u) rest[u] = boundary.prescribed()[u] ? 0 : force[u] - rest[u];
    return rest;
  };
  const std::vector<double> right = left_over(start);
  std::vector<double> rest = right;
  const double size = std::sqrt(model.dot(right, right));
  if (size == 0) {
    outcome.reason = fmt::format("the loads do not change with t at t = {:g}", t);
    return outcome;
  }
  // The rate changes little from iterate to iterate: the last one is a start that leaves little to solve for.
  std::vector<double> last = start;
  for (std::size_t u = 0; u < unknowns; ++u)
    if (!boundary.prescribed()[u]) last[u] = load_rate[u];
  std::vector<double> less = left_over(last);
  if (model.dot(less, less) < model.dot(rest, rest)) {
    rest = std::move(less);
    start = std::move(last);
  }
  load_rate = std::move(start);
  const double share = std::sqrt(model.dot(rest, rest)) / size;
  outcome.converged = true;
  if (share > tolerance) {
    std::vector<double> change;
    outcome = solve_tangent(rest, tolerance / share, change);
    for (std::size_t u = 0; u < unknowns; ++u) load_rate[u] += change[u];
  }
  stiffening = model.dot(right, load_rate) > 0;
  return outcome;
}

NewtonResult BorderedNewton::rate(PathPoint& rate) {
  Parts& p = *parts_;
  p.model.set_step(p.external, p.medium.t());
  linear::LinearOutcome outcome = p.model.linearise(p.medium.at());
  if (outcome.converged) outcome = p.find_rate(p.medium.t(), p.deck.solver.linear.tolerance);
  rate = {medium::Displacement(p.load_rate), 1};
  NewtonResult result;
  result.converged = outcome.converged;
  result.reason = outcome.reason;
  result.linear_iterations = outcome.iterations;
  return result;
}

double BorderedNewton::relative_residual(const PathPoint& point) {
  const ForceBalance& balance = parts_->evaluate(point);
  return balance.finite ? parts_->model.relative_residual() : std::numeric_limits<double>::infinity();
}

linear::LinearOutcome BorderedNewton::Parts::direction(const PathPoint& at, const PathConstraint& constraint,
                                                       double forcing, PathPoint& change) {
  const linear::LinearOutcome rate = find_rate(at.t, std::min(forcing, deck.solver.linear.tolerance));
  if (!rate.converged) return rate;
  change.t = 0;
  linear::LinearOutcome outcome = solve_tangent(model.out_of_balance(), forcing, change.displacement.change());
  outcome.iterations += rate.iterations;
  if (!outcome.converged) return outcome;
  const PathPoint along{medium::Displacement(load_rate), 1};
  const double slope = constraint.slope(at, along);
  change.t = -(constraint.value(at) + constraint.slope(at, change)) / slope;
  if (!std::isfinite(change.t)) {
    outcome.converged = false;
    outcome.reason = "the constraint of the step does not change along the path";
    return outcome;
  }
  std::vector<double>& moved = change.displacement.change();
  for (std::size_t u = 0; u < unknowns; ++u) moved[u] += change.t * load_rate[u];
  return outcome;
}

double BorderedNewton::Parts::advance(const PathConstraint& constraint, const PathPoint& change, PathPoint& at) {
  const PathPoint from = at;
  const double before = model.balance().residual;
  // While the constraint is still to be met the residual may well have to grow.
  const bool search = deck.solver.newton.line_search == deck::LineSearch::backtrack &&
                      std::abs(constraint.value(from)) <= 10 * constraint.tolerance();
  double length = 1;
  for (int halving = 0; halving <= most_halvings; ++halving, length /= 2) {
    at.t = from.t + length * change.t;
    std::vector<double>& to = at.displacement.change();
    for (std::size_t u = 0; u < unknowns; ++u)
      to[u] = from.displacement.values()[u] + length * change.displacement.values()[u];
    boundary.impose(at.t, to.data());
    const ForceBalance& balance = evaluate(at);
    if (!search || (balance.finite && balance.residual <= (1 - 1e-4 * length) * before) ||
        balance.residual <= model.rounding_floor())
      return length;
  }
  return 0;
}

NewtonResult BorderedNewton::solve(PathPoint& point, const PathConstraint& constraint, int most_iterations, int step,
                                   Observer& observer, std::vector<double>& force) {
  Parts& p = *parts_;
  if (p.stiffening) p.indefinite = false;  // conjugate gradients are worth another try
  NewtonResult result;
  p.boundary.impose(point.t, point.displacement.change().data());
  p.evaluate(point);
  NewtonProgress progress(p.deck.solver, observer);
  NewtonIteration row;
  row.step = step;
  while (true) {
    const ForceBalance& balance = p.model.balance();
    row.t = point.t;
    row.residual = balance.residual;
    row.relative_residual = p.model.relative_residual();
    result.newton_iterations = row.iteration;
    progress.add(row, p.model.rounding_floor());
    if (!balance.finite) {
      result.reason = p.model.not_finite();
      return result;
    }
    if (std::abs(constraint.value(point)) <= constraint.tolerance() && progress.converged()) break;
    if (row.iteration >= most_iterations) {
      result.reason = fmt::format("Newton did not converge in {} iterations (relative residual {:.2e})", row.iteration,
                                  row.relative_residual);
      return result;
    }

    row.forcing = progress.forcing();
    PathPoint change;
    linear::LinearOutcome outcome = p.model.linearise(point.displacement.at());
    if (outcome.converged) outcome = p.direction(point, constraint, row.forcing, change);
    result.linear_iterations += outcome.iterations;
    if (!outcome.converged) {
      result.reason = outcome.reason;
      return result;
    }
    row.step_length = p.advance(constraint, change, point);
    if (row.step_length == 0) {
      result.reason =
          fmt::format("no step length along Newton's direction lowers the residual (relative residual {:.2e})",
                      row.relative_residual);
      return result;
    }
    ++row.iteration;
    row.linear_iterations = outcome.iterations;
    row.update = row.step_length * std::sqrt(p.model.dot(change.displacement.values(), change.displacement.values()));
    const double increment = p.model.away_from_start(point.displacement.values());
    row.relative_update = increment > 0 ? row.update / increment : 0;
  }
  result.converged = true;
  force = p.model.force();
  return result;
}

}  // namespace perinox::equilibrium
