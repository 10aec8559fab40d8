/// Loads that go back to nothing, and stay there: every reaction vanishes with the displacement, and each step must
/// still know when it has found its equilibrium.
#include <gtest/gtest.h>

#include <cmath>

#include "support/fracture.hpp"
#include "support/measured.hpp"

namespace perinox::test {
namespace {

/// Up, down to exactly nothing at t = 2, nothing until t = 3, and a quarter the other way and back.
const std::string course = "(t<2 ? 1-abs(1-t) : t<3 ? 0 : -0.25*(1-abs(4-t)))";

struct Scene {
  std::string name, dimension, body, sets, load;
};

const std::vector<Scene>& scenes() {
  static const std::string solid = "{box: {min: [0, 0, 0], max: [4, 4, 8]}}",
                           plate = "{box: {min: [0, 0], max: [12, 5]}}";
  static const std::string ends = "{lo: {where: \"z<2\"}, hi: {where: \"z>6\"}}",
                           sides = "{lo: {where: \"x<2\"}, hi: {where: \"x>10\"}}";
  static const std::vector<Scene> all{
      {"displacement", "3", solid, ends, "displacement: {z: \"0.02*" + course + "\"}"},
      {"clamped", "3", solid, ends, "displacement: {x: 0, y: \"0.01*" + course + "\", z: \"0.02*" + course + "\"}"},
      {"force", "3", solid, ends, "force: {x: \"3*" + course + "\", z: \"30*" + course + "\"}"},
      {"pressure", "3", solid, ends, "pressure: \"2*" + course + "\", facing: [0, 0, 1]"},
      {"body force", "3", solid, ends, "body_force: {y: \"0.3*" + course + "\"}"},
      {"plane displacement", "plane-strain", plate, sides, "displacement: {x: \"0.02*" + course + "\"}"},
      {"plane force", "plane-stress", plate, sides, "force: {x: \"5*" + course + "\", y: \"0.5*" + course + "\"}"},
      {"plane traction", "plane-stress", plate, sides, "traction: {x: \"2*" + course + "\"}, facing: [1, 0]"}};
  return all;
}

std::string deck_text(const Scene& scene, const std::string& material) {
  return fmt::format(R"(
dimension: {}
body: [{{name: p, shape: {}, spacing: 1, material: m}}]
horizon: {{ratio: 2.015}}
materials: {{m: {}}}
sets: {}
boundary:
  - {{set: lo, displacement: {{x: 0, y: 0{}}}}}
  - {{set: hi, {}}}
steps: {{end: 5, count: 5}}
history: [{{name: held, reaction: lo, component: y}}, {{name: far, displacement: hi, component: {}}}]
)",
                     scene.dimension, scene.body, material, scene.sets, scene.dimension == "3" ? ", z: 0" : "",
                     scene.load, scene.dimension == "3" ? "z" : "x");
}

const std::string elastic = "{model: elastic, young_modulus: 1000, poisson_ratio: 0.3}";

/// The run comes to its end in these few iterations, and in every step without load nothing is left.
void expect_nothing_left(const deck::Deck& deck, const std::string& name) {
  SCOPED_TRACE(name);
  const FractureRun run(deck);
  ASSERT_EQ(run.stopped, "");
  EXPECT_TRUE(run.records.rejected.empty());
  EXPECT_TRUE(run.records.begun.empty()) << "goes on in time";
  ASSERT_EQ(run.records.steps.size(), 5u);
  const double most = run.records.steps[0].stored_energy;
  ASSERT_GT(most, 0);
  for (const std::size_t k : {1, 2, 4}) {
    const StepRecord& step = run.records.steps[k];
    EXPECT_LE(step.stored_energy, 1e-15 * most) << "step " << step.step;  // 1.1e-16: 1e-8 of the displacement
    EXPECT_LE(std::abs(step.external_work), 1e-8 * most) << "step " << step.step;
    EXPECT_LE(step.newton_iterations, 12) << "step " << step.step;
  }
  // The way through nothing has left no trace in what comes after it: a quarter of the load stores a sixteenth.
  if (deck.small_strain) {
    EXPECT_NEAR(run.records.steps[3].stored_energy / most, 1.0 / 16, 1e-8);
  }
}

TEST(Unloading, EverySceneAndDeformation) {
  for (const Scene& scene : scenes())
    for (const char* deformation : {"finite", "small"})
      expect_nothing_left(deck_of(deck_text(scene, elastic), {std::string("deformation=") + deformation}),
                          scene.name + ", " + deformation);
}

TEST(Unloading, EverySolver) {
  const std::vector<std::vector<std::string>> solvers{
      {"solver.linear.method=gmres"},
      {"solver.linear.method=cg", "solver.linear.preconditioner=none"},
      {"solver.linear.preconditioner=block-jacobi"},
      {"solver.linear.preconditioner=two-level"},
      {"solver.tangent=assembled"},
      {"solver.tangent=assembled", "solver.linear.method=direct"},
      {"solver.tangent=assembled", "solver.linear.preconditioner=chebyshev"},
      {"solver.tangent=assembled", "solver.linear.preconditioner=symmetric-gauss-seidel"},
      {"solver.tangent=assembled", "solver.linear.preconditioner=ilu"},
      {"solver.tangent=assembled", "solver.linear.preconditioner=jacobi"},
      {"solver.newton.line_search=full-step"},
      {"solver.newton.forcing=constant"},
      {"steps.adaptive=false"}};
  for (const std::size_t k : {0, 2, 6})
    for (std::vector<std::string> solver : solvers) {
      const std::string name = fmt::format("{}, {}", scenes()[k].name, fmt::join(solver, " "));
      expect_nothing_left(deck_of(deck_text(scenes()[k], elastic), solver), name);
      solver.push_back("deformation=small");
      expect_nothing_left(deck_of(deck_text(scenes()[k], elastic), solver), name + ", small");
    }
}

TEST(Unloading, EveryMaterialThatHasNotFlowedOrBroken) {
  const std::string moduli = "young_modulus: 1000, poisson_ratio: 0.3, density: 1e-9";
  for (const std::string& material :
       {"{model: elastic-plastic, " + moduli + ", yield_stress: {tension: 50}}",
        "{model: elastic-plastic, " + moduli + ", yield_stress: {tension: 50}, hardening_modulus: {tension: 100}}",
        "{model: elastic-plastic, " + moduli +
            ", yield_stress: {tension: 50}, kinematic_hardening_modulus: {tension: 100}}",
        "{model: elastic, " + moduli + ", damage: {critical_stretch: 0.1}}",
        "{model: elastic-plastic, " + moduli + ", yield_stress: {tension: 50}, damage: {ductile: {d0: 0.1, c: 1.5}}}"})
    for (const std::size_t k : {1, 2, 6}) {
      expect_nothing_left(deck_of(deck_text(scenes()[k], material)), scenes()[k].name + ", " + material);
      expect_nothing_left(deck_of(deck_text(scenes()[k], material), {"deformation=small"}),
                          scenes()[k].name + ", small, " + material);
    }
}

// The same numbers whatever the units: nothing is compared with a length or a force of no meaning.
TEST(Unloading, EveryUnit) {
  const auto in_units = [](double length, double stress) {
    const double force = stress * length * length;
    return fmt::format(R"(
dimension: 3
body: [{{name: p, shape: {{box: {{min: [0, 0, 0], max: [{0}, {0}, {1}]}}}}, spacing: {2}, material: m}}]
horizon: {{ratio: 2.015}}
materials: {{m: {{model: elastic, young_modulus: {3}, poisson_ratio: 0.3}}}}
sets: {{lo: {{where: "z<{4}"}}, hi: {{where: "z>{5}"}}}}
boundary:
  - {{set: lo, displacement: {{x: 0, y: 0, z: 0}}}}
  - {{set: hi, force: {{x: "{6}*{8}", z: "{7}*{8}"}}}}
steps: {{end: 5, count: 5}}
)",
                       4 * length, 8 * length, length, 1000 * stress, 2 * length, 6 * length, 3 * force, 30 * force,
                       course);
  };
  for (const double length : {1e-9, 1.0, 1e6})
    for (const double stress : {1e-6, 1.0, 1e9})
      expect_nothing_left(deck_of(in_units(length, stress)), fmt::format("length {:g}, stress {:g}", length, stress));
}

