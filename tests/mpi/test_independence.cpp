/// The answer of a body must depend on nothing unrelated: not on the number of ranks, not on a body far away, not on
/// whether a cloud's points happen to lie on a lattice.
#include <gtest/gtest.h>

#include <fstream>

#include "support/bodies.hpp"
#include "support/measured.hpp"
#include "support/runs.hpp"

namespace perinox::test {
namespace {

std::string bar(const std::string& far_body, const std::string& far_set, const std::string& far_load,
                const std::string& extra = "") {
  return R"(
dimension: 3
deformation: small
bond_bodies: false
body:
  - {name: a, shape: {box: {min: [0,0,0], max: [6,6,14]}}, spacing: 1, material: m}
)" + far_body +
         R"(horizon: {length: 3.015}
materials: {m: {model: elastic, young_modulus: 1000, poisson_ratio: 0.3}}
sets: {lo: {where: "z<3 && x<50"}, hi: {where: "z>11 && x<50"})" +
         far_set + R"(}
boundary:
  - {set: lo, displacement: {x: 0, y: 0, z: 0}}
  - {set: hi, displacement: {x: "0.01*t", y: 0, z: "0.02*t"}}
)" + far_load +
         R"(steps: {end: 1, count: 1}
solver: {newton: {tolerance: 1e-12}}
history: [{name: Fz, reaction: hi, component: z}, {name: Fx, reaction: hi, component: x}]
)" + extra;
}

const char* far_load = "  - {set: far, displacement: {x: 0, y: 0, z: 0}}\n";

std::vector<double> reactions(const std::string& deck, MPI_Comm comm) {
  const RunResult run = run_deck(deck_of(deck), comm);
  EXPECT_EQ(run.stopped, "");
  return run.records.steps.back().history;
}

/// The first deck of a report, which once gave 80.833, 82.500, 80.833, 82.500 on 1 to 4 ranks, and 82.500 without the
/// far body.
TEST(Independence, OfRanksAndOfABodyFarAway) {
  const std::vector<double> alone = reactions(bar("", "", ""), MPI_COMM_SELF);
  EXPECT_NEAR(alone[0], 82.500, 5e-4);  // as reported
  const std::string off_the_lattice =
      "  - {name: b, shape: {box: {min: [100.3,0,0], max: [106.3,6,14]}}, spacing: 1, material: m}\n";
  const std::string finer =
      "  - {name: b, shape: {box: {min: [100,0,0], max: [103,3,3]}}, spacing: 0.75, material: m}\n";
  const std::string ball =
      "  - {name: b, shape: {sphere: {center: [103,3,3], radius: 3.2}}, spacing: 1.2, material: m}\n";
  const body::fixture::TextFile cloud("far_cloud.csv", "x,y,z,volume\n100,0,0,1\n101,0,0,1\n100,1,0,1\n100,0,1,1\n");
  const std::string points = "  - {name: b, shape: {file: " + cloud.path() + "}, material: m}\n";
  for (const std::string& body : {off_the_lattice, finer, ball, points})
    for (MPI_Comm comm : {MPI_COMM_SELF, MPI_COMM_WORLD}) {
      const std::vector<double> with = reactions(bar(body, ", far: {where: \"x>50\"}", far_load), comm);
      for (std::size_t k = 0; k < 2; ++k)
        EXPECT_LE(test::measured("far body", std::abs(with[k] / alone[k] - 1)), 1e-10) << body;  // 2e-13
    }
  EXPECT_LE(std::abs(reactions(bar("", "", ""), MPI_COMM_WORLD)[0] / alone[0] - 1), 1e-10);
}

/// Repeats this with every quadrature, where particles stand for parts of cells or not.
TEST(Independence, OfABodyFarAwayWithEveryQuadrature) {
  for (const char* quadrature : {"whole", "partial-volume", "taper-inside", "position-aware", "surface-energy"}) {
    const std::string key = std::string("quadrature: ") + quadrature + "\n";
    const std::vector<double> alone = reactions(bar("", "", "", key), MPI_COMM_SELF);
    const std::vector<double> with =
        reactions(bar("  - {name: b, shape: {box: {min: [100.3,0,0], max: [106.7,6,14]}}, spacing: 0.7, material: m}\n",
                      ", far: {where: \"x>50\"}", far_load, key),
                  MPI_COMM_WORLD);
    for (std::size_t k = 0; k < 2; ++k) EXPECT_LE(test::measured(quadrature, std::abs(with[k] / alone[k] - 1)), 1e-10);
  }
}

/// A bar is a cloud on a lattice. A point that moves by 1e-9 spacings changes the answer by as little, and in
/// proportion (it was once 2 %).
TEST(Independence, OfWhetherACloudLiesOnALattice) {
  const auto pull = [](double moved) {
    std::string rows = "x,y,z,volume\n";
    for (int z = 0; z < 12; ++z)
      for (int y = 0; y < 5; ++y)
        for (int x = 0; x < 5; ++x) {
          const bool this_one = x == 2 && y == 2 && z == 6;
          rows += fmt::format("{:.17g},{},{},1\n", x + 0.5 + (this_one ? moved : 0), y + 0.5, z + 0.5);
        }
    const body::fixture::TextFile cloud("moved_cloud.csv", rows);
    std::string deck = bar("", "", "");
    const std::string shape = "{box: {min: [0,0,0], max: [6,6,14]}}, spacing: 1";
    deck.replace(deck.find(shape), shape.size(), "{file: " + cloud.path() + "}");
    deck.replace(deck.find("z>11"), 4, "z>9 ");
    return reactions(deck, MPI_COMM_WORLD)[0];
  };
  const double there = pull(0), slope = (pull(1e-3) - pull(-1e-3)) / 2e-3;
  EXPECT_LE(test::measured("moved by 1e-9", std::abs(pull(1e-9) / there - 1)), 1e-9);
  const double finer = (pull(1e-5) - pull(-1e-5)) / 2e-5;
  EXPECT_LE(test::measured("slope", std::abs(finer - slope) / there), 1e-5);
}

}  // namespace
}  // namespace perinox::test
