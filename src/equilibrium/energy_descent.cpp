#include "energy_descent.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "newton_progress.hpp"

namespace perinox::equilibrium {

namespace {
constexpr int most_iterations = 300;
constexpr long long most_linear_iterations = 30000;
constexpr double smallest_shift = 1e-8, largest_shift = 1e3;
constexpr double shortest = 1e-4, sufficient = 1e-4;
/// Share of the energy that rounding may hide.
constexpr double rounding = 1e-13;

/// Puts the shift back whatever happens.
class Shifted {
 public:
  explicit Shifted(linear::TangentSystem& system) : system_(system) {}
  ~Shifted() { system_.shift(0); }

 private:
  linear::TangentSystem& system_;
};

std::string nothing_found(double residual, double tolerance) {
  return residual <= tolerance
             ? fmt::format("going down in energy has come to an unstable equilibrium only (relative residual {:.2e})",
                           residual)
             : fmt::format("going down in energy has found no equilibrium (relative residual {:.2e})", residual);
}
}  // namespace

double EnergyDescent::potential(const std::vector<double>& external) const {
  const medium::Trial& trial = model_.trial();
  double sum = trial.stored + trial.dissipated;
  for (std::size_t u = 0; u < external.size(); ++u)
    if (!model_.prescribed(u)) sum -= external[u] * trial.displacement[u];
  return model_.sum(sum);
}

linear::LinearOutcome EnergyDescent::find_direction(double& shift, std::vector<double>& change) {
  const std::vector<double> right = model_.out_of_balance();
  int iterations = 0;
  for (;;) {
    model_.system().shift(shift);
    linear::LinearOutcome outcome =
        linear_.solve(model_.system(), right, std::min(solver_.linear.tolerance, 1e-3), change);
    iterations += outcome.iterations;
    outcome.iterations = iterations;
    for (std::size_t u = 0; u < change.size(); ++u)
      if (model_.prescribed(u)) change[u] = 0;
    if (outcome.converged || shift >= largest_shift) return outcome;
    shift = std::max(10 * shift, smallest_shift);
  }
}

double EnergyDescent::step_along(const std::vector<double>& external, const std::vector<double>& change,
                                 medium::Displacement& here, ForceBalance& balance, double& energy) {
  const double slope = model_.dot(change, model_.out_of_balance());
  const std::vector<double> from = here.values();
  double length = 1;
  for (; length >= shortest; length *= 0.5) {
    std::vector<double>& to = here.change();
    for (std::size_t u = 0; u < to.size(); ++u) to[u] = from[u] + length * change[u];
    const ForceBalance now = model_.evaluate(here.at());
    if (!now.finite) continue;
    const double lower = potential(external);
    const bool hidden = std::abs(slope) * length <= rounding * std::abs(energy);
    if (hidden ? now.residual < balance.residual : lower <= energy - sufficient * length * slope) {
      balance = now;
      energy = lower;
      break;
    }
  }
  return length;
}

NewtonResult EnergyDescent::run(const std::vector<double>& external, int step, Observer& observer,
                                std::vector<double>& x) {
  NewtonResult result;
  const Shifted shifted(model_.system());
  NewtonProgress progress(solver_, observer);
  medium::Displacement here(x);
  std::vector<double> change(x.size());
  double shift = 0, update = 0;
  ForceBalance balance = model_.evaluate(here.at());
  if (!balance.finite) {
    result.failure = linear::Failure::not_finite;
    result.reason = model_.not_finite();
    return result;
  }
  double energy = potential(external);
  int iterations = 0;
  for (int iteration = 0;; ++iteration) {
    const NewtonIteration row{step,   model_.t(), iteration,  balance.residual,        model_.relative_residual(),
                              update, 0,          iterations, solver_.linear.tolerance};
    progress.add(row, model_.rounding_floor());
    result.newton_iterations = iteration;
    if (iteration >= most_iterations || result.linear_iterations >= most_linear_iterations) break;

    linear::LinearOutcome outcome = model_.linearise(here.at());
    const bool in_balance =
        row.relative_residual <= solver_.newton.tolerance || balance.residual <= model_.rounding_floor();
    if (outcome.converged) outcome = find_direction(shift, change);
    iterations = outcome.iterations;
    result.linear_iterations += iterations;
    if (!outcome.converged) {
      result.failure = outcome.failure;
      result.reason = outcome.reason;
      return result;
    }
    if (in_balance && shift == 0) {  // and conjugate gradients have met no negative curvature
      result.converged = true;
      x = here.values();
      return result;
    }
    const double square = model_.dot(change, change);
    const std::vector<double> from = here.values();
    const double length = step_along(external, change, here, balance, energy);
    if (length < shortest) {
      if (shift >= largest_shift) break;
      shift = std::max(100 * shift, smallest_shift);
      here.change() = from;
      balance = model_.evaluate(here.at());
      continue;
    }
    if (!(model_.away_from_start(here.values()) <= model_.reach())) {
      result.failure = linear::Failure::no_progress;
      result.reason =
          "going down in energy the body runs away, farther than it is large: the load is beyond what it carries";
      return result;
    }
    update = length * std::sqrt(square);
    shift = length < 1 ? 4 * shift : shift <= smallest_shift ? 0 : shift / 10;
  }
  result.failure = linear::Failure::no_progress;
  result.reason = nothing_found(model_.relative_residual(), solver_.newton.tolerance);
  return result;
}

}  // namespace perinox::equilibrium