// Step after step without any load: what is left does not shrink until it leaves double precision.
TEST(Unloading, NothingForLong) {
  for (const std::size_t k : {0, 2}) {
    std::string yaml = deck_text(scenes()[k], elastic);
    for (std::size_t at = yaml.find(course); at != std::string::npos; at = yaml.find(course))
      yaml.replace(at, course.size(), "(t<2 ? 1-abs(1-t) : 0)");
    const RunResult run = run_deck(deck_of(yaml, {"steps.end=60", "steps.count=60"}));
    ASSERT_EQ(run.stopped, "");
    EXPECT_TRUE(run.records.rejected.empty());
    ASSERT_EQ(run.records.steps.size(), 60u);
    for (std::size_t s = 10; s < 60; ++s) EXPECT_LE(run.records.steps[s].newton_iterations, 1) << "step " << s + 1;
  }
}

// From a large load to a small one in a single step: the small one's answer is as good as its own.
TEST(Unloading, NearlyNothing) {
  const auto at_end = [](const std::string& formula) {
    std::string yaml = deck_text(scenes()[2], elastic);
    const std::string load = scenes()[2].load;
    yaml.replace(yaml.find(load), load.size(), "force: {x: \"0.1*(" + formula + ")\", z: \"" + formula + "\"}");
    return run_deck(deck_of(yaml, {"steps.end=2", "steps.count=2", "deformation=small"}));
  };
  const RunResult way = at_end("t<1.5 ? 30*t : 3e-5"), own = at_end("1.5e-5*t");
  ASSERT_EQ(way.stopped, "");
  EXPECT_LE(test::measured("a millionth of the load after all of it",
                           relative_difference(way.displacement, own.displacement)),
            1e-7);
}

}  // namespace
}  // namespace perinox::test
