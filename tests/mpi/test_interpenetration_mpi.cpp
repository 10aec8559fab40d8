/// Overlaps of faces on several ranks must be as deep and at the same place as on one.
#include <gtest/gtest.h>

#include "support/runs.hpp"

namespace perinox::test {
namespace {

void compare(const std::string& yaml, double least, const char* name) {
  const deck::Deck deck = deck_of(yaml);
  const RunResult alone = run_deck(deck, MPI_COMM_SELF), together = run_deck(deck, MPI_COMM_WORLD);
  ASSERT_EQ(alone.stopped, "");
  ASSERT_EQ(alone.records.steps.size(), together.records.steps.size());
  double difference = 0;
  for (std::size_t k = 0; k < alone.records.steps.size(); ++k)
    difference = std::max(difference, std::abs(*alone.records.steps[k].overlap - *together.records.steps[k].overlap));
  const Communicator world(MPI_COMM_WORLD);
  if (world.is_root())
    std::printf("%s on %d ranks: overlap %.3f, differs by %.1e\n", name, world.size(),
                *alone.records.steps.back().overlap, difference);
  EXPECT_GT(*alone.records.steps.back().overlap, least) << name;
  EXPECT_LE(difference, 1e-9) << name;
}

TEST(InterpenetrationRanks, CrackUnderPressure) {
  compare(R"(
dimension: plane-stress
body: [{name: plate, shape: {box: {min: [0, 0], max: [30, 24]}}, spacing: 1, material: m}]
horizon: {ratio: 3.015}
materials: {m: {model: elastic, young_modulus: 1000, poisson_ratio: 0.3}}
cracks: [{segment: {start: [8, 12], end: [22, 12]}}]
sets: {lo: {where: "y < 3"}, hi: {where: "y > 21"}}
boundary: [{set: lo, displacement: {x: 0, y: 0}}, {set: hi, displacement: {x: 0.2, y: "-2*t"}}]
steps: {end: 1, count: 3}
)",
          0.5, "pressed crack");
}

/// No particle of one body is a ghost on a rank that has only the other one.
TEST(InterpenetrationRanks, ABodyDrivenIntoAnotherFromAfar) {
  compare(R"(
dimension: 3
bond_bodies: false
body:
  - {name: a, shape: {box: {min: [0, 0, 0], max: [8, 8, 6]}}, spacing: 1, material: m}
  - {name: b, shape: {box: {min: [2.2, 2.4, 16], max: [6.2, 6.4, 22]}}, spacing: 1, material: m}
horizon: {length: 2.015}
materials: {m: {model: elastic, young_modulus: 1000, poisson_ratio: 0.3}}
sets: {foot: {where: "z < 2"}, tool: {where: "z > 10"}}
boundary:
  - {set: foot, displacement: {x: 0, y: 0, z: 0}}
  - {set: tool, displacement: {x: 0, y: 0, z: "-12*t"}}
steps: {end: 1, count: 6}
)",
          1.5, "driven body");
}

}  // namespace
}  // namespace perinox::test
