/// Runs that break bonds or move in time go on from a checkpoint to the last bit, also from one between two time steps.
#include <gtest/gtest.h>

#include "support/breaking_decks.hpp"
#include "support/restarts.hpp"

namespace perinox::test {
namespace {

/// Goes on from every checkpoint that a run leaves, between steps and within them, and compares rows, displacements
/// and forces bit by bit. within: least number of the latter.
void restart_everywhere(const deck::Deck& deck, std::size_t within) {
  const CheckpointFolder folder{Communicator(MPI_COMM_SELF)};
  const RunResult whole = run_with_checkpoints(deck, MPI_COMM_SELF, "", &folder);
  ASSERT_EQ(whole.stopped, "");
  const StepRecord& end = whole.records.steps.back();
  const int steps = end.step;
  if (end.fracture) {
    EXPECT_GT(end.fracture->broken_bonds, 50);  // 80 in the bar that snaps
  }
  std::vector<std::pair<int, std::string>> starts;
  for (int step = 1; step < steps; ++step) starts.emplace_back(step, folder.of_step(step));
  for (std::size_t k = 0; k < folder.passes.size(); ++k)
    starts.emplace_back(folder.passes[k], folder.of_pass(static_cast<int>(k)));
  EXPECT_GE(folder.passes.size(), within);
  for (const auto& [step, file] : starts) {
    SCOPED_TRACE(file);
    const RunResult rest = run_with_checkpoints(deck, MPI_COMM_SELF, file, nullptr);
    ASSERT_EQ(rest.stopped, "");
    ASSERT_EQ(rest.records.steps.size(), static_cast<std::size_t>(steps - step));
    for (int k = step; k < steps; ++k)
      EXPECT_EQ(numbers_of(rest.records.steps[static_cast<std::size_t>(k - step)]),
                numbers_of(whole.records.steps[static_cast<std::size_t>(k)]))
          << "step " << k + 1;
    EXPECT_TRUE(rest.displacement == whole.displacement);
    EXPECT_TRUE(rest.force == whole.force);
  }
}

TEST(RestartInMotion, CrackThatGrowsInPasses) { restart_everywhere(deck_of(torn_plate), 0); }

TEST(RestartInMotion, BarThatSnapsAndComesToRest) { restart_everywhere(deck_of(snapping_bar), 8); }

TEST(RestartInMotion, CrackThatRunsWhileTheLoadGoesOn) {
  restart_everywhere(deck_of(torn_plate, {"fallback=explicit", "hand_over.overload=1.01", "hand_over.rate=20"}), 3);
}

// Newton is given too few iterations, so that every step ends in motion.
TEST(RestartInMotion, FlowThatIsFoundInTime) {
  restart_everywhere(deck_of(R"(
dimension: 3
body: [{name: bar, shape: {box: {min: [0, 0, 0], max: [4, 4, 8]}}, spacing: 1, material: metal}]
horizon: {ratio: 2.015}
materials: {metal: {model: elastic-plastic, bulk_modulus: 160e3, shear_modulus: 80e3, density: 7.85e-9, yield_stress: {tension: 200}}}
sets: {foot: {where: "z < 2"}, head: {where: "z > 6"}}
boundary:
  - {set: foot, displacement: {x: 0, y: 0, z: 0}}
  - {set: head, displacement: {x: "0.01*t", z: "0.04*t"}}
fallback: explicit
solver: {newton: {max_iterations: 3}}
steps: {end: 1, count: 4, adaptive: false}
history:
  - {name: pull, reaction: head, component: z}
  - {name: plastic, yielded: all}
)"),
                     2);
}

TEST(RestartInMotion, DuctileBarThatTears) {
  restart_everywhere(deck_of(R"(
dimension: 3
body: [{name: bar, shape: {box: {min: [0, 0, 0], max: [3, 3, 10]}}, spacing: 1, material: metal}]
horizon: {ratio: 2.015}
materials: {metal: {model: elastic-plastic, bulk_modulus: 160e3, shear_modulus: 80e3, density: 7.85e-9, yield_stress: {tension: 200}, hardening_modulus: {tension: 2000}, damage: {ductile: {d0: 0.02, c: 1.5}}}}
sets: {foot: {where: "z < 3"}, head: {where: "z > 7"}}
boundary:
  - {set: foot, displacement: {x: 0, y: 0, z: 0}}
  - {set: head, displacement: {z: "0.3*t"}}
fracture: {unbreakable: [foot, head]}
steps: {end: 0.5, count: 6}
history: [{name: pull, reaction: head, component: z}, {name: plastic, yielded: all}]
)"),
                     1);
}

TEST(RestartInMotion, ExplicitWithContactFlowAndBreaking) { restart_everywhere(deck_of(smashed_blocks), 2); }

TEST(RestartInMotion, ExplicitElasticUnderForces) {
  restart_everywhere(deck_of(R"(
dimension: 3
body: [{name: bar, shape: {box: {min: [0, 0, 0], max: [3, 3, 12]}}, spacing: 1, material: steel}]
horizon: {ratio: 2.015}
materials: {steel: {model: elastic, young_modulus: 210e3, poisson_ratio: 0.3, density: 7.85e-9}}
dynamics: explicit
sets: {foot: {where: "z < 2"}, head: {where: "z > 10"}}
boundary: [{set: foot, velocity: {z: "1e9*t"}}, {set: head, force: {x: "1e8*t"}}]
steps: {end: 4e-5, count: 3}
history: [{name: tip, displacement: head, component: x}]
)"),
                     3);
}

TEST(RestartInMotion, RowsMayBeOthersAfterARestartWithinOne) {
  const CheckpointFolder folder{Communicator(MPI_COMM_SELF)};
  const RunResult whole = run_with_checkpoints(deck_of(smashed_blocks), MPI_COMM_SELF, "", &folder);
  ASSERT_GE(folder.passes.size(), 1u);
  const std::size_t last = 0;  // within an early row, so that finer rows are more of them
  const RunResult rest = run_with_checkpoints(deck_of(smashed_blocks, {"steps.count=20"}), MPI_COMM_SELF,
                                              folder.of_pass(static_cast<int>(last)), nullptr);
  ASSERT_EQ(rest.stopped, "");
  EXPECT_EQ(rest.records.steps.front().step, folder.passes[last] + 1);
  EXPECT_EQ(rest.records.steps.back().t, 2e-5);
  EXPECT_GT(rest.records.steps.size(), whole.records.steps.size() - static_cast<std::size_t>(folder.passes[last]));
}

}  // namespace
}  // namespace perinox::test
