/// On several ranks the same bonds must break as on one: in passes, in motion, and from one to the other.
#include <gtest/gtest.h>

#include <fstream>
#include <random>

#include "support/breaking_decks.hpp"
#include "support/fracture.hpp"
#include "support/motion.hpp"
#include "support/shuffled_body.hpp"

namespace perinox::test {
namespace {

/// Bonds of all ranks, on every rank. A scene reports each bond on one rank only; a bond reported twice would show.
std::vector<std::array<GlobalId, 2>> gathered(const mechanics::Scene& scene, const Communicator& ranks) {
  std::vector<double> flat;
  for (const auto& ids : scene.broken())
    flat.insert(flat.end(), {static_cast<double>(ids[0]), static_cast<double>(ids[1])});
  const std::vector<double> all = ranks.gather(flat);
  std::vector<std::array<GlobalId, 2>> bonds;
  for (std::size_t k = 0; k < all.size(); k += 2)
    bonds.push_back({static_cast<GlobalId>(all[k]), static_cast<GlobalId>(all[k + 1])});
  std::sort(bonds.begin(), bonds.end());
  return bonds;
}

void compare(const deck::Deck& deck, const char* name, std::size_t least, const char* note = "") {
  const Communicator world(MPI_COMM_WORLD);
  const FractureRun alone(deck, MPI_COMM_SELF), together(deck, MPI_COMM_WORLD);
  EXPECT_EQ(alone.stopped, together.stopped);
  const auto one = gathered(alone.scene, Communicator(MPI_COMM_SELF)), many = gathered(together.scene, world);
  EXPECT_GE(one.size(), least);
  EXPECT_EQ(one, many);
  if (*note) {
    EXPECT_TRUE(alone.records.noted(note)) << note;
  }
  EXPECT_EQ(alone.records.notes.size(), together.records.notes.size());

  ASSERT_EQ(together.records.phases.size(), alone.records.phases.size());
  for (std::size_t k = 0; k < alone.records.phases.size(); ++k)
    EXPECT_EQ(together.records.phases[k].cause, alone.records.phases[k].cause);
  ASSERT_EQ(together.records.passes.size(), alone.records.passes.size());
  for (std::size_t k = 0; k < alone.records.passes.size(); ++k) {
    EXPECT_EQ(together.records.passes[k].critical, alone.records.passes[k].critical);
    EXPECT_EQ(together.records.passes[k].broken, alone.records.passes[k].broken);
  }
  ASSERT_EQ(together.records.steps.size(), alone.records.steps.size());
  double apart = 0;
  for (std::size_t k = 0; k < alone.records.steps.size(); ++k) {
    const StepRecord &here = alone.records.steps[k], &there = together.records.steps[k];
    EXPECT_EQ(there.fracture->passes, here.fracture->passes);
    EXPECT_EQ(there.fracture->broken_bonds, here.fracture->broken_bonds);
    if (here.motion) {
      EXPECT_EQ(there.motion->time_steps, here.motion->time_steps);
    }
    apart = std::max(apart, std::abs(there.fracture->released_energy - here.fracture->released_energy));
  }
  const double released = alone.records.steps.back().fracture->released_energy;
  if (world.is_root())
    std::printf("%s on %d ranks: %zu bonds broken, released energy apart by %.1e\n", name, world.size(), one.size(),
                released > 0 ? apart / released : apart);
  EXPECT_LE(apart, 1e-10 * released);  // 7.3e-15 on 3 ranks
}

std::string opened_plate(const std::string& shape, const std::string& horizon, const std::string& damage) {
  return fmt::format(R"yaml(
dimension: plane-stress
body: [{{name: plate, shape: {}, spacing: 1, material: brittle}}]
horizon: {{{}}}
cracks: [{{segment: {{start: [0, 8], end: [7, 8]}}}}]
materials: {{brittle: {{model: elastic, young_modulus: 1000, poisson_ratio: 0.3, {}}}}}
sets: {{bottom: {{where: "y < 3"}}, top: {{where: "y > 13"}}}}
boundary:
  - {{set: bottom, displacement: {{x: 0, y: 0}}}}
  - {{set: top, displacement: {{x: 0, y: "t*(1 - x/22)"}}}}
fracture: {{unbreakable: [bottom, top]}}
steps: {{end: 0.06, count: 6}}
)yaml",
                     shape, horizon, damage);
}

const char* const lattice = "{box: {min: [0, 0], max: [20, 16]}}";

TEST(FractureRanks, ACrackOnALattice) {
  compare(deck_of(opened_plate(lattice, "ratio: 3.015", "damage: {energy_release_rate: 0.05}")), "crack on a lattice",
          60);
}

TEST(FractureRanks, ACrackOnALatticeManyBondsAPass) {
  const deck::Deck deck = deck_of(opened_plate(lattice, "ratio: 3.015", "damage: {critical_stretch: 0.004}"),
                                  {"fracture.pass_share=0.002", "quadrature=partial-volume", "influence=inverse"});
  compare(deck, "crack on a lattice, many bonds a pass", 20);
}

/// The lattice's particles, moved at random by at most a tenth of their spacing.
class JitteredPlate {
 public:
  JitteredPlate() : file_(directory_ / "cloud.csv") {
    int rank = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    if (rank == 0) {
      std::mt19937 generator(11);
      std::uniform_real_distribution<double> step(-0.1, 0.1);
      std::ofstream out(file_);
      out.precision(17);
      out << "x,y,z,volume\n";
      for (int j = 0; j < 16; ++j)
        for (int i = 0; i < 20; ++i) {
          const double x = i + 0.5 + step(generator), y = j + 0.5 + step(generator);
          out << x << ',' << y << ",0,1\n";
        }
    }
    MPI_Barrier(MPI_COMM_WORLD);
  }
  std::string shape() const { return "{file: " + file_ + "}"; }

