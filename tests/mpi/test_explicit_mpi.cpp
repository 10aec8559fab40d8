/// Motion in time on several ranks must give what one rank gives.
#include <gtest/gtest.h>

#include "support/motion.hpp"
#include "support/thin_bodies.hpp"

namespace perinox::test {
namespace {

void compare(const deck::Deck& deck, const char* name) {
  const RunResult alone = run_deck(deck, MPI_COMM_SELF);
  const RunResult together = run_deck(deck, MPI_COMM_WORLD);
  ASSERT_EQ(alone.stopped, "");
  ASSERT_EQ(together.stopped, "");
  const Communicator world(MPI_COMM_WORLD);
  const double difference = world.max(relative_difference(together.displacement, alone.displacement));
  ASSERT_EQ(together.records.steps.size(), alone.records.steps.size());
  EXPECT_EQ(together.records.steps.back().motion->time_steps, alone.records.steps.back().motion->time_steps);
  const double energy = std::abs(together.motion.sum() / alone.motion.sum() - 1);
  if (world.is_root())
    std::printf("%s on %d ranks: displacement %.1e, energy %.1e\n", name, world.size(), difference, energy);
  EXPECT_LE(difference, 1e-10);
  EXPECT_LE(energy, 1e-10);
}

TEST(ExplicitRanks, BarsThatCollide) {
  // A rank may have one of the bars alone, so the particles that meet are not ghosts of each other.
  deck::Deck deck = deck::read(PERINOX_SOURCE_DIR "/inputs/impact_bars.yaml", materials::full_schema());
  deck.steps.end /= 2;
  deck.steps.count /= 2;
  compare(deck, "colliding bars");
}

TEST(ExplicitRanks, PlasticBarAtAWall) {
  compare(deck_of(steel_box(4, 4, 16, R"(
sets: {foot: {where: "z < 3"}}
initial_velocity: [{set: all, velocity: {z: -2e4}}]
boundary: [{set: foot, displacement: {z: 0}}]
steps: {end: 6e-6, count: 3}
)",
                            "elastic-plastic")),
          "plastic bar");
}

/// Some rank has nothing that flows and must take the time step of the others.
TEST(ExplicitRanks, ElasticBarThatHitsAPlasticOne) {
  compare(deck_of(R"(
dimension: plane-stress
body:
  - {name: a, shape: {box: {min: [0, 0], max: [20, 8]}}, spacing: 1, material: el}
  - {name: b, shape: {box: {min: [20, 0], max: [40, 8]}}, spacing: 1, material: pl}
horizon: {ratio: 3.015}
materials:
  el: {model: elastic, young_modulus: 1000, poisson_ratio: 0.3, density: 1.0e-9}
  pl: {model: elastic-plastic, young_modulus: 2000, poisson_ratio: 0.3, density: 2.0e-9, yield_stress: {tension: 9}}
dynamics: explicit
initial_velocity: [{set: a, velocity: {x: 1e4}}]
steps: {end: 3e-5, count: 3}
)"),
          "elastic and plastic bar");
}

TEST(ExplicitRanks, CloudsThatCollideInPlaneStress) {
  compare(deck_of(R"(
dimension: plane-stress
body:
  - {name: disc, shape: {sphere: {center: [0, 0], radius: 6}}, spacing: 1, material: steel}
  - {name: plate, shape: {box: {min: [7, -9], max: [13, 9]}}, spacing: 0.75, material: steel}
bond_bodies: false
horizon: {length: 3.015}
materials: {steel: {model: elastic, young_modulus: 210e3, poisson_ratio: 0.3, density: 7.85e-9}}
dynamics: explicit
explicit: {contact: {}, damping: 1e3}
sets: {edge: {where: "x > 11"}}
initial_velocity: [{set: disc, velocity: {x: 5e4, y: 1e4}}]
boundary: [{set: edge, velocity: {x: "1e9*t"}}]
steps: {end: 3e-5, count: 5}
)"),
          "disc against a plate");
}

TEST(ExplicitRanks, BodiesOneParticleThick) {
  for (const ThinScene& scene : thin_scenes)
    for (const bool far : {false, true}) compare(deck_of(thin_deck(scene, far)), scene.name);
}

}  // namespace
}  // namespace perinox::test
