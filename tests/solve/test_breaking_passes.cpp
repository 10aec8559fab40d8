/// Loads whose bonds break in passes: what the passes tell, where they end, the energies.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "perinox/solve/bond_breaking.hpp"
#include "support/broken.hpp"
#include "support/fracture.hpp"
#include "support/measured.hpp"

namespace perinox::testing {
namespace {

using test::measured;
using ::testing::HasSubstr;

TEST(Passes, EnergyIsAccountedForOverACrackedPlate) {
  const FractureRun run(
      input_deck("cracked_plate", {"solver.newton.tolerance=1e-10", "solver.linear.tolerance=1e-12"}));
  ASSERT_EQ(run.stopped, "");
  ASSERT_GT(run.stepper.energies().released, 0);
  EXPECT_LE(measured("cracked plate: energy not accounted for", run.energy_gap()), 1e-6);
  // Released with the bonds is near what the crack takes: G_c an area of 28 mm.
  long long broken = 0;
  for (const solve::BreakingPass& pass : run.records.passes) {
    EXPECT_GE(pass.worst, 1 - solve::BondBreaking::tie);
    EXPECT_GE(pass.critical, pass.broken);
    EXPECT_GT(pass.broken, 0);
    broken += pass.broken;
  }
  const solve::FractureRow& last = *run.records.steps.back().fracture;
  EXPECT_EQ(last.broken_bonds, static_cast<long long>(run.scene.broken().size()));
  EXPECT_LE(broken, last.broken_bonds);
  EXPECT_EQ(run.scene.families().broken, 2 * last.broken_bonds);
  EXPECT_GE(last.relaxed_energy, 0);
}

TEST(Passes, TooManyStopTheRun) {
  const FractureRun run(input_deck("cracked_plate", {"fracture.max_passes=3"}));
  EXPECT_THAT(run.stopped, HasSubstr("bonds still break after 3 passes at t = "));
  EXPECT_THAT(run.stopped, HasSubstr("stopped at t = "));
  EXPECT_EQ(run.records.stopped_after, static_cast<int>(run.records.steps.size()));
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
  solve::LoadStepper stepper(deck, scene);
  // Until the first bond breaks.
  struct UntilBroken : FractureRecorder {
    const solve::LoadStepper* stepper = nullptr;
    const mechanics::Scene* scene = nullptr;
    std::vector<double> strain;
    void bonds_broken(const solve::BreakingPass& pass) override {
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
}  // namespace perinox::testing
