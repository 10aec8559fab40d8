/// What is measured against the size of the body or all its bonds is so part by part: a body far away, of another
/// material, held all over, changes nothing.
#include <gtest/gtest.h>

#include <cmath>

#include "perinox/loads/parts.hpp"
#include "perinox/stepping/hand_over.hpp"
#include "support/breaking_decks.hpp"
#include "support/fracture.hpp"
#include "support/measured.hpp"

namespace perinox::test {
namespace {

using test::measured;

/// The bar that snaps with a softer and denser plate of 1600 particles beside it, which would be slower and larger.
std::string bar_and_plate() {
  std::string yaml = snapping_bar_of("2.015", "{end: 0.5, count: 10}");
  const auto put = [&](const std::string& before, const std::string& text) {
    yaml.insert(yaml.find(before) + before.size(), text);
  };
  put("material: brittle}",
      ", {name: plate, shape: {box: {min: [300, 0], max: [340, 40]}}, spacing: 1, material: soft}");
  put("materials:\n", "  soft: {model: elastic, young_modulus: 1, poisson_ratio: 0.3, density: 1.0e-6}\n");
  put("x > 21", " && x < 100");  // the plate is no part of what is pulled
  put("boundary:\n", "  - {set: plate, displacement: {x: 0, y: 0}}\n");
  return yaml;
}

TEST(Parts, ThePassageOfAWaveIsOfThePartsThatMove) {
  const deck::Deck alone = deck_of(snapping_bar_of("2.015", "{end: 0.5, count: 10}")), both = deck_of(bar_and_plate());
  double passage[2];
  long long bonds[2];
  for (const deck::Deck* deck : {&alone, &both}) {
    const mechanics::Scene scene = mechanics::build_scene(*deck, Communicator(MPI_COMM_SELF));
    const loads::Boundary boundary(*deck, scene);
    const loads::Parts parts = loads::find_parts(*deck, scene, boundary);
    EXPECT_EQ(parts.count(), deck == &alone ? 1u : 2u);
    passage[deck == &both] = stepping::passage_time(*deck, scene, parts);
    bonds[deck == &both] = loads::moving_bonds(scene, parts);
  }
  EXPECT_EQ(passage[1], passage[0]);
  EXPECT_EQ(bonds[1], bonds[0]);
}

TEST(Parts, APlateFarAwayDoesNotChangeHowABarSnaps) {
  const FractureRun alone(deck_of(snapping_bar_of("2.015", "{end: 0.5, count: 10}"))), both(deck_of(bar_and_plate()));
  ASSERT_EQ(alone.stopped, "");
  ASSERT_EQ(both.stopped, "");
  ASSERT_EQ(both.records.phases.size(), 1u);
  EXPECT_EQ(both.records.phases[0].cause, alone.records.phases[0].cause);
  EXPECT_EQ(both.records.phases[0].reason, alone.records.phases[0].reason);
  EXPECT_EQ(both.records.passes.size(), alone.records.passes.size());
  EXPECT_EQ(both.scene.broken().size(), alone.scene.broken().size());
  double most = 0;
  for (std::size_t k = 0; k < alone.records.steps.size(); ++k)
    most = std::max(most, std::abs(both.records.steps[k].history[0] / alone.records.steps[k].history[0] - 1));
  EXPECT_LE(measured("bar that snaps, plate far away: stretch", most), 1e-9);  // 1.7e-11
  EXPECT_NEAR(both.records.phases[0].damped_energy / alone.records.phases[0].damped_energy, 1, 1e-9);
}

TEST(Parts, HalfTheSizeOfABodyIsOfThePartThatMoves) {
  const deck::Deck alone = deck_of(snapping_bar_of("2.015", "{end: 0.5, count: 10}")), both = deck_of(bar_and_plate());
  for (const deck::Deck* deck : {&alone, &both}) {
    const mechanics::Scene scene = mechanics::build_scene(*deck, Communicator(MPI_COMM_SELF));
    const loads::Boundary boundary(*deck, scene);
    std::vector<double> displacement(scene.owned_unknowns(), 0.0);
    const double half = std::hypot(23, 5) / 2;
    displacement[20] = 0.99 * half;  // the eleventh particle in x, beyond the wall
    EXPECT_FALSE(loads::moves_beyond_small(scene, boundary, displacement.data()));
    displacement[20] = 1.01 * half;
    EXPECT_TRUE(loads::moves_beyond_small(scene, boundary, displacement.data()));
    // Not where the support moves it: the first particle is held.
    displacement[0] = half;
    EXPECT_FALSE(loads::moves_beyond_small(scene, boundary, displacement.data()));
  }
}

}  // namespace
}  // namespace perinox::test
