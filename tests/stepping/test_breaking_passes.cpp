/// Loads whose bonds break in passes: what the passes tell, where they end, the energies.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "perinox/fracture/bond_breaking.hpp"
#include "perinox/fracture/loose_pieces.hpp"
#include "support/breaking_decks.hpp"
#include "support/broken.hpp"
#include "support/fracture.hpp"
#include "support/measured.hpp"

namespace perinox::test {
namespace {

using test::measured;
using ::testing::HasSubstr;

/// 20 x 16 particles with an edge crack of 7, opened like a book: the crack grows stably.
deck::Deck opened_plate(const std::vector<std::string>& overrides = {},
                        const std::string& damage = "damage: {energy_release_rate: 0.05}") {
  return deck_of(fmt::format(R"yaml(
dimension: plane-stress
body: [{{name: plate, shape: {{box: {{min: [0, 0], max: [20, 16]}}}}, spacing: 1, material: brittle}}]
horizon: {{ratio: 3.015}}
cracks: [{{segment: {{start: [0, 8], end: [7, 8]}}}}]
materials: {{brittle: {{model: elastic, young_modulus: 1000, poisson_ratio: 0.3, {}}}}}
sets: {{bottom: {{where: "y < 3"}}, top: {{where: "y > 13"}}}}
boundary:
  - {{set: bottom, displacement: {{x: 0, y: 0}}}}
  - {{set: top, displacement: {{x: 0, y: "t*(1 - x/22)"}}}}
fracture: {{unbreakable: [bottom, top]}}
steps: {{end: 0.07, count: 14}}
output: {{fields: [displacement, damage]}}
history: [{{name: pull, reaction: top, component: y}}]
)yaml",
                             damage),
                 overrides);
}

TEST(Passes, LoadRisesDropsAsTheCrackGrowsAndGoesOn) {
  const FractureRun run(opened_plate());
  ASSERT_EQ(run.stopped, "");
  ASSERT_EQ(run.records.steps.size(), 14u);
  const auto& steps = run.records.steps;
  const auto pull = [&](std::size_t k) { return steps[k].history[0]; };
  std::size_t peak = 0;
  for (std::size_t k = 1; k < steps.size(); ++k)
    if (pull(k) > pull(peak)) peak = k;
  for (std::size_t k = 1; k <= peak; ++k) EXPECT_GT(pull(k), pull(k - 1));
  EXPECT_LT(pull(13), 0.7 * pull(peak));  // 0.61: 11.4 of 18.6
  EXPECT_GT(pull(13), 0.3 * pull(peak));  // the crack is not through
  // Counts and energies only grow, and change in the steps that have passes and in no others.
  long long broken_before = 0;
  double released_before = 0, relaxed_before = 0;
  for (const StepRecord& step : steps) {
    const FractureRow& row = *step.fracture;
    long long broken = 0;
    int passes = 0;
    for (const BreakingPass& pass : run.records.passes) {
      if (pass.step != step.step) continue;
      EXPECT_EQ(pass.pass, ++passes);
      EXPECT_EQ(pass.t, step.t);
      EXPECT_GE(pass.worst, 1 - fracture::BondBreaking::tie);
      EXPECT_GE(pass.critical, pass.broken);
      EXPECT_GT(pass.broken, 0);
      broken += pass.broken;
    }
    EXPECT_EQ(row.passes, passes);
    EXPECT_EQ(row.broken_bonds, broken_before + broken);
    EXPECT_EQ(row.released_energy > released_before, passes > 0);
    EXPECT_EQ(row.relaxed_energy > relaxed_before, passes > 0);
    broken_before = row.broken_bonds;
    released_before = row.released_energy;
    relaxed_before = row.relaxed_energy;
  }
  EXPECT_EQ(broken_before, static_cast<long long>(run.scene.broken().size()));
  EXPECT_EQ(run.scene.families().broken, 2 * broken_before);
  EXPECT_GT(broken_before, 100);
  // Along the plane of the pre-crack.
  for (const auto& ids : run.broken())
    for (const GlobalId id : ids)
      EXPECT_LT(std::abs(run.scene.body().position(static_cast<LocalIndex>(id))[1] - 8), 3.1);
}

TEST(Passes, EnergyIsAccountedFor) {
  for (const int count : {7, 14}) {
    const FractureRun run(opened_plate(
        {fmt::format("steps.count={}", count), "solver.newton.tolerance=1e-10", "solver.linear.tolerance=1e-12"}));
    EXPECT_LE(measured("opened plate: energy not accounted for", run.energy_gap()), 1e-9);  // 5.9e-12
  }
}

/// Each pass is judged in the equilibrium before it: what one bond releases is its measure times the limit.
TEST(Passes, ReleaseWhatTheirBondsHeld) {
  const deck::Deck deck = opened_plate({"steps.end=0.05", "steps.count=10"});
  const FractureRun run(deck);
  ASSERT_EQ(run.stopped, "");
  const double limit = fracture::bond_limits(deck, run.scene)[0].limit;
  double least = 0;
  for (const BreakingPass& pass : run.records.passes) {
    ASSERT_EQ(pass.broken, 1);  // so that all of it is told
    least += pass.worst * limit;
  }
  // The measure is of first order in the bond's share of its family.
  EXPECT_LE(measured("opened plate: energy released, over what the bonds held",
                     std::abs(run.stepper.energies().released / least - 1)),
            0.02);  // 4.5e-3
}

/// A law that nothing comes to changes nothing but the columns of the history.
TEST(Passes, BondsThatHoldAndMaterialsWithoutALaw) {
  const FractureRun holds(opened_plate({}, "damage: {critical_stretch: 1}")), plain(opened_plate({}, ""));
  ASSERT_EQ(holds.records.steps.size(), plain.records.steps.size());
  for (std::size_t k = 0; k < plain.records.steps.size(); ++k) {
    const StepRecord &one = plain.records.steps[k], &other = holds.records.steps[k];
    EXPECT_FALSE(one.fracture);
    EXPECT_FALSE(one.motion);
    EXPECT_EQ(other.fracture->passes, 0);
    EXPECT_EQ(other.fracture->broken_bonds, 0);
    EXPECT_EQ(one.history, other.history);
    EXPECT_EQ(one.linear_iterations, other.linear_iterations);
  }
  for (const FractureRun* run : {&holds, &plain}) {
    EXPECT_TRUE(run->scene.families().broken_volume.empty());
    EXPECT_TRUE(run->scene.broken().empty());
    EXPECT_EQ(run->scene.bonds_version(), 0u);
  }
}

TEST(Passes, TooManyStopTheRun) {
  const FractureRun run(opened_plate({"fracture.max_passes=3"}));
  EXPECT_THAT(run.stopped, HasSubstr("stopped at t = 0.035 of 0.07, after 6 converged steps: bonds still break after 3 "
                                     "passes at t = 0.035"));
  EXPECT_EQ(run.records.steps.size(), 6u);
  EXPECT_EQ(run.records.stopped_after, 7);  // the state in which it was lost, under its own number
  long long broken = 0, in_step = 0;
  for (const BreakingPass& pass : run.records.passes) {
    broken += pass.broken;
    in_step += pass.step == 7;
  }
  EXPECT_EQ(in_step, 3);
  EXPECT_EQ(run.records.passes.back().pass, 3);
  EXPECT_EQ(broken, static_cast<long long>(run.scene.broken().size()));  // and none after them
}

TEST(Passes, APieceThatComesLooseIsTakenOutWhereItIs) {
  const FractureRun run(deck_of(torn_chain));
  ASSERT_EQ(run.stopped, "");
  const auto& steps = run.records.steps;
  ASSERT_EQ(steps.size(), 8u);
  EXPECT_TRUE(
      run.records.noted("a piece of 36 particles, the first of them 36, has lost all support and is held where"));
  EXPECT_TRUE(run.records.noted("16 single particles have lost all their bonds"));  // 8 had before
  EXPECT_EQ(std::count(run.scene.families().size.begin(), run.scene.families().size.end(), 0), 24);
  EXPECT_GT(steps[0].history[0], 1);
  for (std::size_t k = 1; k < 8; ++k) {
    EXPECT_LE(std::abs(steps[k].history[0]), 1e-6);  // 1.4e-8
    EXPECT_NEAR(steps[k].history[1], 0.1, 1e-9);     // 1.8e-11: half of the way that the grip had come
  }
  for (const auto& ids : run.broken()) {
    const auto a = static_cast<LocalIndex>(ids[0]), b = static_cast<LocalIndex>(ids[1]);
    EXPECT_TRUE(run.scene.body().material[a] == 1 || run.scene.body().material[b] == 1);
  }
  EXPECT_LE(measured("chain torn apart: energy not accounted for", run.energy_gap()), 1e-8);  // 1.5e-9
  // The stored energy is that of what is held; what the pieces stored as they came loose is among the relaxed.
  mechanics::Trial trial;
  std::vector<double> force(run.scene.owned_unknowns());
  mechanics::Evaluation evaluation(run.scene);
  mechanics::internal_force(evaluation, run.stepper.committed(), run.stepper.committed().at(), trial, force.data());
  const double in_loose = loads::loose_energy(run.scene, run.stepper.boundary().loose(), trial.stored_energy);
  EXPECT_GT(measured("chain torn apart: energy in loose pieces over that of all", in_loose / trial.stored), 0.01);
  EXPECT_NEAR(run.stepper.energies().stored, trial.stored - in_loose, 1e-9 * trial.stored);
  EXPECT_GT(run.stepper.energies().relaxed, in_loose);
}

// Two notches, and the plastic strain between their tips is the largest.
TEST(Passes, ADuctileLawBreaksWhereItHasFlowedMost) {
  const std::string yaml = R"(
dimension: plane-strain
body: [{name: bar, shape: {box: {min: [0, 0], max: [12, 24]}}, spacing: 1, material: steel}]
horizon: {ratio: 3.015}
cracks: [{segment: {start: [0, 12], end: [4, 12]}}]
materials:
  steel:
    model: elastic-plastic
    young_modulus: 210e3
    poisson_ratio: 0.3
    yield_stress: {tension: 300}
    hardening_modulus: {tension: 2000}
    damage: {ductile: {d0: 0.02}}
sets: {bottom: {where: "y < 3"}, top: {where: "y > 21"}}
boundary:
  - {set: bottom, displacement: {x: 0, y: 0}}
  - {set: top, displacement: {x: 0, y: "0.2*t"}}
fracture: {unbreakable: [bottom, top]}
steps: {end: 1, count: 20}
output: {fields: [displacement]}
)";
  deck::Deck deck = deck_of(yaml);
  mechanics::Scene scene = mechanics::build_scene(deck, Communicator(MPI_COMM_SELF));
  stepping::LoadStepper stepper(deck, scene);
  // Until the first bond breaks.
  struct UntilBroken : FractureRecorder {
    const stepping::LoadStepper* stepper = nullptr;
    const mechanics::Scene* scene = nullptr;
    std::vector<double> strain;
    void bonds_broken(const BreakingPass& pass) override {
      FractureRecorder::bonds_broken(pass);
      for (LocalIndex i = 0; i < scene->owned(); ++i)
        strain.push_back(stepper->committed().point_history(*scene, i)[1]);
      throw RunError("enough");
    }
  } records;
  records.stepper = &stepper;
  records.scene = &scene;
  EXPECT_THROW(stepper.run(records), RunError);
  ASSERT_EQ(records.passes.size(), 1u);
  EXPECT_NEAR(records.passes[0].worst, 1, 0.3);
  ASSERT_FALSE(scene.broken().empty());
  const auto mean = [&](LocalIndex i, LocalIndex j) { return (records.strain[i] + records.strain[j]) / 2; };
  double most = 0;
  for (const auto& bond : test::all_bonds(scene)) most = std::max(most, mean(bond[0], bond[1]));
  for (const auto& ids : scene.broken()) {
    const auto i = static_cast<LocalIndex>(ids[0]), j = static_cast<LocalIndex>(ids[1]);
    EXPECT_NEAR(mean(i, j) / 0.02, records.passes[0].worst, 1e-6 * records.passes[0].worst);
    EXPECT_GE(mean(i, j), most * (1 - 1e-5));
    EXPECT_LT(std::abs(scene.body().position(i)[1] - 12), 2.1);
    EXPECT_LT(std::abs(scene.body().position(i)[0] - 4), 4.1);
  }
  std::printf("ductile: first bonds break at t = %.3g, %zu of them, ratio %.4f\n", records.passes[0].t,
              scene.broken().size(), records.passes[0].worst);
}

}  // namespace
}  // namespace perinox::test
