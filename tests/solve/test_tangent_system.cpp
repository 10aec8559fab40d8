/// The tangent in its two forms, every preconditioner and linear method: one answer.
#include <gtest/gtest.h>

#include "support/runs.hpp"

namespace perinox::testing {
namespace {

struct Setting {
  const char* name;
  std::vector<std::string> overrides;
};

const Setting settings[] = {
    {"assembled, automatic", {"solver.tangent=assembled"}},
    {"assembled, jacobi", {"solver.tangent=assembled", "solver.linear.preconditioner=jacobi"}},
    {"assembled, block-jacobi", {"solver.tangent=assembled", "solver.linear.preconditioner=block-jacobi"}},
    {"assembled, chebyshev", {"solver.tangent=assembled", "solver.linear.preconditioner=chebyshev"}},
    {"assembled, ilu", {"solver.tangent=assembled", "solver.linear.preconditioner=ilu"}},
    {"assembled, gmres", {"solver.tangent=assembled", "solver.linear.method=gmres"}},
    {"matrix-free, none", {"solver.linear.preconditioner=none"}},
    {"matrix-free, gmres", {"solver.linear.method=gmres"}},
    {"full step, constant forcing", {"solver.newton.line_search=full-step", "solver.newton.forcing=constant"}},
};

TEST(TangentSystem, EverySettingGivesTheSameAnswer) {
  // Measured: 4e-12 to 2e-10 at this tolerance (the setting's own name is printed with its value).
  const std::vector<std::string> tight{"solver.newton.tolerance=1e-11", "solver.newton.update_tolerance=1e-5"};
  const RunResult reference = run_deck(deck_of(pulled_cube(6, 0.05, 3), tight));
  ASSERT_EQ(reference.stopped, "");
  EXPECT_EQ(reference.preconditioner, "block-jacobi");
  for (const Setting& setting : settings) {
    std::vector<std::string> overrides = tight;
    overrides.insert(overrides.end(), setting.overrides.begin(), setting.overrides.end());
    const RunResult run = run_deck(deck_of(pulled_cube(6, 0.05, 3), overrides));
    ASSERT_EQ(run.stopped, "") << setting.name;
    const double difference = relative_difference(run.displacement, reference.displacement);
    std::printf("%-28s difference %.1e, %d linear iterations in the last step\n", setting.name, difference,
                run.records.steps.back().linear_iterations);
    EXPECT_LT(difference, 1e-9) << setting.name;
  }
}

}  // namespace
}  // namespace perinox::testing
