/// Newton's observed order on plastic steps: quadratic with the consistent tangent, linear with Eq. 65 as printed.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <cmath>

#include "support/runs.hpp"

namespace perinox::testing {
namespace {

/// Tight linear solves, no line search: the tangent alone decides the order.
const std::string tight =
    "solver: {newton: {tolerance: 1e-13, update_tolerance: 1, max_iterations: 60, line_search: full-step, forcing: "
    "constant}, linear: {tolerance: 1e-12}}\n";

/// log(r2/r1)/log(r1/r0) of the last three residuals that are above rounding.
double observed_order(std::vector<double> residuals) {
  const double floor = 1e-12 * residuals.front();
  while (residuals.size() > 3 && residuals.back() < floor) residuals.pop_back();
  const std::size_t n = residuals.size();
  return std::log(residuals[n - 1] / residuals[n - 2]) / std::log(residuals[n - 2] / residuals[n - 3]);
}

TEST(NewtonOrder, QuadraticWithTheConsistentTangent) {
  const Run run = run_deck(deck_of(pulled_cube(8, 0.08, 4, tight)));
  ASSERT_EQ(run.stopped, "");
  double best = 0, worst = 10;
  int plastic = 0;
  for (const solve::StepRecord& step : run.records.steps) {
    const std::vector<double> residuals = run.records.residuals(step.step);
    fmt::print("consistent, step {}: {:.2e}\n", step.step, fmt::join(residuals, " "));
    if (step.dissipated_energy == 0 || residuals.size() < 4) continue;
    ++plastic;
    best = std::max(best, observed_order(residuals));
    worst = std::min(worst, observed_order(residuals));
  }
  fmt::print("consistent: observed order {:.2f} to {:.2f} over {} plastic steps\n", worst, best, plastic);
  ASSERT_GE(plastic, 2);
  EXPECT_GE(worst, 1.9);
}

TEST(NewtonOrder, LinearWithThePrintedTangent) {
  const Run run = run_deck(deck_of(pulled_cube(8, 0.08, 4, tight), {"solver.form=printed", "solver.newton.tolerance=1e-8"}));
  int plastic = 0;
  for (const solve::StepRecord& step : run.records.steps) {
    const std::vector<double> residuals = run.records.residuals(step.step);
    fmt::print("printed, step {}: {:.2e}\n", step.step, fmt::join(residuals, " "));
    if (step.dissipated_energy == 0) continue;
    ++plastic;
    EXPECT_LT(observed_order(residuals), 1.3);
  }
  fmt::print("printed: {} plastic steps; {}\n", plastic, run.stopped);
  EXPECT_GE(plastic, 1);
}

}  // namespace
}  // namespace perinox::testing
