#include "equilibrium_model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "perinox/body/extent.hpp"
#include "perinox/core/sentence.hpp"

namespace perinox::equilibrium {

EquilibriumModel::EquilibriumModel(medium::Medium& medium, const loads::Boundary& boundary,
                                   linear::TangentSystem& system, const deck::Newton& settings)
    : medium_(medium),
      points_(medium.model()),
      boundary_(boundary),
      system_(system),
      settings_(settings),
      reach_(body::diagonal(points_.body()) * std::sqrt(static_cast<double>(points_.body().total))),
      force_(points_.owned_unknowns()) {}

void EquilibriumModel::set_step(const std::vector<double>& external, double t) {
  external_ = &external;
  t_ = t;
  version_ = committed_too_ = 0;
  double square = 0;
  for (std::size_t u = 0; u < force_.size(); ++u)
    if (!loose(u)) square += medium_.displacement()[u] * medium_.displacement()[u];
  start_ = std::sqrt(points_.body().communicator.sum(square));
}

bool EquilibriumModel::loose(std::size_t u) const {
  return !boundary_.loose().empty() && boundary_.loose()[u / static_cast<std::size_t>(points_.dimension())] != 0;
}

const ForceBalance& EquilibriumModel::evaluate(const medium::At& asked) {
  const medium::At at = known(asked);
  // Another solver of the same medium may have looked elsewhere in between.
  if (version_ == at.version && medium_.trial().version == at.version) return balance_;
  version_ = at.version;
  medium_.evaluate(t_, at, force_.data());
  std::vector<double> squares(4, 0.0);
  for (std::size_t u = 0; u < force_.size(); ++u) {
    if (loose(u)) continue;
    const double sum = force_[u] + (*external_)[u];
    squares[boundary_.prescribed()[u] ? 1 : 0] += sum * sum;
    squares[2] += (*external_)[u] * (*external_)[u];
    squares[3] += at.displacement[u] * at.displacement[u];
  }
  points_.body().communicator.sum(squares);
  balance_ = {std::sqrt(squares[0]), std::sqrt(squares[1]), std::sqrt(squares[2]), std::sqrt(squares[3]), true};
  balance_.finite = std::isfinite(squares[0] + squares[1] + squares[3]);
  return balance_;
}

std::vector<double> EquilibriumModel::out_of_balance() const {
  std::vector<double> rest(force_.size());
  for (std::size_t u = 0; u < rest.size(); ++u) rest[u] = prescribed(u) ? 0 : force_[u] + (*external_)[u];
  return rest;
}

linear::LinearOutcome EquilibriumModel::linearise(const medium::At& at) {
  linear::LinearOutcome outcome;
  try {
    system_.update(known(at));
    system_.update_preconditioner();
    outcome.converged = true;
  } catch (const std::exception& failure) {
    outcome = linear::outcome_of(failure);
  }
  return outcome;
}

std::string EquilibriumModel::not_finite() const {
  const std::string mine = medium_.first_not_finite(force_.data());
  const std::string text = first_sentence(points_.body().communicator, mine);
  return text.empty() ? "the force balance is not finite" : text;
}

double EquilibriumModel::dot(const std::vector<double>& a, const std::vector<double>& b) const {
  double sum = 0;
  for (std::size_t u = 0; u < a.size(); ++u) sum += a[u] * b[u];
  return points_.body().communicator.sum(sum);
}

double EquilibriumModel::away_from_start(const std::vector<double>& x) const {
  double square = 0;
  for (std::size_t u = 0; u < x.size(); ++u) square += std::pow(x[u] - medium_.displacement()[u], 2);
  return std::sqrt(points_.body().communicator.sum(square));
}

double EquilibriumModel::rounding_floor() const {
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  const double displacement = std::min(std::max(balance_.displacement, start_), reach_);
  return 64 * epsilon * system_.stiffness_scale() * std::max(displacement, epsilon * reach_);
}

double EquilibriumModel::relative_residual() const {
  if (balance_.residual == 0) return 0;
  const double scale = std::max({balance_.reaction, balance_.external, rounding_floor() / settings_.tolerance});
  return scale > 0 ? balance_.residual / scale : std::numeric_limits<double>::infinity();
}

}  // namespace perinox::equilibrium
