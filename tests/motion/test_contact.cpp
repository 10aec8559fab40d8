/// Short-range contact: bodies that meet, faces of a crack.
#include <gtest/gtest.h>

#include "support/motion.hpp"

namespace perinox::test {
namespace {

TEST(Contact, TwoBarsExchangeTheirVelocities) {
  deck::Deck deck = deck::read(PERINOX_SOURCE_DIR "/inputs/impact_bars.yaml", materials::full_schema(),
                               {"initial_velocity=[{set: left, velocity: {x: 2e4}}]"});
  InMotion bars(deck);
  const double before = bars.momentum()[0], size = bars.mass("left") * 2e4;
  ASSERT_EQ(bars.run(), "");
  const auto after = bars.momentum();
  double lost = std::abs(after[0] - before);
  for (int c = 1; c < 3; ++c) lost = std::max(lost, std::abs(after[c]));
  const double left = bars.momentum("left")[0] / size, right = bars.momentum("right")[0] / size;
  double touched = 0;
  for (const StepRecord& row : bars.records.steps) touched = std::max(touched, row.motion->contact_energy);
  std::printf("bars: momentum off by %.1e, left keeps %.3f, right has %.3f, energy off by %.1e, %lld lists\n",
              lost / size, left, right, worst_gap(bars.records.steps), bars.stepper.motion().contact()->lists());
  EXPECT_LT(lost, 1e-12 * size);  // measured 3.5e-15
  EXPECT_NEAR(left, 0, 0.02);     // measured 0.009
  EXPECT_NEAR(right, 1, 0.02);
  EXPECT_GT(touched, 0);
  EXPECT_EQ(bars.records.steps.back().motion->contact_energy, 0);
  EXPECT_LT(worst_gap(bars.records.steps), 1e-3);  // measured 1.4e-4
}

TEST(Contact, WithoutItBodiesGoThroughEachOther) {
  deck::Deck deck = deck::read(PERINOX_SOURCE_DIR "/inputs/impact_bars.yaml", materials::full_schema());
  deck.motion.contact.reset();
  InMotion bars(deck);
  ASSERT_EQ(bars.run(), "");
  EXPECT_NEAR(bars.momentum("left")[0] / (bars.mass("left") * 1e4), 1, 1e-12);
}

TEST(Contact, FacesOfACrackDoNotPassEachOther) {
  InMotion block(deck_of(steel_box(6, 6, 12, R"(
cracks: [{rectangle: {corner: [-1, -1, 6], edge1: [8, 0, 0], edge2: [0, 8, 0]}}]
explicit: {contact: {}}
sets: {lower: {where: "z < 6"}, upper: {where: "z > 6"}}
initial_velocity: [{set: upper, velocity: {z: -2e4}}]
boundary: []
steps: {end: 2e-5, count: 20}
history: [{name: lower, displacement: lower, component: z}, {name: upper, displacement: upper, component: z}]
)")));
  const double before = block.momentum()[2];
  ASSERT_EQ(block.run(), "");
  double least = 0;
  for (const StepRecord& row : block.records.steps) least = std::min(least, row.history[1] - row.history[0]);
  const double upper = block.momentum("upper")[2] / before, lower = block.momentum("lower")[2] / before;
  std::printf("crack: faces come %.3f nearer, momentum %.3f above, %.3f below, energy off by %.1e\n", -least, upper,
              lower, worst_gap(block.records.steps));
  EXPECT_GT(least, -0.3);  // measured -0.132, of which 0.1 is the way to the contact
  EXPECT_NEAR(upper + lower, 1, 1e-12);
  EXPECT_GT(lower, 0.8);
  EXPECT_LT(worst_gap(block.records.steps), 0.005);  // measured 1.2e-3
}

TEST(Contact, NothingActsBetweenBodiesThatTouchAtTheStart) {
  InMotion cubes(deck_of(R"(
dimension: 3
body:
  - {name: one, shape: {box: {min: [0, 0, 0], max: [4, 4, 4]}}, spacing: 1, material: steel}
  - {name: two, shape: {box: {min: [3.6, 0.3, 0], max: [7.6, 4.3, 4]}}, spacing: 1, material: steel}
overlap: later-wins
bond_bodies: false
horizon: {ratio: 3.015}
materials: {steel: {model: elastic, young_modulus: 210e3, poisson_ratio: 0.3, density: 7.85e-9}}
dynamics: explicit
explicit: {contact: {distance: 1}}
boundary: []
steps: {end: 1e-5, count: 1}
)"));
  ASSERT_EQ(cubes.run(), "");
  EXPECT_GT(cubes.stepper.motion().contact()->pairs(), 0u);
  EXPECT_EQ(cubes.stepper.energies().scale(), 0);
}

/// A fine rod meets a coarse plate in the middle of a cell, where its particles have the widest way between.
TEST(Contact, AFineBodyDoesNotSlipBetweenTheParticlesOfACoarseOne) {
  for (const double h : {0.5, 0.25}) {
    InMotion run(deck_of(fmt::format(R"(
dimension: 3
body:
  - {{name: plate, shape: {{box: {{min: [0, 0, 0], max: [6, 6, 3]}}}}, spacing: 1, material: steel}}
  - {{name: rod, shape: {{box: {{min: [{0}, {0}, 3.8], max: [{1}, {1}, 5.8]}}}}, spacing: {2}, material: steel}}
bond_bodies: false
horizon: {{length: 3.015}}
materials: {{steel: {{model: elastic, young_modulus: 210e3, poisson_ratio: 0.3, density: 7.85e-9}}}}
dynamics: explicit
explicit: {{contact: {{}}}}
sets: {{foot: {{where: "z < 1"}}}}
boundary: [{{set: foot, displacement: {{x: 0, y: 0, z: 0}}}}]
initial_velocity: [{{set: rod, velocity: {{z: -2e4}}}}]
steps: {{end: 2e-4, count: 20}}
history: [{{name: rod, displacement: rod, component: z}}]
)",
                                     3 - h / 2, 3 + h / 2, h)));
    ASSERT_EQ(run.run(), "");
    double lowest = 0;
    for (const StepRecord& step : run.records.steps) lowest = std::min(lowest, step.history[0]);
    std::printf("rod of spacing %g on a plate: goes down by %.3f, ends at %.3f\n", h, lowest,
                run.records.steps.back().history[0]);
    EXPECT_GT(lowest, -1.6);  // the gap is 0.8
    EXPECT_GT(run.records.steps.back().history[0], lowest + 0.5);
  }
}

}  // namespace
}  // namespace perinox::test
