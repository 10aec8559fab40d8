/// Load steps: commits, cuts and growth, stops with the reason, energies, forces, reactions.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "support/measured.hpp"
#include "support/runs.hpp"

namespace perinox::test {
namespace {

using ::testing::HasSubstr;

TEST(LoadStepper, EveryWholeStepEndsExactlyWhereTheDeckSays) {
  const RunResult run = run_deck(deck_of(pulled_cube(6, 0.03, 3)));
  ASSERT_EQ(run.stopped, "");
  ASSERT_EQ(run.records.steps.size(), 3u);
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(run.records.steps[k].step, k + 1);
    EXPECT_EQ(run.records.steps[k].t, 1.0 * (k + 1) / 3);
  }
  EXPECT_TRUE(run.records.steps.back().last);
  EXPECT_EQ(run.records.stopped_after, -1);
}

TEST(LoadStepper, TheStartIsToldOnceAndIsAtRest) {
  const RunResult run = run_deck(deck_of(pulled_cube(6, 0.03, 3)));
  ASSERT_EQ(run.records.begins.size(), 1u);
  const StepRecord& start = run.records.begins.front();
  EXPECT_EQ(start.step, 0);
  EXPECT_EQ(start.t, 0.0);
  EXPECT_FALSE(start.last);
  EXPECT_EQ(start.history, std::vector<double>(start.history.size(), 0.0));
  EXPECT_EQ(start.stored_energy, 0.0);
}

/// Coarse and fine halves under u_x = 0.01 x; the coarse one flows, and both are brought back.
const std::string two_spacings = R"yaml(
dimension: plane-strain
bond_bodies: false
body:
  - {name: coarse, shape: {box: {min: [0, 0], max: [6, 6]}}, spacing: 1, material: soft}
  - {name: fine, shape: {box: {min: [6, 0], max: [12, 6]}}, spacing: 0.5, material: hard}
horizon: {length: 3.015}
materials:
  soft: {model: elastic-plastic, young_modulus: 1000, poisson_ratio: 0.3, yield_stress: {tension: 1}}
  hard: {model: elastic-plastic, young_modulus: 1000, poisson_ratio: 0.3, yield_stress: {tension: 1e6}}
boundary: [{set: all, displacement: {x: "0.01*x*(1 - abs(1 - t))", y: 0}}]
steps: {end: 2, count: 2}
history: [{name: mean, displacement: all, component: x}, {name: flowed, yielded: all}]
)yaml";

TEST(LoadStepper, MeansAreByVolume) {
  const RunResult run = run_deck(deck_of(two_spacings));
  ASSERT_EQ(run.stopped, "");
  const std::vector<double>& top = run.records.steps[0].history;
  EXPECT_NEAR(top[0], 0.06, 1e-15);  // 0.078 where each particle counts alike; measured 1e-17
  EXPECT_NEAR(top[1], 0.5, 1e-14);   // 0.2 where each particle counts alike
  // What has flowed stays so, though nothing flows at the end.
  const std::vector<double>& back = run.records.steps[1].history;
  EXPECT_NEAR(back[0], 0, 1e-15);
  EXPECT_NEAR(back[1], 0.5, 1e-14);
}

/// A bar of spacing h, pulled until it flows in part.
std::string bar_of(double h) {
  return fmt::format(R"yaml(
dimension: 3
body: [{{name: bar, shape: {{box: {{min: [0, 0, 0], max: [{1}, {1}, {2}]}}}}, spacing: {0}, material: m}}]
horizon: {{ratio: 2.015}}
materials:
  m: {{model: elastic-plastic, young_modulus: 1000, poisson_ratio: 0.3, density: 1000, yield_stress: {{tension: 5}}}}
sets: {{low: {{where: "z < {3}"}}, high: {{where: "z > {4}"}}}}
boundary: [{{set: low, displacement: {{x: 0, y: 0, z: 0}}}}, {{set: high, displacement: {{z: "{5}*t"}}}}]
steps: {{end: 1, count: 4}}
history: [{{name: pull, reaction: high, component: z}}, {{name: flowed, yielded: all}}]
)yaml",
                     h, 4 * h, 8 * h, 2 * h, 6 * h, 0.04 * h);
}

