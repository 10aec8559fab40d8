#include "newton_progress.hpp"

#include <algorithm>
#include <cmath>

namespace perinox::equilibrium {

namespace {
constexpr double tightest = 1e-8, after_no_progress = 1e-4;
/// Two decades are some seven iterations, which is what the last linear solve of a step takes at least.
constexpr double worth_it = 100;
}  // namespace

void NewtonProgress::add(const NewtonIteration& row, double floor) {
  const double before = last_.residual;
  last_ = row;
  observer_.newton_iteration(last_);
  most_linear_iterations_ = std::max(most_linear_iterations_, last_.linear_iterations);
  if (last_.linear_iterations >= settings_.linear.max_iterations) ++linear_failures_;
  converged_ = judge(before, floor);
  forcing_ = next_forcing(before);
}

bool NewtonProgress::judge(double before, double floor) const {
  // The next update would be about as much smaller than this one as the residual has become.
  const deck::Newton& newton = settings_.newton;
  const double contraction = last_.iteration > 0 && before > 0 ? std::min(1.0, last_.residual / before) : 1;
  const bool small = last_.relative_residual <= newton.tolerance &&
                     (last_.iteration == 0 || contraction * last_.relative_update <= newton.update_tolerance);
  return small || last_.residual <= floor;
}

double NewtonProgress::next_forcing(double before) const {
  const double loosest = settings_.linear.tolerance;
  if (settings_.newton.forcing == deck::Forcing::constant) return loosest;
  double forcing = loosest;
  if (last_.iteration > 0 && (last_.residual > before || last_.step_length < 1)) {
    // The last direction was of little use: if the linear solve was to blame, a better one helps.
    forcing = after_no_progress;
  } else if (last_.iteration > 0 && before > 0) {
    // Eisenstat and Walker's choice 2: as much progress as Newton has just made.
    const double progress = last_.residual / before;
    forcing = std::min(loosest, 0.9 * std::pow(progress, 1.5));
  }
  // Never more than what convergence still needs: the last linear solve of a step is the dearest.
  const double needed = 0.2 * settings_.newton.tolerance / last_.relative_residual;
  // But that much where Newton would leave no more by itself: converging quadratically, the next residual is this one
  // times the last factor squared. Some more linear iterations are fewer than those of another linearisation.
  if (last_.iteration > 0 && before > 0 && forcing < worth_it * needed) {
    const double progress = last_.residual / before;
    if (progress * progress * last_.relative_residual < 0.7 * settings_.newton.tolerance)
      forcing = std::min(forcing, needed);
  }
  return std::min(loosest, std::max({forcing, needed, tightest}));
}

}  // namespace perinox::equilibrium
