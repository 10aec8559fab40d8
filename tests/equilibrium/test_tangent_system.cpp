/// The tangent in its two forms, every preconditioner and linear method: one answer.
#include <gtest/gtest.h>

#include "support/runs.hpp"

namespace perinox::test {
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
    {"auto, ilu", {"solver.linear.preconditioner=ilu"}},
    {"auto, direct", {"solver.linear.method=direct"}},
    {"assembled, gmres", {"solver.tangent=assembled", "solver.linear.method=gmres"}},
    {"matrix-free, none", {"solver.linear.preconditioner=none"}},
    {"matrix-free, three steps", {"solver.linear.chebyshev_steps=3"}},
    {"matrix-free, gmres, five steps", {"solver.linear.method=gmres", "solver.linear.chebyshev_steps=5"}},
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

TEST(TangentSystem, ADirectSolveTakesOneIteration) {
  const RunResult run = run_deck(deck_of(pulled_cube(5, 0.03, 2), {"solver.linear.method=direct"}));
  ASSERT_EQ(run.stopped, "");
  EXPECT_EQ(run.preconditioner, "direct");
  // One each Newton iteration, and one for the first guess of the first step, at most also of the second.
  for (const StepRecord& step : run.records.steps)
    EXPECT_LE(step.linear_iterations, step.newton_iterations + 1) << "step " << step.step;
}

TEST(TangentSystem, ADirectSolveSaysThatTheTangentIsSingular) {
  // A row in space: nothing resists the particle in the middle sideways.
  const RunResult run = run_deck(deck_of(R"(
dimension: 3
body: [{name: row, shape: {box: {min: [0, 0, 0], max: [3, 1, 1]}}, spacing: 1, material: steel}]
horizon: {ratio: 1.5}
materials: {steel: {model: elastic, young_modulus: 1, poisson_ratio: 0.25}}
sets: {ends: {ids: [0, 2]}}
boundary: [{set: ends, displacement: {x: "0.01*t*x", y: 0, z: 0}}]
steps: {end: 1, count: 1, adaptive: false}
solver: {linear: {method: direct}}
)"));
  EXPECT_NE(run.stopped.find("the direct solver met a singular tangent"), std::string::npos) << run.stopped;
}

TEST(TangentSystem, EveryStepSaysWhereItsTimeWent) {
  const RunResult run = run_deck(deck_of(pulled_cube(6, 0.05, 3)));
  ASSERT_EQ(run.records.steps.size(), 3u);
  for (const StepRecord& step : run.records.steps) {
    // One product a linear iteration, one in the first guess, and a few more for residuals.
    EXPECT_GE(step.profile.count_of(Section::product), step.linear_iterations);
    EXPECT_LE(step.profile.count_of(Section::product), step.linear_iterations + 3 * (step.newton_iterations + 1));
    EXPECT_GE(step.profile.count_of(Section::force), step.newton_iterations);
    EXPECT_GT(step.profile.seconds_of(Section::product), 0);
    EXPECT_GT(step.profile.seconds_of(Section::linearise), 0);
    EXPECT_EQ(step.profile.count_of(Section::assembly), 0);
    EXPECT_EQ(step.profile.count_of(Section::halo), 0);  // one rank
    double sum = 0;
    for (const double seconds : step.profile.seconds) sum += seconds;
    EXPECT_LE(sum, step.profile.wall);
    EXPECT_LE(step.seconds, step.profile.wall + 1e-3);
  }
}

}  // namespace
}  // namespace perinox::test