/// In units of h, from one end of what is not refused to the other.
TEST(LoadStepper, SpacingsThatAreNotRefusedWork) {
  const RunResult one = run_deck(deck_of(bar_of(1)));
  ASSERT_EQ(one.stopped, "");
  EXPECT_GT(one.records.steps.back().history[1], 0.1) << "nothing flows";
  for (const double h : {2e-25, 5e24}) {
    const RunResult run = run_deck(deck_of(bar_of(h)));
    ASSERT_EQ(run.stopped, "") << h;
    ASSERT_EQ(run.records.steps.size(), one.records.steps.size()) << h;
    for (std::size_t k = 0; k < one.records.steps.size(); ++k) {
      const StepRecord &a = one.records.steps[k], &b = run.records.steps[k];
      EXPECT_NEAR(b.history[0] / (h * h), a.history[0], 1e-8 * a.history[0]) << h;
      EXPECT_NEAR(b.history[1], a.history[1], 1e-14) << h;
      EXPECT_NEAR(b.stored_energy / (h * h * h), a.stored_energy, 1e-8 * a.stored_energy) << h;
    }
  }
}

/// The time step that an estimate finds is in units of h sqrt(density/modulus).
TEST(LoadStepper, TheStableTimeStepGoesWithTheSpacing) {
  const auto stable = [](double h) {
    const deck::Deck deck = deck_of(bar_of(h), {"dynamics=explicit", fmt::format("steps.end={}", h)});
    mechanics::Scene scene = mechanics::build_scene(deck, Communicator(MPI_COMM_SELF));
    return stepping::TimeStepper(deck, scene).plan().stable / h;
  };
  const double one = stable(1);
  for (const double h : {2e-25, 1e-10, 1e10, 5e24}) EXPECT_NEAR(stable(h), one, 1e-12 * one) << h;
}

TEST(LoadStepper, ReactionsBalanceAndPullOutwards) {
  const RunResult run = run_deck(deck_of(pulled_cube(6, 0.03, 3)));
  const std::vector<double>& history = run.records.steps.back().history;
  EXPECT_GT(history[0], 0);
  EXPECT_NEAR(history[0] + history[1], 0, 1e-6 * history[0]);
  EXPECT_NEAR(history[2], 0.03, 1e-14);
}

TEST(LoadStepper, AFailedStepIsHalvedAndGrownAgain) {
  // Three iterations do not reach 1e-10 on the long plastic step, but do on a part of it.
  const deck::Deck deck =
      deck_of(pulled_cube(6, 0.1, 2), {"solver.newton.max_iterations=3", "solver.newton.tolerance=1e-10"});
  const RunResult run = run_deck(deck);
  ASSERT_EQ(run.stopped, "");
  ASSERT_FALSE(run.records.rejected.empty());
  EXPECT_THAT(run.records.reasons.front(), HasSubstr("did not converge in 3 iterations"));
  std::vector<double> sizes;
  double before = 0;
  bool halfway = false;
  for (const StepRecord& step : run.records.steps) {
    sizes.push_back(step.t - before);
    before = step.t;
    halfway = halfway || step.t == 0.5;
  }
  EXPECT_TRUE(halfway) << "a cut step must not jump over the end of a whole one";
  EXPECT_EQ(before, 1.0);
  EXPECT_LT(*std::min_element(sizes.begin(), sizes.end()), 0.26);
  EXPECT_GT(sizes.back(), *std::min_element(sizes.begin(), sizes.end())) << "the step was never grown again";
  // The same end as without cuts, but for the path's own step-size error.
  const RunResult whole = run_deck(deck_of(pulled_cube(6, 0.1, 2), {"solver.newton.tolerance=1e-10"}));
  EXPECT_NEAR(run.records.steps.back().history[0] / whole.records.steps.back().history[0], 1, 0.02);
}

TEST(LoadStepper, StopsWithTheReasonAndKeepsTheStepsBefore) {
  const std::vector<std::string> hopeless{"solver.newton.max_iterations=1", "solver.newton.tolerance=1e-12"};
  std::vector<std::string> fixed = hopeless;
  fixed.push_back("steps.adaptive=false");
  const RunResult rigid = run_deck(deck_of(pulled_cube(6, 0.1, 20), fixed));
  EXPECT_THAT(rigid.stopped, HasSubstr("steps.adaptive is false"));
  EXPECT_THAT(rigid.stopped, HasSubstr("did not converge in 1 iterations"));
  std::vector<std::string> cut = hopeless;
  cut.push_back("steps.max_cuts=2");
  const RunResult adaptive = run_deck(deck_of(pulled_cube(6, 0.1, 2), cut));
  EXPECT_THAT(adaptive.stopped, HasSubstr("at its smallest size"));
  EXPECT_GE(adaptive.records.rejected.size(), 3u);
  // Nothing of the failed step has leaked into the committed state.
  for (const auto& [id, u] : adaptive.displacement)
    for (const double value : u) EXPECT_LE(std::abs(value), adaptive.records.steps.empty() ? 0.0 : 0.1);
}

