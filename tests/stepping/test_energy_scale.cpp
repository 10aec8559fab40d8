/// Energies of a body that is only moved or turned, or let go again, are rounding: their balance is judged against what
/// the run has stored, or rounding itself.
#include <gtest/gtest.h>

#include <cmath>

#include "support/measured.hpp"
#include "support/runs.hpp"

namespace perinox::test {
namespace {

/// A bar with the given boundary, its lengths in `length`.
std::string bar(const std::string& boundary, const std::string& more = "", double length = 1) {
  return fmt::format(R"(
dimension: 3
body: [{{name: bar, shape: {{box: {{min: [0, 0, 0], max: [{0}, {0}, {1}]}}}}, spacing: {2}, material: m}}]
horizon: {{ratio: 2.015}}
materials: {{m: {{model: elastic, young_modulus: 1000, poisson_ratio: 0.3, density: 1e-9}}}}
sets: {{lo: {{where: "z<{3}"}}, hi: {{where: "z>{4}"}}}}
boundary: [{5}]
steps: {{end: 1, count: 4}}
{6})",
                     4 * length, 8 * length, length, 2 * length, 6 * length, boundary, more);
}

const std::string turned = "displacement: {x: \"x*(cos(t)-1)-y*sin(t)\", y: \"x*sin(t)+y*(cos(t)-1)\", z: 0}";
const std::string shifted = "displacement: {x: \"3*t\", y: \"-2*t\", z: \"t\"}";

double both_ends(const std::string& motion, const std::vector<std::string>& overrides = {}, double length = 1) {
  const RunResult run =
      run_deck(deck_of(bar("{set: lo, " + motion + "}, {set: hi, " + motion + "}", "", length), overrides));
  EXPECT_EQ(run.stopped, "");
  return std::abs(run.energies.unaccounted());
}

// 1e-4 is where the program warns.
TEST(EnergyScale, ABodyThatIsOnlyMoved) {
  double worst = 0;
  for (const double length : {1e-6, 1.0, 1e6})
    for (const char* deformation : {"deformation=finite", "deformation=small"})
      worst = std::max(worst,
                       both_ends(fmt::format("displacement: {{x: \"3*{0}*t\", y: \"-2*{0}*t\", z: \"{0}*t\"}}", length),
                                 {deformation}, length));
  EXPECT_LE(test::measured("moved: energy not accounted for", worst), 1e-5);
}

TEST(EnergyScale, ABodyThatIsOnlyTurned) {
  EXPECT_LE(test::measured("turned: energy not accounted for", both_ends(turned)), 1e-5);
  EXPECT_LE(test::measured("turned a little: energy not accounted for",
                           both_ends("displacement: {x: \"-0.01*t*y\", y: \"0.01*t*x\", z: 0}", {"deformation=small"})),
            1e-5);
}

TEST(EnergyScale, AllOfItPrescribed) {
  for (const std::string& motion : {shifted, turned}) {
    const RunResult run = run_deck(deck_of(bar("{set: all, " + motion + "}")));
    ASSERT_EQ(run.stopped, "");
    EXPECT_LE(test::measured("all prescribed: energy not accounted for", std::abs(run.energies.unaccounted())), 1e-5);
  }
}

TEST(EnergyScale, ABodyThatIsPulledAndLetGo) {
  const std::string pull =
      "{set: lo, displacement: {x: 0, y: 0, z: 0}}, {set: hi, displacement: {z: \"0.1*(0.5-abs(t-0.5))\"}}";
  for (const char* deformation : {"deformation=finite", "deformation=small"}) {
    const RunResult run = run_deck(deck_of(bar(pull), {deformation}));
    ASSERT_EQ(run.stopped, "");
    EXPECT_LE(std::abs(run.energies.stored), 1e-12 * run.energies.scale);
    EXPECT_LE(test::measured("let go: energy not accounted for", std::abs(run.energies.unaccounted())), 1e-8);
  }
}

// What is missing is still seen: one step of finite strain with a free path, solved far too loosely.
TEST(EnergyScale, ALossIsStillSeen) {
  const std::string pull = "{set: lo, displacement: {x: 0, y: 0, z: 0}}, {set: hi, force: {x: \"20*t\", z: \"100*t\"}}";
  const RunResult run = run_deck(
      deck_of(bar(pull), {"solver.newton.tolerance=0.1", "solver.newton.update_tolerance=1", "steps.count=1"}));
  ASSERT_EQ(run.stopped, "");
  EXPECT_GT(std::abs(run.energies.unaccounted()), 1e-4);
}

// In motion: moved as a whole and brought to a stop, where neither stored nor kinetic energy is left.
TEST(EnergyScale, AMotionThatEndsAtRest) {
  const std::string there = "{set: all, displacement: {x: \"t*t*(1-t)*(1-t)\", y: 0, z: 0}}";
  const deck::Deck deck = deck_of(bar(there, "dynamics: explicit"), {"steps.end=1", "explicit.time_step=1e-3"});
  mechanics::Scene scene = mechanics::build_scene(deck, Communicator(MPI_COMM_SELF));
  stepping::TimeStepper stepper(deck, scene);
  Recorder records;
  stepper.run(records);
  EXPECT_LE(test::measured("moved in time: largest gain of energy", stepper.worst_gain()), 1e-2);
}

}  // namespace
}  // namespace perinox::test
