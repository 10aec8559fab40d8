#include "perinox/solve/arc_length.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "perinox/deck/location.hpp"

namespace perinox::solve {

namespace {
/// Residual over reactions up to which the last increment is taken for a first guess.
constexpr double good_guess = 0.1;
/// A step that takes more than this times the wanted iterations fails: from so far away it may have come to another
/// branch of the path.
constexpr int slow = 2;

/// True if some external force or prescribed displacement of this rank is another at t than at 0.
bool changes(const Boundary& boundary, std::size_t unknowns, double t) {
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
  for (std::size_t u = 0; u < point.displacement.size(); ++u)
    point.displacement[u] += factor * direction.displacement[u];
  point.t += factor * direction.t;
  return point;
}
}  // namespace

ArcLength::ArcLength(const deck::Deck& deck, const mechanics::Scene& scene, const Boundary& boundary, Newton& newton)
    : deck_(deck),
      settings_(deck.arc_length),
      scene_(scene),
      newton_(newton),
      bordered_(deck, scene, boundary, newton.system()),
      first_load_(deck.steps.end / deck.steps.count) {
  const Communicator& ranks = scene.body().communicator;
  norm_.ranks = &ranks;
  if (boundary.free_count() == 0)
    deck::refuse(deck.resolved.at("steps").at("control").location(),
                 "steps.control is arc-length, but every displacement is prescribed and there is no path to follow; "
                 "use steps.control: load");
  // Both ends of the run: a load may begin late.
  const bool moves = changes(boundary, scene.owned_unknowns(), first_load_) ||
                     changes(boundary, scene.owned_unknowns(), deck.steps.end);
  if (!ranks.any(moves))
    deck::refuse(deck.resolved.at("steps").at("control").location(),
                 "steps.control is arc-length, but no force and no prescribed displacement of boundary changes with t; "
                 "write one as a formula of t");
  if (settings_.until)
    until_.emplace(ranks, scene.body().sets.at(settings_.until->set), scene.body().volume, scene.dimension(),
                   settings_.until->component, settings_.until->displacement);
}

PathPoint ArcLength::committed_point(const mechanics::Committed& committed) const {
  const auto begin = committed.displacement().begin();
  return {{begin, begin + static_cast<std::ptrdiff_t>(scene_.owned_unknowns())}, committed.t()};
}

NewtonResult ArcLength::predict(const mechanics::Committed& committed, const PathPoint& origin, PathPoint& guess) {
  guess = along(origin, arc_ / norm_.of(last_increment_), last_increment_);
  NewtonResult result;
  result.converged = bordered_.relative_residual(committed, guess) < good_guess;
  if (result.converged) return result;
  PathPoint rate;
  result = bordered_.rate(committed, rate);
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
  consider(side * until_->mean(origin.displacement), side * until_->mean(to.displacement), side * goal,
           End::displacement);
  return first;
}

NewtonResult ArcLength::attempt(const mechanics::Committed& committed, int step, Observer& observer,
                                mechanics::Trial& trial, std::vector<double>& force) {
  const PathPoint origin = committed_point(committed);
  PathPoint point = origin;
  NewtonResult result;
  const int most = std::min(deck_.solver.newton.max_iterations, slow * settings_.wanted_iterations);
  const auto solve = [&](const PathConstraint& constraint) {
    const NewtonResult one = bordered_.solve(committed, point, constraint, most, step, observer, trial, force);
    result.converged = one.converged;
    result.reason = one.reason;
    result.newton_iterations += one.newton_iterations;
    result.linear_iterations += one.linear_iterations;
    tried_ = point.t;
    if (bordered_.indefinite() == indefinite_) return;
    indefinite_ = bordered_.indefinite();
    observer.note(fmt::format("step {}, t = {:.6g}: {}", step, tried_,
                              indefinite_ ? "the tangent is not positive definite; GMRES takes over"
                                          : "conjugate gradients take over again"));
  };
  if (arc_ == 0) {
    tried_ = first_load_;
    result = newton_.solve(committed, first_load_, step, {}, observer, trial, force);
    if (result.converged) {
      std::copy_n(trial.displacement.begin(), point.displacement.size(), point.displacement.begin());
      point.t = trial.t;
    }
  } else {
    result = predict(committed, origin, point);
    tried_ = point.t;
    if (!result.converged) return result;
    solve(FixedArc(norm_, origin, arc_));
  }
  if (!result.converged) return result;
  iterations_ = result.newton_iterations;
  increment_ = along(point, -1, origin);
  if (arc_ > 0) {
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
  point = along(origin, share, increment_);
  if (end == End::load) {
    point.t = deck_.steps.end;
    solve(FixedLoad(deck_.steps.end, first_load_));
  } else {
    solve(*until_);
  }
  return result;
}

void ArcLength::accept(const mechanics::Committed&, const mechanics::Trial& trial) {
  ++steps_;
  ended_ = landed_;
  if (until_) reached_ = until_->mean(trial.displacement);
  if (arc_ == 0) {
    norm_.length = norm_.of(increment_);
    arc_ = 1;
    longest_ = settings_.largest_growth * std::pow(2, cuts_);
    shortest_ = std::pow(0.5, deck_.steps.max_cuts - cuts_);
  }
  last_increment_ = std::move(increment_);
  if (!deck_.steps.adaptive) return;
  const double growth = std::sqrt(static_cast<double>(settings_.wanted_iterations) / std::max(1, iterations_));
  arc_ = std::clamp(arc_ * std::clamp(growth, 0.5, 2.0), shortest_, longest_);
}

bool ArcLength::cut() {
  if (!deck_.steps.adaptive) return false;
  if (arc_ == 0) {
    if (cuts_ >= deck_.steps.max_cuts) return false;
    ++cuts_;
    first_load_ /= 2;
    return true;
  }
  if (arc_ <= shortest_) return false;
  arc_ = std::max(arc_ / 2, shortest_);
  return true;
}

double ArcLength::share() const {
  double share = static_cast<double>(steps_) / settings_.max_steps;
  if (until_) share = std::max(share, reached_ / settings_.until->displacement);
  if (landed_) share = 1;
  return std::clamp(share, 1e-6, 1.0);
}

}  // namespace perinox::solve
