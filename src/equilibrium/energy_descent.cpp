#include "energy_descent.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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
}  // namespace

double EnergyDescent::potential(const std::vector<double>& external) const {
  const mechanics::Trial& trial = model_.trial();
  double sum = trial.stored + trial.dissipated;
  for (std::size_t u = 0; u < external.size(); ++u)
    if (!boundary_.prescribed()[u]) sum -= external[u] * trial.displacement[u];
  std::vector<double> sums{sum};
  model_.sum(sums);
  return sums[0];
}

NewtonResult EnergyDescent::run(const mechanics::Committed& committed, const std::vector<double>& external, double t,
                                int step, Observer& observer, std::vector<double>& x) {
  NewtonResult result;
  const Shifted shifted(system_);
  const std::size_t unknowns = x.size();
  const auto right = Teuchos::rcp(new tpetra::Vector(system_.map()));
  const auto left = Teuchos::rcp(new tpetra::Vector(system_.map()));
  std::vector<double> best = x, change(unknowns);
  double shift = 0;
  ForceBalance balance = model_.evaluate(x.data());
  if (!balance.finite) {
    result.failure = linear::Failure::not_finite;
    result.reason = model_.not_finite();
    return result;
  }
  double energy = potential(external);
  double update = 0;
  int iterations = 0;
  for (int iteration = 0;; ++iteration) {
    NewtonIteration row;
    row.step = step;
    row.t = t;
    row.iteration = iteration;
    row.residual = balance.residual;
    row.relative_residual = model_.relative_residual();
    row.update = update;
    row.linear_iterations = iterations;
    row.forcing = solver_.linear.tolerance;
    observer.newton_iteration(row);
    result.newton_iterations = iteration;
    if (iteration >= most_iterations || result.linear_iterations >= most_linear_iterations) break;

    system_.update(committed, x.data());
    system_.update_preconditioner();
    const bool in_balance =
        row.relative_residual <= solver_.newton.tolerance || balance.residual <= model_.rounding_floor();
    {
      const auto values = right->getLocalViewHost(Tpetra::Access::OverwriteAll);
      for (std::size_t u = 0; u < unknowns; ++u)
        values(u, 0) = boundary_.prescribed()[u] ? 0 : model_.force()[u] + external[u];
    }
    iterations = 0;
    linear::LinearOutcome outcome;
    for (;;) {
      system_.shift(shift);
      outcome = linear::solve_linear(factory_, model_.create_W_op(), model_.create_W_prec(),
                                     std::min(solver_.linear.tolerance, 1e-3), right, left);
      iterations += outcome.iterations;
      if (outcome.converged || shift >= largest_shift) break;
      shift = std::max(10 * shift, smallest_shift);
    }
    result.linear_iterations += iterations;
    if (!outcome.converged) {
      result.failure = outcome.failure;
      result.reason = outcome.reason;
      return result;
    }
    if (in_balance && shift == 0) {  // and conjugate gradients have met no negative curvature
      result.converged = true;
      return result;
    }
    std::vector<double> sums{0, 0};
    {
      const auto values = left->getLocalViewHost(Tpetra::Access::ReadOnly);
      const auto rests = right->getLocalViewHost(Tpetra::Access::ReadOnly);
      for (std::size_t u = 0; u < unknowns; ++u) {
        change[u] = boundary_.prescribed()[u] ? 0 : values(u, 0);
        sums[0] += change[u] * rests(u, 0);
        sums[1] += change[u] * change[u];
      }
    }
    model_.sum(sums);
    double length = 1;
    for (; length >= shortest; length *= 0.5) {
      for (std::size_t u = 0; u < unknowns; ++u) best[u] = x[u] + length * change[u];
      const ForceBalance now = model_.evaluate(best.data());
      if (!now.finite) continue;
      const double lower = potential(external);
      const bool hidden = std::abs(sums[0]) * length <= rounding * std::abs(energy);
      if (hidden ? now.residual < balance.residual : lower <= energy - sufficient * length * sums[0]) {
        balance = now;
        energy = lower;
        break;
      }
    }
    if (length < shortest) {
      if (shift >= largest_shift) break;
      shift = std::max(100 * shift, smallest_shift);
      balance = model_.evaluate(x.data());
      continue;
    }
    x = best;
    double far = 0;
    for (std::size_t u = 0; u < unknowns; ++u) far += std::pow(x[u] - committed.displacement()[u], 2);
    std::vector<double> square{far};
    model_.sum(square);
    if (!(std::sqrt(square[0]) <= reach_)) {
      result.failure = linear::Failure::no_progress;
      result.reason =
          "going down in energy the body runs away, farther than it is large: the load is beyond what it "
          "carries";
      return result;
    }
    update = length * std::sqrt(sums[1]);
    shift = length < 1 ? 4 * shift : shift <= smallest_shift ? 0 : shift / 10;
  }
  result.failure = linear::Failure::no_progress;
  result.reason = fmt::format("going down in energy has found no equilibrium (relative residual {:.2e})",
                              model_.relative_residual());
  return result;
}

}  // namespace perinox::equilibrium
