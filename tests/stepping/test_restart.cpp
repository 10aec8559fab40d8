/// A run that goes on from a checkpoint gives the rest of the uninterrupted run to the last bit, whatever is carried
/// from one step to the next.
#include <gtest/gtest.h>

#include "support/restarts.hpp"

namespace perinox::test {
namespace {

/// Restarts after every step but the last, and compares rows, iteration counts, displacements and forces bit by bit.
void restart_after_every_step(const deck::Deck& deck) {
  const CheckpointFolder folder{Communicator(MPI_COMM_SELF)};
  const RunResult whole = run_with_checkpoints(deck, MPI_COMM_SELF, "", &folder);
  ASSERT_EQ(whole.stopped, "");
  const int steps = whole.records.steps.back().step;
  ASSERT_GE(steps, 3);
  for (int step = 1; step < steps; ++step) {
    const RunResult rest = run_with_checkpoints(deck, MPI_COMM_SELF, folder.of_step(step), nullptr);
    ASSERT_EQ(rest.stopped, "");
    ASSERT_EQ(rest.records.steps.size(), static_cast<std::size_t>(steps - step));
    for (int k = step; k < steps; ++k)
      EXPECT_EQ(numbers_of(rest.records.steps[static_cast<std::size_t>(k - step)]),
                numbers_of(whole.records.steps[static_cast<std::size_t>(k)]))
          << "step " << k + 1 << " of the run that went on after step " << step;
    EXPECT_TRUE(rest.displacement == whole.displacement) << "restart after step " << step;
    EXPECT_TRUE(rest.force == whole.force) << "restart after step " << step;
    std::vector<double> residuals, same;
    for (const auto& row : rest.records.iterations) residuals.push_back(row.residual);
    for (const auto& row : whole.records.iterations)
      if (row.step > step) same.push_back(row.residual);
    EXPECT_EQ(residuals, same) << "Newton iterations of the run that went on after step " << step;
  }
}

/// A bar long enough for the two-level preconditioner; first yield in step 2.
std::string bar(const std::string& hardening) {
  return R"(
dimension: 3
body: [{name: bar, shape: {box: {min: [0, 0, 0], max: [4, 4, 16]}}, spacing: 1, material: metal}]
horizon: {ratio: 2.015}
materials: {metal: {model: elastic-plastic, bulk_modulus: 160e3, shear_modulus: 80e3, yield_stress: {tension: 200})" +
         hardening + R"(}}
sets: {foot: {where: "z < 2"}, head: {where: "z > 14"}}
boundary:
  - {set: foot, displacement: {x: 0, y: 0, z: 0}}
  - {set: head, displacement: {x: "0.01*t", z: "0.08*sin(5 * t) "
}
}
steps: {end: 1, count: 5}
history:
  - {name: pull, reaction: head, component: z}
  - {name: plastic, yielded: all}
)";
}

/// The same bar without flow, pulled and let go.
std::string changed_to_elastic(std::string yaml) {
  for (const auto& [from, to] : {std::pair{"tension: 200", "tension: 1e9"},
                                 {"0.08*sin(5 * t) ", "0.08*abs(2-abs(2-t))"},
                                 {"0.01*t", "0.01*(2-abs(2-t))"}}) {
    const std::string what = from;
    yaml.replace(yaml.find(what), what.size(), to);
  }
  return yaml;
}

TEST(Restart, TwoLevelPlasticBarWithItsUnloading) { restart_after_every_step(deck_of(bar(""))); }

TEST(Restart, SeveralProductsAnIteration) {  // kappa/mu = 500: the polynomial's interval goes on too
  restart_after_every_step(deck_of(bar(""), {"materials.metal.bulk_modulus=40e6"}));
  // Nothing flows: the interval is found once.
  restart_after_every_step(
      deck_of(bar(""), {"materials.metal.bulk_modulus=40e6", "materials.metal.yield_stress.tension=1e5"}));
}

TEST(Restart, KinematicHardening) {
  restart_after_every_step(deck_of(bar(", kinematic_hardening_modulus: {tension: 2000}")));
}

TEST(Restart, AssembledTangentWithPreconditionersThatKeepWhatTheyFound) {
  for (const char* kind : {"chebyshev", "symmetric-gauss-seidel"})
    restart_after_every_step(deck_of(bar(""), {"steps.end=0.6", "steps.count=3", "solver.tangent=assembled",
                                               std::string("solver.linear.preconditioner=") + kind}));
  // Once this bar flows, ILU is no longer definite.
  restart_after_every_step(
      deck_of(bar(""), {"steps.count=3", "solver.tangent=assembled", "solver.linear.preconditioner=ilu",
                        "materials.metal.yield_stress.tension=1e5"}));
}

TEST(Restart, DirectSolve) {
  restart_after_every_step(
      deck_of(bar(""), {"steps.end=0.6", "steps.count=3", "solver.tangent=assembled", "solver.linear.method=direct"}));
}

TEST(Restart, AfterStepsThatWereCut) {
  const deck::Deck deck =
      deck_of(pulled_cube(6, 0.1, 2), {"solver.newton.max_iterations=3", "solver.newton.tolerance=1e-10"});
  restart_after_every_step(deck);
}

TEST(Restart, PlaneStressUnderForces) {
  restart_after_every_step(deck_of(R"(
dimension: plane-stress
body: [{name: plate, shape: {plate_with_hole: {min: [0, 0], max: [20, 10], center: [10, 5], radius: 2}}, spacing: 0.7, material: metal}]
horizon: {ratio: 3.015}
materials: {metal: {model: elastic-plastic, young_modulus: 70e3, poisson_ratio: 0.3, yield_stress: {tension: 200}, hardening_modulus: {tension: 3000}}}
sets: {left: {where: "x < 2"}, right: {where: "x > 18"}}
boundary:
  - {set: left, displacement: {x: 0, y: 0}}
  - {set: right, force: {x: "1000*t"}}
steps: {end: 1, count: 4}
history: [{name: stretch, displacement: right, component: x}]
)"));
}

TEST(Restart, BondsKeptAsPairs) {  // a body that is no lattice: two blocks of unlike spacing
  restart_after_every_step(deck_of(R"(
dimension: 3
body:
  - {name: coarse, shape: {box: {min: [0, 0, 0], max: [4, 4, 6]}}, spacing: 1, material: metal}
  - {name: fine, shape: {box: {min: [0, 0, 6], max: [4, 4, 9]}}, spacing: 0.8, material: metal}
horizon: {ratio: 2.015}
quadrature: partial-volume
materials: {metal: {model: elastic-plastic, bulk_modulus: 160e3, shear_modulus: 80e3, yield_stress: {tension: 200}}}
sets: {foot: {where: "z < 2"}, head: {where: "z > 8"}}
boundary:
  - {set: foot, displacement: {x: 0, y: 0, z: 0}}
  - {set: head, displacement: {z: "0.05*t"}}
steps: {end: 1, count: 4}
history: [{name: pull, reaction: head, component: z}]
)"));
}

TEST(Restart, ThroughNoLoadAtAll) {  // rounding is judged by what the step starts from
  const std::string elastic = changed_to_elastic(bar(""));
  restart_after_every_step(deck_of(elastic, {"steps.end=4", "steps.count=8"}));
}

TEST(Restart, GoesOnWithASmallerStepAndAnEndFurtherOff) {
  const CheckpointFolder folder{Communicator(MPI_COMM_SELF)};
  const RunResult first = run_with_checkpoints(deck_of(bar("")), MPI_COMM_SELF, "", &folder);
  const deck::Deck longer = deck_of(bar(""), {"steps.end=1.2", "steps.count=12"});
  const RunResult rest = run_with_checkpoints(longer, MPI_COMM_SELF, folder.of_step(3), nullptr);
  ASSERT_EQ(rest.stopped, "");
  ASSERT_EQ(rest.records.steps.size(), 6u);  // from t = 0.6 by 0.1
  EXPECT_EQ(rest.records.steps.front().step, 4);
  EXPECT_NEAR(rest.records.steps.front().t, 0.7, 1e-14);
  EXPECT_EQ(rest.records.steps.back().t, 1.2);
}

}  // namespace
}  // namespace perinox::test
