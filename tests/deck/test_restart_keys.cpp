/// Tests which keys of a deck may change on a restart.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "perinox/deck/read.hpp"
#include "perinox/deck/restart.hpp"
#include "perinox/materials/material.hpp"

namespace perinox::deck {
namespace {

using ::testing::HasSubstr;

const char* text = R"(
dimension: 3
body: [{name: block, shape: {box: {min: [0, 0, 0], max: [3, 3, 4]}}, spacing: 1, material: steel}]
horizon: {ratio: 2.015}
materials: {steel: {model: elastic, bulk_modulus: 160e3, shear_modulus: 80e3}}
sets: {foot: {where: "z < 1"}}
boundary: [{set: foot, displacement: {x: 0, y: 0, z: 0}}]
steps: {end: 1, count: 4}
)";

Deck read_with(const std::vector<std::string>& overrides = {}) {
  return read_text(text, "deck.yaml", materials::full_schema(), overrides);
}

std::string refused(const std::vector<std::string>& overrides, double t = 0.5) {
  const Deck after = read_with(overrides);
  return refuse_changes(changed_keys(read_with().resolved, after.resolved), after, "checkpoint.h5", t);
}

TEST(RestartKeys, TheResolvedDeckIsTheSameDeck) {
  const std::vector<std::string> damage = {"{critical_stretch: 0.01}", "{critical_bond_energy: 1}",
                                           "{energy_release_rate: 1, criterion: stretch}"};
  std::vector<std::vector<std::string>> variants = {{}, {"dynamics=explicit", "materials.steel.density=1"}};
  for (const std::string& law : damage) variants.push_back({"materials.steel.damage=" + law});
  for (const std::vector<std::string>& overrides : variants) {
    const Deck deck = read_with(overrides);
    const Deck again = read_text(write_resolved(deck), "deck.resolved.yaml", materials::full_schema());
    EXPECT_TRUE(changed_keys(deck.resolved, again.resolved).empty());
  }
}

TEST(RestartKeys, WhatDecidesOnlyHowStepsAreFoundMayChange) {
  EXPECT_EQ(refused({}), "");
  EXPECT_EQ(refused({"steps.end=2", "steps.count=20", "steps.time_limit=3", "solver.newton.tolerance=1e-9",
                     "output.checkpoint_every=3", "title=other"}),
            "");
}

TEST(RestartKeys, AnotherProblemIsRefusedByName) {
  const std::string sentence = refused({"materials.steel.bulk_modulus=170e3", "horizon.ratio=3.015", "steps.end=2"});
  EXPECT_THAT(sentence, HasSubstr("materials.steel.bulk_modulus (160000 there, 170000 now)"));
  EXPECT_THAT(sentence, HasSubstr("horizon.ratio (2.015 there, 3.015 now)"));
  EXPECT_THAT(sentence, ::testing::Not(HasSubstr("steps.end (")));
}

TEST(RestartKeys, NumbersAreComparedAsNumbers) { EXPECT_EQ(refused({"materials.steel.bulk_modulus=160000"}), ""); }

TEST(RestartKeys, AnEndBeforeTheCheckpointIsRefused) {
  EXPECT_THAT(refused({"steps.end=0.4"}), HasSubstr("steps.end = 0.4 lies before checkpoint.h5, which is at t = 0.5"));
}

TEST(RestartKeys, WhatNoCheckpointHoldsIsNamed) {
  EXPECT_EQ(not_in_checkpoints(read_with()), "");
  EXPECT_EQ(not_in_checkpoints(read_with({"materials.steel.damage={critical_stretch: 0.01}"})), "");
  EXPECT_EQ(not_in_checkpoints(
                read_with({"steps.control=arc-length", "boundary=[{set: foot, displacement: {x: t, y: 0, z: 0}}]"})),
            "arc-length control");
}

}  // namespace
}  // namespace perinox::deck