TEST(LoadStepper, ExternalWorkIsStoredOrDissipated) {
  // To what Newton's tolerance leaves, however long the steps are.
  const RunResult single = run_deck(deck_of(pulled_cube(6, 0.04, 1), {"deformation=small"}));
  ASSERT_GT(single.energies.dissipated, 0.1 * single.energies.stored);
  EXPECT_LE(test::measured(
                "one long step of small strain: energy not accounted for",
                std::abs(single.energies.external_work / (single.energies.stored + single.energies.dissipated) - 1)),
            1e-8);
  for (const int steps : {2, 10, 20}) {
    const RunResult run = run_deck(deck_of(pulled_cube(6, 0.04, steps)));
    ASSERT_EQ(run.stopped, "");
    ASSERT_GT(run.energies.dissipated, 0.1 * run.energies.stored);
    const double error = std::abs(run.energies.external_work - run.energies.stored - run.energies.dissipated) /
                         run.energies.external_work;
    EXPECT_LE(test::measured(fmt::format("energy not accounted for, {} steps", steps), error), 1e-8);  // 9e-12
  }
}

TEST(LoadStepper, ElasticWorkIsStored) {
  const RunResult run = run_deck(deck_of(pulled_cube(6, 1e-4, 2), {"materials.aluminium.yield_stress.shear=1e9"}));
  EXPECT_EQ(run.energies.dissipated, 0);
  EXPECT_NEAR(run.energies.external_work / run.energies.stored, 1, 1e-4);
}

TEST(LoadStepper, ForcesAreCarriedToTheSupport) {
  const std::string deck = R"(
dimension: 3
body:
  - {name: bar, shape: {box: {min: [0, 0, 0], max: [4, 4, 8]}}, spacing: 1.0, material: steel}
horizon: {ratio: 2.015}
materials:
  steel: {model: elastic, young_modulus: 210e3, poisson_ratio: 0.3}
sets: {foot: {where: "z < 2"}, head: {where: "z > 6"}}
boundary:
  - {set: foot, displacement: {x: 0, y: 0, z: 0}}
  - {set: head, force: {z: "100*t"}}
  - {set: all, body_force: {x: "0.5*t", z: "0.1*x"}}
steps: {end: 1, count: 2}
history:
  - {name: rx, reaction: foot, component: x}
  - {name: rz, reaction: foot, component: z}
  - {name: free, reaction: head, component: z}
)";
  const RunResult run = run_deck(deck_of(deck));
  ASSERT_EQ(run.stopped, "");
  const std::vector<double>& history = run.records.steps.back().history;
  EXPECT_NEAR(history[0], -0.5 * 128, 1e-6 * 64);           // body force times volume
  EXPECT_NEAR(history[1], -(100 + 0.1 * 2.0 * 128), 1e-4);  // total force, and 0.1 x over a mean x of 2
  EXPECT_NEAR(history[2], 0, 1e-4);
}

TEST(LoadStepper, AFullyImposedFieldIsEvaluatedAndCommittedWithoutNewton) {
  const deck::Deck deck = deck_of(R"(
dimension: 3
body:
  - {name: cube, shape: {box: {min: [0, 0, 0], max: [5, 5, 5]}}, spacing: 1.0, material: aluminium}
horizon: {ratio: 3.015}
materials:
  aluminium: {model: elastic-plastic, bulk_modulus: 67.5e3, shear_modulus: 25.9e3, yield_stress: {shear: 117.3}}
boundary:
  - {set: all, displacement: {x: "0.02*t*y", y: 0, z: 0}}
steps: {end: 2, count: 4, adaptive: false}
history: [{name: yielded, yielded: all}]
)");
  const RunResult run = run_deck(deck);
  ASSERT_EQ(run.stopped, "");
  ASSERT_EQ(run.records.steps.size(), 4u);
  for (const StepRecord& step : run.records.steps) EXPECT_EQ(step.newton_iterations, 0);
  EXPECT_EQ(run.records.steps.back().history[0], 1.0);
  EXPECT_GT(run.energies.dissipated, 0);
}

