#include "convergence.hpp"

#include <algorithm>
#include <cmath>

namespace perinox::equilibrium {

namespace {
constexpr double tightest = 1e-8, after_no_progress = 1e-4;
/// Two decades are some seven iterations, which is what the last linear solve of a step takes at least.
constexpr double worth_it = 100;
}  // namespace

bool converged(const deck::Newton& settings, const NewtonIteration& last, double before, double floor) {
  // The next update would be about as much smaller than this one as the residual has become.
  const double contraction = last.iteration > 0 && before > 0 ? std::min(1.0, last.residual / before) : 1;
  const bool small = last.relative_residual <= settings.tolerance &&
                     (last.iteration == 0 || contraction * last.relative_update <= settings.update_tolerance);
  return small || last.residual <= floor;
}

double next_forcing(const deck::Solver& settings, const NewtonIteration& last, double before) {
  const double loosest = settings.linear.tolerance;
  if (settings.newton.forcing == deck::Forcing::constant) return loosest;
  double forcing = loosest;
  if (last.iteration > 0 && (last.residual > before || last.step_length < 1)) {
    // The last direction was of little use: if the linear solve was to blame, a better one helps.
    forcing = after_no_progress;
  } else if (last.iteration > 0 && before > 0) {
    // Eisenstat and Walker's choice 2: as much progress as Newton has just made.
    const double progress = last.residual / before;
    forcing = std::min(loosest, 0.9 * std::pow(progress, 1.5));
  }
  // Never more than what convergence still needs: the last linear solve of a step is the dearest.
  const double needed = 0.2 * settings.newton.tolerance / last.relative_residual;
  // But that much where Newton would leave no more by itself: converging quadratically, the next residual is this one
  // times the last factor squared. Some more linear iterations are fewer than those of another linearisation.
  if (last.iteration > 0 && before > 0 && forcing < worth_it * needed) {
    const double progress = last.residual / before;
    if (progress * progress * last.relative_residual < 0.7 * settings.newton.tolerance)
      forcing = std::min(forcing, needed);
  }
  return std::min(loosest, std::max({forcing, needed, tightest}));
}

}  // namespace perinox::equilibrium