 private:
  test::TemporaryDirectory directory_;
  std::string file_;
};

TEST(FractureRanks, ACrackInACloud) {
  const JitteredPlate plate;
  compare(deck_of(opened_plate(plate.shape(), "length: 3.015", "damage: {energy_release_rate: 0.05}")),
          "crack in a cloud", 30);
  compare(deck_of(opened_plate(plate.shape(), "length: 3.015", "damage: {critical_stretch: 0.004}"),
                  {"fracture.pass_share=0.002"}),
          "crack in a cloud, many bonds a pass", 20);
}

TEST(FractureRanks, ADuctileBar) {
  compare(deck_of(R"(
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
    damage: {ductile: {d0: 0.02, c: 0.5}}
sets: {bottom: {where: "y < 3"}, top: {where: "y > 21"}}
boundary:
  - {set: bottom, displacement: {x: 0, y: 0}}
  - {set: top, displacement: {x: 0, y: "0.2*t"}}
fracture: {unbreakable: [bottom, top]}
steps: {end: 0.8, count: 16}
)"),
          "ductile bar", 5);
}

TEST(FractureRanks, ABarThatSnapsAndComesToRest) {
  compare(deck_of(snapping_bar_of("2.015", "{end: 0.25, count: 5}")), "bar that snaps", 15,
          "a piece of 72 particles, the first of them 12, has lost all support");
}

TEST(FractureRanks, APieceThatComesLoose) {
  compare(deck_of(torn_chain, {"steps.end=0.5", "steps.count=4"}), "chain torn apart", 100,
          "a piece of 36 particles, the first of them 36, has lost all support");
}

/// In explicit motion bonds are checked in every time step. Here a bar hits a wall and spalls.
TEST(FractureRanks, AMotionInWhichBondsBreak) {
  for (const char* law : {"critical_stretch: 0.004", "energy_release_rate: 2"}) {
    const deck::Deck deck = deck_of(fmt::format(R"(
dimension: 3
body: [{{name: bar, shape: {{box: {{min: [0, 0, 0], max: [4, 4, 14]}}}}, spacing: 1, material: glass}}]
horizon: {{ratio: 2.015}}
materials:
  glass: {{model: elastic, young_modulus: 70e3, poisson_ratio: 0.25, density: 2.5e-9, damage: {{{}}}}}
dynamics: explicit
sets: {{foot: {{where: "z < 2"}}}}
initial_velocity: [{{set: all, velocity: {{z: -6e4}}}}]
boundary: [{{set: foot, displacement: {{z: 0}}}}]
steps: {{end: 1.2e-5, count: 4}}
)",
                                                law));
    std::vector<std::array<GlobalId, 2>> broken[2];
    for (const bool many : {false, true}) {
      const Communicator ranks(many ? MPI_COMM_WORLD : MPI_COMM_SELF);
      mechanics::Scene scene = mechanics::build_scene(deck, ranks);
      stepping::TimeStepper stepper(deck, scene);
      EXPECT_EQ(run_with(stepper).stopped, "");
      broken[many] = gathered(scene, ranks);
    }
    EXPECT_GT(broken[0].size(), 20u);
    EXPECT_EQ(broken[0], broken[1]);
    if (Communicator(MPI_COMM_WORLD).is_root())
      std::printf("bar at a wall, %s: %zu bonds broken\n", law, broken[0].size());
  }
}

}  // namespace
}  // namespace perinox::test
