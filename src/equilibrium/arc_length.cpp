#include "perinox/equilibrium/arc_length.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "perinox/deck/location.hpp"

namespace perinox::equilibrium {

namespace {
/// Residual over reactions up to which the last increment is taken for a first guess.
constexpr double good_guess = 0.1;
/// A step that takes more than this times the wanted iterations fails: from so far away it may have come to another
/// branch of the path.
constexpr int slow = 2;

/// True if some external force or prescribed displacement of this rank is another at t than at 0.
bool changes(const loads::Boundary& boundary, std::size_t unknowns, double t) {
  std::vector<double> before(unknowns, 0.0), after(unknowns, 0.0);
  boundary.external_force(0, before.data());
  boundary.external_force(t, after.data());
  if (before != after) return true;
  boundary.impose(0, before.data());
  boundary.impose(t, after.data());
  return before != after;
}

PathPoint along(const PathPoint& origin, double factor, const PathPoint& direction) {
  PathPoint point = origin;
  std::vector<double>& moved = point.displacement.change();
  for (std::size_t u = 0; u < moved.size(); ++u) moved[u] += factor * direction.displacement.values()[u];
  point.t += factor * direction.t;
  return point;
}
}  // namespace

ArcLength::ArcLength(const deck::Deck& deck, medium::Medium& medium, const loads::Boundary& boundary, Newton& newton)
    : deck_(deck),
      settings_(deck.arc_length),
      medium_(medium),
      boundary_(boundary),
      newton_(newton),
      bordered_(deck, medium, boundary, newton.system()),
      first_load_(deck.steps.end / deck.steps.count),
      start_load_(first_load_) {
  const medium::Model& model = medium.model();
  const Communicator& ranks = model.body().communicator;
  norm_.ranks = &ranks;
  if (boundary.free_count() == 0)
    deck::refuse(deck.resolved.at("steps").at("control").location(),
                 "steps.control is arc-length, but every displacement is prescribed and there is no path to follow; "
                 "use steps.control: load");
  // Both ends of the run: a load may begin late.
  const bool moves = changes(boundary, model.owned_unknowns(), first_load_) ||
                     changes(boundary, model.owned_unknowns(), deck.steps.end);
  if (!ranks.any(moves))
    deck::refuse(deck.resolved.at("steps").at("control").location(),
                 "steps.control is arc-length, but no force and no prescribed displacement of boundary changes with t; "
                 "write one as a formula of t");
  if (settings_.until)
    until_.emplace(ranks, model.body().sets.at(settings_.until->set), model.body().volume, model.dimension(),
                   settings_.until->component, settings_.until->displacement);
}

PathPoint ArcLength::committed_point() const {
  return {medium::Displacement(medium::owned_displacement(medium_)), medium_.t()};
}

NewtonResult ArcLength::predict(const PathPoint& origin, PathPoint& guess) {
  guess = along(origin, arc_ / norm_.of(last_increment_), last_increment_);
  NewtonResult result;
  result.converged = bordered_.relative_residual(guess) < good_guess;
  if (result.converged) return result;
  PathPoint rate;
  result = bordered_.rate(rate);
  if (!result.converged) {
    result.reason = "no first guess: " + result.reason;
    return result;
  }
  const double forward = norm_.product(rate, last_increment_) < 0 ? -1 : 1;
  guess = along(origin, forward * arc_ / norm_.of(rate), rate);
  return result;
}

std::pair<double, ArcLength::End> ArcLength::passed(const PathPoint& origin, const PathPoint& to) const {
  std::pair<double, End> first{1, End::none};
  const auto consider = [&](double from, double until, double goal, End end) {
    // Reached within rounding counts as passed, so that no step of no length is left over.
    if (from < goal && until >= goal * (1 - 1e-12)) {
      const double share = std::min(1.0, (goal - from) / (until - from));
      if (first.second == End::none || share < first.first) first = {share, end};
    }
  };
  consider(origin.t, to.t, deck_.steps.end, End::load);
  if (!until_) return first;
  const double goal = settings_.until->displacement, side = goal > 0 ? 1 : -1;
  consider(side * until_->mean(origin.displacement.values()), side * until_->mean(to.displacement.values()),
           side * goal, End::displacement);
  return first;
}

NewtonResult ArcLength::solve_on_path(const PathConstraint& constraint, int step, Observer& observer, PathPoint& point,
                                      std::vector<double>& force) {
  const int most = std::min(deck_.solver.newton.max_iterations, slow * settings_.wanted_iterations);
  const NewtonResult result = bordered_.solve(point, constraint, most, step, observer, force);
  tried_ = point.t;
  if (bordered_.indefinite() != indefinite_) {
    indefinite_ = bordered_.indefinite();
    observer.note(fmt::format("step {}, t = {:.6g}: {}", step, tried_,
                              indefinite_ ? "the tangent is not positive definite; GMRES takes over"
                                          : "conjugate gradients take over again"));
  }
  return result;
}

NewtonResult ArcLength::solve_at(double t, int step, Observer& observer, PathPoint& point, std::vector<double>& force) {
  tried_ = t;
  NewtonResult result = newton_.solve(t, step, {}, observer, force);
  if (result.converged) {
    std::vector<double>& solved = point.displacement.change();
    std::copy_n(medium_.trial().displacement.begin(), solved.size(), solved.begin());
    point.t = t;
  } else if (result.failure == linear::Failure::negative_curvature) {  // beyond a limit point
    point.t = t;
    result = solve_on_path(FixedLoad(t, first_load_), step, observer, point, force);
  }
  return result;
}

NewtonResult ArcLength::advance(const PathPoint& origin, int step, Observer& observer, PathPoint& point,
                                std::vector<double>& force) {
  turned_ = false;
  NewtonResult result;
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  double turn = none;
  if (!starting_) {
    result = predict(origin, point);
    tried_ = point.t;
    if (!result.converged) return result;
    turn = boundary_.first_reversal(origin.t, point.t, true).value_or(none);
    // The last step has ended where a load turns back, as well as it can be told.
    if (std::abs(turn - origin.t) <= 1e-5 * std::abs(point.t - origin.t)) {
      turn = none;
      starting_ = true;
      point = origin;
    }
  }
  if (starting_)
    result = solve_at(origin.t + (forward_ ? start_load_ : -start_load_), step, observer, point, force);
  else if (std::isnan(turn))
    result = solve_on_path(FixedArc(norm_, origin, arc_), step, observer, point, force);
  if (!result.converged) return result;
  if (std::isnan(turn)) turn = boundary_.first_reversal(origin.t, point.t, false).value_or(none);
  if (std::isnan(turn) || turn == point.t) return result;
  observer.note(fmt::format("step {}: a load turns back at t = {:.6g}, and the step ends there", step, turn));
  turned_ = true;
  const double share = (turn - origin.t) / (point.t - origin.t);
  point = along(origin, share, along(point, -1, origin));
  point.t = turn;
  const NewtonResult there = solve_on_path(FixedLoad(turn, first_load_), step, observer, point, force);
  result.converged = there.converged;
  result.reason = there.reason;
  result.newton_iterations += there.newton_iterations;
  result.linear_iterations += there.linear_iterations;
  return result;
}

NewtonResult ArcLength::attempt(int step, Observer& observer, std::vector<double>& force) {
  const PathPoint origin = committed_point();
  PathPoint point = origin;
  NewtonResult result = advance(origin, step, observer, point, force);
  if (!result.converged) return result;
  iterations_ = result.newton_iterations;
  increment_ = along(point, -1, origin);
  if (!starting_) {
    const double cosine =
        norm_.product(increment_, last_increment_) / (norm_.of(increment_) * norm_.of(last_increment_));
    if (!(cosine > 0)) {
      result.converged = false;
      result.reason = fmt::format("the step turns back, {:.0f} degrees from the one before",
                                  std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / std::acos(-1.0));
      return result;
    }
  }

  const auto [share, end] = passed(origin, point);
  landed_ = end != End::none;
  if (!landed_) return result;
  turned_ = false;
  point = along(origin, share, increment_);
  if (end == End::load) point.t = deck_.steps.end;
  missed_until_ = end == End::load && until_;
  const FixedLoad end_of_loads(deck_.steps.end, first_load_);
  const PathConstraint& constraint = end == End::load ? static_cast<const PathConstraint&>(end_of_loads) : *until_;
  const NewtonResult last = solve_on_path(constraint, step, observer, point, force);
  result.converged = last.converged;
  result.reason = last.reason;
  result.newton_iterations += last.newton_iterations;
  result.linear_iterations += last.linear_iterations;
  return result;
}

void ArcLength::accept() {
  ++steps_;
  ended_ = landed_;
  if (until_) reached_ = until_->mean(medium_.trial().displacement);
  if (arc_ == 0) {
    norm_.length = norm_.of(increment_);
    arc_ = 1;
    longest_ = settings_.largest_growth * std::pow(2, cuts_);
    shortest_ = std::pow(0.5, deck_.steps.max_cuts - cuts_);
  } else if (starting_) {
    arc_ = std::clamp(norm_.of(increment_), shortest_, longest_);
  }
  last_increment_ = std::move(increment_);
  forward_ = medium_.trial().t > medium_.t();
  starting_ = turned_;
  start_load_ = first_load_;
  cuts_ = 0;
  if (!deck_.steps.adaptive) return;
  const double growth = std::sqrt(static_cast<double>(settings_.wanted_iterations) / std::max(1, iterations_));
  arc_ = std::clamp(arc_ * std::clamp(growth, 0.5, 2.0), shortest_, longest_);
}

bool ArcLength::cut() {
  if (!deck_.steps.adaptive) return false;
  if (starting_) {
    if (cuts_ >= deck_.steps.max_cuts) return false;
    ++cuts_;
    start_load_ /= 2;
    if (arc_ == 0) first_load_ = start_load_;
    return true;
  }
  if (arc_ <= shortest_) return false;
  arc_ = std::max(arc_ / 2, shortest_);
  return true;
}

std::string ArcLength::unreached() const {
  if (ended_) return missed_until_ ? "steps.end is reached before arc_length.until" : "";
  return fmt::format("the path ends after arc_length.max_steps = {} steps{}", settings_.max_steps,
                     until_ ? ", before arc_length.until is reached" : ", before steps.end is");
}

double ArcLength::share() const {
  double share = static_cast<double>(steps_) / settings_.max_steps;
  if (until_) share = std::max(share, reached_ / settings_.until->displacement);
  if (landed_) share = 1;
  return std::clamp(share, 1e-6, 1.0);
}

}  // namespace perinox::equilibrium