TEST(LoadStepper, AStepWithoutAnyLoadConvergesAtOnce) {
  const RunResult run = run_deck(deck_of(pulled_cube(5, 0.0, 2)));
  ASSERT_EQ(run.stopped, "");
  ASSERT_EQ(run.records.steps.size(), 2u);
  for (const StepRecord& step : run.records.steps) EXPECT_EQ(step.newton_iterations, 0);
  for (const auto& [id, u] : run.displacement)
    for (const double value : u) EXPECT_EQ(value, 0);
}

TEST(LoadStepper, ACollapsedBondIsNamed) {
  // Two points are moved into one place at t = 1: the bond has no direction any more.
  const deck::Deck deck = deck_of(R"(
dimension: 3
body: [{name: pair, shape: {box: {min: [0, 0, 0], max: [2, 1, 1]}}, spacing: 1, material: steel}]
horizon: {length: 1.5}
materials: {steel: {model: elastic, young_modulus: 1, poisson_ratio: 0.25}}
sets: {left: {ids: [0]}, right: {ids: [1]}}
boundary:
  - {set: left, displacement: {x: 0, y: 0, z: 0}}
  - {set: right, displacement: {x: "-t", y: 0, z: 0}}
steps: {end: 1, count: 2, adaptive: false}
)");
  const RunResult run = run_deck(deck);
  EXPECT_THAT(run.stopped, HasSubstr("after 1 converged steps"));
  EXPECT_EQ(run.records.stopped_after, 1) << "the observer was not given the last converged step to keep";
  EXPECT_THAT(run.stopped, HasSubstr("the force on particle 0 at (0.5, 0.5, 0.5) is not finite: its bond to particle 1 "
                                     "has collapsed to length zero"));
  EXPECT_EQ(run.displacement.at(1)[0], -0.5) << "the last converged step is not the committed one";
}

TEST(LoadStepper, ALoadBeyondWhatFlowCarriesIsSaid) {
  // On the way there force states are tried that are not numbers, and the return mapping has nothing to return to.
  for (const char* dimension : {"plane-strain", "plane-stress"}) {
    const RunResult run = run_deck(deck_of(fmt::format(R"yaml(
dimension: {}
body: [{{name: b, shape: {{box: {{min: [0, 0], max: [12, 4]}}}}, spacing: 1, material: m}}]
horizon: {{ratio: 3.015}}
materials: {{m: {{model: elastic-plastic, young_modulus: 1000, poisson_ratio: 0.3, yield_stress: {{tension: 4}}}}}}
sets: {{l: {{where: "x<3"}}, r: {{where: "x>9"}}}}
boundary:
  - {{set: l, displacement: {{x: 0, y: 0}}}}
  - {{set: r, force: {{x: "300*t"}}}}
steps: {{end: 1, count: 4}}
)yaml",
                                                       dimension)));
    EXPECT_THAT(run.stopped, ::testing::StartsWith("stopped at t = 0.")) << dimension;
    EXPECT_FALSE(run.records.steps.empty()) << dimension;
  }
}

TEST(LoadStepper, AJumpLosesEnergyUnderTheLoadsOfItsNewPlace) {
  // A column that buckles within its first step. The work of the mean of the loads before and after is less than what
  // the buckled column stores.
  const RunResult run = run_deck(deck_of(R"yaml(
dimension: plane-stress
body: [{name: b, shape: {box: {min: [0, 0], max: [40, 3]}}, spacing: 1, material: m}]
horizon: {ratio: 3.015}
materials: {m: {model: elastic, young_modulus: 1000, poisson_ratio: 0.3}}
sets: {l: {where: "x<3"}, r: {where: "x>37"}}
boundary:
  - {set: l, displacement: {x: 0, y: 0}}
  - {set: r, force: {x: "-600*t", y: "0.01*t"}}
steps: {end: 1, count: 4}
)yaml"));
  ASSERT_EQ(run.stopped, "");
  EXPECT_GT(run.energies.relaxed, 0);  // 2.276
  EXPECT_GT(run.energies.external_work, run.energies.stored);
  EXPECT_LT(std::abs(run.energies.unaccounted()), 1e-9);  // 4.8e-12
}

TEST(LoadStepper, NothingHeldIsRefused) {
  const deck::Deck deck = deck_of(pulled_cube(4, 0.01, 1), {"boundary=[{set: head, force: {z: 1}}]"});
  try {
    run_deck(deck);
    FAIL() << "a free body was accepted";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("nothing holds the body"));
  }
}

}  // namespace
}  // namespace perinox::test
