/// Motion in time: flight, waves, vibration, energies, prescribed motion, damping, stability.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "perinox/mechanics/internal_force.hpp"
#include "perinox/mechanics/tangent.hpp"
#include "perinox/motion/stable_step.hpp"
#include "support/motion.hpp"
#include "support/restarts.hpp"

namespace perinox::test {
namespace {

using ::testing::HasSubstr;

TEST(ExplicitMotion, AFreeBodyFliesStraightWithoutStrain) {
  InMotion body(deck_of(steel_box(6, 5, 4, R"(
initial_velocity: [{set: all, velocity: {x: 1e4, y: -2e4, z: 3e4}}]
boundary: []
steps: {end: 1e-4, count: 3}
output: {fields: [velocity]}
)")));
  const auto before = body.momentum();
  ASSERT_EQ(body.run(), "");
  ASSERT_EQ(body.records.steps.size(), 3u);
  EXPECT_EQ(body.records.steps[0].t, 1e-4 * 1 / 3);
  EXPECT_EQ(body.records.steps[1].motion->time, 1e-4 * 2 / 3);
  const StepRecord& end = body.records.steps.back();
  const double kinetic = 0.5 * body.mass() * 14e8;
  const std::vector<double>& u = body.stepper.motion().committed().displacement();
  double off = 0;
  for (std::size_t k = 0; k < body.scene.owned_unknowns(); k += 3)
    off = std::max({off, std::abs(u[k] - 1), std::abs(u[k + 1] + 2), std::abs(u[k + 2] - 3)});
  const auto after = body.momentum();
  const double lost = std::abs(after[2] / before[2] - 1);
  std::printf("flight: displacement off by %.1e, momentum by %.1e, stored over kinetic %.1e\n", off, lost,
              end.stored_energy / kinetic);
  EXPECT_LT(off, 1e-10);   // measured 3e-14
  EXPECT_LT(lost, 1e-12);  // measured 0
  EXPECT_LT(end.stored_energy, 1e-20 * kinetic);
  EXPECT_NEAR(end.motion->kinetic_energy, kinetic, 1e-10 * kinetic);
}

TEST(ExplicitMotion, ABarRingsAtTheFrequencyOfItsFirstMode) {
  const RunResult run = run_deck(deck::read(PERINOX_SOURCE_DIR "/inputs/ringing_bar.yaml", materials::full_schema()));
  ASSERT_EQ(run.stopped, "");
  // Times at which the end comes through zero: half a period apart.
  std::vector<double> zeros;
  double t = 0, u = 0;
  for (const StepRecord& row : run.records.steps) {
    if (u * row.history[0] < 0) zeros.push_back(t + (row.t - t) * u / (u - row.history[0]));
    t = row.t;
    u = row.history[0];
  }
  ASSERT_GE(zeros.size(), 6u);
  const double period = 2 * (zeros.back() - zeros.front()) / static_cast<double>(zeros.size() - 1);
  const double exact = 2 * 40 / bar_speed;
  std::printf("ringing bar: period off by %+.2e, energy by %.1e\n", period / exact - 1, worst_gap(run.records.steps));
  EXPECT_NEAR(period / exact, 1, 0.005);          // measured -4.6e-4
  EXPECT_LT(worst_gap(run.records.steps), 1e-6);  // measured 4.5e-8
}

TEST(ExplicitMotion, APulseRunsAlongABarAtTheSpeedOfSound) {
  // The foot is moved by a pulse of velocity of 8e-6 s, 41 spacings long, and everything behind it stays displaced.
  InMotion bar(deck_of(steel_box(3, 3, 120, R"(
sets:
  foot: {where: "z < 3"}
  near: {where: "z > 40 && z < 41"}
  far: {where: "z > 80 && z < 81"}
boundary: [{set: foot, velocity: {z: "t < 8e-6 ? 1e3*sin(pi*t/8e-6)^2 : 0"}}]
steps: {end: 2.2e-5, count: 220}
history: [{name: near, displacement: near, component: z}, {name: far, displacement: far, component: z}]
)")));
  ASSERT_EQ(bar.run(), "");
  const double half = 0.5 * 1e3 * 0.5 * 8e-6;
  double passed[2] = {};
  for (std::size_t k = 1; k < bar.records.steps.size(); ++k)
    for (std::size_t which = 0; which < 2; ++which) {
      const double before = bar.records.steps[k - 1].history[which], after = bar.records.steps[k].history[which];
      if (passed[which] == 0 && after >= half)
        passed[which] = bar.records.steps[k - 1].t + 1e-7 * (half - before) / (after - before);
    }
  const double speed = 40 / (passed[1] - passed[0]);
  const double plateau = bar.records.steps.back().history[0] / (2 * half);
  std::printf("pulse: speed off by %+.2e, displacement behind it by %+.2e, energy by %.1e\n", speed / bar_speed - 1,
              plateau - 1, worst_gap(bar.records.steps));
  EXPECT_NEAR(speed / bar_speed, 1, 0.01);        // measured 3.1e-3
  EXPECT_NEAR(plateau, 1, 0.001);                 // measured 2.4e-5
  EXPECT_LT(worst_gap(bar.records.steps), 1e-6);  // measured 1.6e-8
}

TEST(ExplicitMotion, WorkOfForcesAndDampingAreAccountedFor) {
  InMotion bar(deck_of(steel_box(4, 4, 20, R"yaml(
explicit: {damping: 3e5}
sets: {foot: {where: "z < 3"}, head: {where: "z > 17"}}
boundary:
  - {set: foot, displacement: {x: 0, y: 0, z: "1e-3*sin(5e5*t)"
}
}
  - {set: head, force: {z: "2000*t/1e-5"}}
  - {set: all, traction: {x: 20}, facing: [1, 0, 0]}
steps: {end: 3e-5, count: 30}
)yaml")));
  ASSERT_EQ(bar.run(), "");
  const double gap = worst_gap(bar.records.steps);
  std::printf("forces and damping: energy off by %.1e\n", gap);
  EXPECT_LT(gap, 1e-5);  // measured 1.9e-7
  EXPECT_GT(bar.stepper.energies().damped, 0.1 * bar.stepper.energies().stored);
}

TEST(ExplicitMotion, ALoadThatIsSuddenlyThereIsAccountedFor) {
  // The scheme's kinetic energy begins below zero, by dt^2/8 m a^2: 3e-2 of the energy of the first row.
  InMotion bar(deck_of(steel_box(4, 4, 20, R"(
sets: {head: {where: "z > 17"}}
boundary: [{set: head, force: {z: 2000}}]
steps: {end: 4e-6, count: 20}
)")));
  ASSERT_EQ(bar.run(), "");
  const double gap = bar.stepper.worst_gain();
  std::printf("sudden load: energy off by %.1e\n", gap);
  EXPECT_LT(gap, 1e-4);  // measured 1.8e-6
}

TEST(ExplicitMotion, PlasticFlowIsAccountedForTheBetterTheShorterTheTimeStep) {
  // A bar hits a wall at 40 m/s, five times what it takes to yield: 300 MPa over rho c is 7.4 m/s. The return mapping
  // takes the force at the end of a time step for the plastic work in it, velocity Verlet the mean of both ends.
  const auto gap_with = [](const std::vector<std::string>& overrides) {
    const RunResult run = run_deck(deck_of(steel_box(4, 4, 20, R"(
sets: {foot: {where: "z < 3"}}
initial_velocity: [{set: all, velocity: {z: -4e4}}]
boundary: [{set: foot, displacement: {z: 0}}]
steps: {end: 2e-5, count: 20}
output: {fields: [velocity, plastic_multiplier, equivalent_plastic_strain]}
history: [{name: yielded, yielded: all}]
)",
                                                     "elastic-plastic"),
                                           overrides));
    EXPECT_EQ(run.stopped, "");
    const double gap = worst_gap(run.records.steps), yielded = run.records.steps.back().history[0];
    std::printf("plastic bar, %s: %.0f %% has yielded, dissipated %.2f of the work, energy off by %.1e\n",
                overrides.empty() ? "as usual" : overrides[0].c_str(), 100 * yielded,
                run.energies.dissipated / run.energies.external_work, gap);
    EXPECT_GT(yielded, 0.3);
    EXPECT_GT(run.energies.dissipated, 0.3 * run.energies.external_work);
    return gap;
  };
  const double usual = gap_with({}), half = gap_with({"explicit.safety=0.25"});
  EXPECT_LT(usual, 0.01);  // measured 4.9e-3; with safety 0.8 1.5e-2
  EXPECT_LT(half, 0.7 * usual);
}

TEST(ExplicitMotion, KinematicHardeningAndPlaneStrainAreAccountedFor) {
  const RunResult run = run_deck(deck_of(R"(
dimension: plane-strain
body: [{name: plate, shape: {box: {min: [0, 0], max: [20, 8]}}, spacing: 1, material: steel}]
horizon: {ratio: 3.015}
materials:
  steel: {model: elastic-plastic, young_modulus: 210e3, poisson_ratio: 0.3, density: 7.85e-9, yield_stress: {tension: 300}, kinematic_hardening_modulus: {tension: 5e3}}
dynamics: explicit
sets: {foot: {where: "x < 3"}}
initial_velocity: [{set: all, velocity: {x: 4e4, y: "1e3*x"}}]
boundary: [{set: foot, displacement: {x: 0, y: 0}}]
steps: {end: 2e-5, count: 10}
)"));
  ASSERT_EQ(run.stopped, "");
  std::printf("kinematic hardening: energy off by %.1e\n", worst_gap(run.records.steps));
  EXPECT_GT(run.energies.dissipated, 0.2 * run.energies.external_work);
  EXPECT_LT(worst_gap(run.records.steps), 0.01);  // measured 8.1e-3; with safety 0.8 1.9e-2
}

TEST(ExplicitMotion, DampingSlowsAFreeBodyDownExponentially) {
  InMotion body(deck_of(steel_box(4, 4, 4, R"(
explicit: {damping: 2e4}
initial_velocity: [{set: all, velocity: {x: 1e4}}]
boundary: []
steps: {end: 1e-4, count: 1}
)")));
  ASSERT_EQ(body.run(), "");
  const double left = body.momentum()[0] / (body.mass() * 1e4) / std::exp(-2.0);
  const motion::MotionEnergies& e = body.stepper.energies();
  std::printf("damping: velocity off by %.1e, energy by %.1e\n", left - 1, e.gain() / e.scale());
  EXPECT_NEAR(left, 1, 1e-5);  // measured -3.1e-6
  EXPECT_NEAR(e.damped / (e.external_work * (1 - std::exp(-4.0))), 1, 1e-5);
}

TEST(ExplicitMotion, APrescribedVelocityIsTheDisplacementItAddsUpTo) {
  const std::string bar = steel_box(4, 4, 12, R"(
sets: {foot: {where: "z < 3"}, head: {where: "z > 9"}}
boundary: [{set: head, displacement: {x: 0}}, {set: foot, %}]
steps: {end: 1e-5, count: 4}
)");
  const auto with = [&](const std::string& motion) {
    std::string text = bar;
    return run_deck(deck_of(text.replace(text.find('%'), 1, motion)));
  };
  // Linear in t, so that the trapezoidal rule is exact.
  const RunResult velocity = with("velocity: {y: 10, z: \"100 + 2e8*t\"}");
  const RunResult displacement = with("displacement: {y: 10*t, z: \"100*t + 1e8*t^2\"}");
  ASSERT_EQ(velocity.stopped + displacement.stopped, "");
  const double difference = relative_difference(velocity.displacement, displacement.displacement);
  std::printf("velocity and displacement: fields differ by %.1e\n", difference);
  EXPECT_LT(difference, 1e-10);  // measured 1e-15
  EXPECT_LT(worst_gap(velocity.records.steps), 1e-3);
  EXPECT_LT(worst_gap(displacement.records.steps), 1e-3);
}

TEST(ExplicitMotion, TheLaterOfTwoPrescribedMotionsWins) {
  const std::string cube = steel_box(4, 4, 4, "boundary: [%]\nsteps: {end: 1e-6, count: 1}\n");
  const auto with = [&](const std::string& entries) {
    std::string text = cube;
    return run_deck(deck_of(text.replace(text.find('%'), 1, entries))).displacement.at(0)[0];
  };
  EXPECT_NEAR(with("{set: all, velocity: {x: 100}}, {set: all, displacement: {x: 0}}"), 0, 1e-16);
  EXPECT_NEAR(with("{set: all, displacement: {x: 0}}, {set: all, velocity: {x: 100}}"), 1e-4, 1e-16);
}

/// A shaken cube: every mode is there.
std::string shaken(const std::string& more) {
  return steel_box(5, 5, 5, R"yaml(
initial_velocity: [{set: all, velocity: {x: "sin(7*x*y)", y: "cos(11*y*z+x)", z: "sin(13*x+5*z)"
  }
  }]
boundary: []
steps: {end: 2e-4, count: 2}
)yaml" + more);
}

TEST(StableStep, TheEstimateIsTheLargestEigenvalueAndTheBoundIsOne) {
  for (const char* quadrature : {"whole", "position-aware"}) {
    const deck::Deck deck = deck_of(shaken(fmt::format("quadrature: {}\n", quadrature)));
    const mechanics::Scene scene = mechanics::build_scene(deck, Communicator(MPI_COMM_SELF));
    const mechanics::Committed undeformed(scene);
    const std::vector<double> masses = motion::particle_masses(deck, scene);
    const auto n = static_cast<Eigen::Index>(scene.owned_unknowns());
    const auto tangent = mechanics::make_tangent(scene, deck::TangentForm::consistent);
    tangent->linearise(undeformed, undeformed.displacement().data(), deck::TangentForm::consistent);
    Eigen::MatrixXd k(n, n);
    Eigen::VectorXd x = Eigen::VectorXd::Zero(n), y(n);
    for (Eigen::Index c = 0; c < n; ++c) {
      x[c] = 1;
      tangent->apply(x.data(), y.data());
      k.col(c) = y / masses[0];
      x[c] = 0;
    }
    const double exact = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(k, Eigen::EigenvaluesOnly).eigenvalues()[n - 1];
    const std::vector<char> free(scene.owned_unknowns(), 0);
    const double estimate = motion::largest_eigenvalue(scene, undeformed, masses, free);
    const double bound = *motion::eigenvalue_bound(scene, masses);
    std::printf("%s: estimate %.4f of the largest eigenvalue, bound %.3f\n", quadrature, estimate / exact,
                bound / exact);
    EXPECT_GT(estimate / exact, 0.99);
    EXPECT_LT(estimate / exact, 1.02);
    EXPECT_GE(bound / exact, 1);
    EXPECT_LT(bound / exact, 6);  // measured 1.74 and 4.03
    const std::vector<char> held(scene.owned_unknowns(), 1);
    EXPECT_EQ(motion::largest_eigenvalue(scene, undeformed, masses, held), 0);
  }
}

TEST(StableStep, JustBelowItNothingGrowsAndAboveItTheRunStops) {
  const deck::Deck deck = deck_of(shaken(""));
  const double stable = InMotion(deck).stepper.plan().stable;
  const auto with = [&](double factor) {
    return deck_of(shaken(""), {fmt::format("explicit.time_step={:.17g}", factor * stable)});
  };
  InMotion below(with(0.99));
  EXPECT_EQ(below.stepper.plan().remark, "");
  EXPECT_EQ(below.run(), "");
  EXPECT_GT(below.stepper.motion().time_steps(), 500);
  std::printf("0.99 of the stable time step: energy off by %.1e after %lld time steps\n", below.stepper.worst_gain(),
              below.stepper.motion().time_steps());
  EXPECT_LT(below.stepper.worst_gain(), 1e-3);
  InMotion above(with(1.1));
  EXPECT_THAT(above.stepper.plan().remark, HasSubstr("is above the largest stable one"));
  const std::string stopped = above.run();
  EXPECT_THAT(stopped, HasSubstr(": the energies "));
  EXPECT_THAT(stopped, HasSubstr("take a smaller explicit.time_step"));
  EXPECT_EQ(above.records.stopped_after, 0);
}

TEST(ExplicitMotion, AnEquilibriumWithItsLoadsHeldStaysAtRest) {
  const deck::Deck deck =
      deck_of(pulled_cube(6, 0.02, 1), {"materials.aluminium.density=2.7e-9",
                                        "materials.aluminium.yield_stress.shear=1e9", "solver.newton.tolerance=1e-12"});
  mechanics::Scene scene = mechanics::build_scene(deck, Communicator(MPI_COMM_SELF));
  stepping::LoadStepper quasi_static(deck, scene);
  Recorder nobody;
  quasi_static.run(nobody);
  const std::vector<double> before = quasi_static.committed().displacement();
  mechanics::Committed start(scene);
  mechanics::Trial trial;
  std::vector<double> force(scene.owned_unknowns());
  mechanics::Evaluation evaluation(scene);
  mechanics::internal_force(evaluation, start, before.data(), trial, force.data());
  trial.t = 1;
  start.advance(evaluation, std::move(trial));
  motion::ExplicitMotion::Settings settings;
  settings.rate = 0;
  motion::ExplicitMotion motion(scene, quasi_static.boundary(), motion::particle_masses(deck, scene), std::move(start),
                                settings);
  const double dt = motion.stable_time_step();
  for (int k = 0; k < 200; ++k) motion.step(dt);
  EXPECT_EQ(motion.t(), 1);
  const motion::MotionEnergies e = motion.energies();
  double moved = 0;
  for (std::size_t u = 0; u < before.size(); ++u)
    moved = std::max(moved, std::abs(motion.trial().displacement[u] - before[u]));
  std::printf("held: moved by %.1e of 0.02, kinetic over stored %.1e, energy off by %.1e\n", moved, e.moving / e.stored,
              e.gain() / e.scale());
  EXPECT_LT(moved, 1e-12);                // measured 1e-15
  EXPECT_LT(e.moving, 1e-20 * e.stored);  // measured 9e-28
  EXPECT_NEAR(e.at_start, quasi_static.energies().stored, 1e-9 * e.at_start);
  EXPECT_NEAR(e.gain(), 0, 1e-12 * e.stored);
  const mechanics::Committed end = motion.release();
  EXPECT_EQ(end.displacement().size(), scene.local_unknowns());
}

TEST(ExplicitMotion, BondsThatBreakInFlightReleaseWhatTheyHeld) {
  const deck::Deck deck = deck_of(steel_box(4, 4, 12, R"yaml(
explicit: {contact: {}}
initial_velocity: [{set: all, velocity: {z: "3e3*(z-6)"}}]
boundary: []
steps: {end: 1, count: 1}
)yaml"));
  mechanics::Scene scene = mechanics::build_scene(deck, Communicator(MPI_COMM_SELF));
  const loads::Boundary boundary(deck, scene);
  motion::ExplicitMotion::Settings settings;
  settings.contact = deck.motion.contact;
  motion::ExplicitMotion motion(scene, boundary, motion::particle_masses(deck, scene), mechanics::Committed(scene),
                                settings);
  motion.set_velocity(deck.initial_velocity);
  const double dt = 0.5 * motion.stable_time_step();
  for (int k = 0; k < 16; ++k) motion.step(dt);
  const motion::MotionEnergies before = motion.energies();
  std::vector<mechanics::BondEnds> ends;
  bonds::BondGraph graph = scene.bond_graph();
  std::vector<LocalIndex> neighbors;
  for (LocalIndex i = 0; i < scene.owned(); ++i) {
    graph(i, neighbors);
    for (const LocalIndex j : neighbors)
      if (scene.body().position(i)[2] < 6 && scene.body().position(j)[2] > 6) ends.push_back({i, j});
  }
  scene.break_bonds(ends);
  const double released_before = motion.energies().released;
  motion.bonds_have_broken();
  const double released = motion.energies().released - released_before;
  const motion::MotionEnergies after = motion.energies();
  const double stored = before.stored - after.stored, kinetic = before.kinetic - after.kinetic;
  EXPECT_GT(stored, 0.1 * before.stored);
  EXPECT_GT(kinetic, 0);
  EXPECT_NEAR(released, stored + kinetic, 1e-12 * before.stored);
  EXPECT_NEAR(after.moving, before.moving, 1e-12 * before.moving);  // the velocities do not jump
  for (int k = 0; k < 300; ++k) motion.step(dt);
  const motion::MotionEnergies e = motion.energies();
  double upwards = 0;
  for (LocalIndex i = 0; i < scene.owned(); ++i)
    upwards += (scene.body().position(i)[2] > 6 ? 1 : -1) * motion.velocity()[static_cast<std::size_t>(i) * 3 + 2];
  std::printf(
      "broken in flight: %zu bonds held %.2f of the stored energy and %.3f of that of the jump, energy off by "
      "%.1e\n",
      ends.size(), stored / before.stored, kinetic / released, e.gain() / e.scale());
  EXPECT_GT(upwards, 0) << "the halves do not part";
  EXPECT_NEAR(e.released, released, 1e-15 * released);
  // All forces of a section jump at once, and dt^2/8 m a^2 with them: without it 6.8e-3.
  EXPECT_LT(std::abs(e.gain()), 1e-3 * e.scale());  // measured 4.3e-4: the faces that collide
}

TEST(ExplicitMotion, AMotionThatIsTakenUpAgainGoesOnAsIfItHadNotStopped) {
  const deck::Deck deck = deck_of(steel_box(4, 4, 12, R"yaml(
explicit: {damping: 1e4, contact: {}}
sets: {foot: {where: "z < 3"}, head: {where: "z > 9"}}
initial_velocity: [{set: all, velocity: {z: -2e4}}]
boundary: [{set: foot, velocity: {z: "1e9*t"}}, {set: head, force: {x: "1e8*t"}}]
steps: {end: 1, count: 1}
)yaml",
                                            "elastic-plastic"));
  const mechanics::Scene scene = mechanics::build_scene(deck, Communicator(MPI_COMM_SELF));
  const loads::Boundary boundary(deck, scene);
  motion::ExplicitMotion::Settings settings;
  settings.damping = deck.motion.damping;
  settings.contact = deck.motion.contact;
  const auto begin = [&] {
    return motion::ExplicitMotion(scene, boundary, motion::particle_masses(deck, scene), mechanics::Committed(scene),
                                  settings);
  };
  const double dt = 1.5e-7;
  motion::ExplicitMotion whole = begin(), first = begin(), second = begin();
  whole.set_velocity(deck.initial_velocity);
  first.set_velocity(deck.initial_velocity);
  for (int k = 0; k < 60; ++k) {
    whole.step(dt);
    if (k == 29) whole.gather_sums();
  }
  for (int k = 0; k < 30; ++k) first.step(dt);
  const CheckpointFolder folder{Communicator(MPI_COMM_SELF)};
  output::CheckpointWriter writer(folder.of_step(30), scene.body());
  writer.write({30, first.t()}, [&](StateWriter& to) { first.save(to); });
  output::CheckpointReader reader(folder.of_step(30), scene.body());
  second.restore(reader);
  EXPECT_EQ(second.energies().sum(), first.energies().sum());
  for (int k = 0; k < 30; ++k) second.step(dt);
  EXPECT_TRUE(whole.trial().displacement == second.trial().displacement);
  EXPECT_TRUE(whole.velocity() == second.velocity());
  const motion::MotionEnergies a = whole.energies(), b = second.energies();
  EXPECT_GT(a.dissipated, 0);
  EXPECT_EQ(a.sum(), b.sum());
  EXPECT_EQ(a.external_work, b.external_work);
  EXPECT_EQ(second.t(), whole.t());
  EXPECT_EQ(second.time_steps(), 60);
}

/// Above the stable time step kinetic and stored energy run to minus and plus infinity and their sum stays. A run of
/// fewer time steps than there are between two looks is looked at when it ends.
TEST(ExplicitMotion, AnUnstableRunOfFiveTimeStepsStops) {
  const std::string yaml = R"(
dimension: 3
body: [{name: b, shape: {box: {min: [0, 0, 0], max: [6, 4, 4]}}, spacing: 1, material: s}]
horizon: {ratio: 3.015}
materials: {s: {model: elastic, young_modulus: 210e3, poisson_ratio: 0.3, density: 7.85e-9}}
dynamics: explicit
explicit: {time_step: 1e-5}
initial_velocity: [{set: b, velocity: {x: "x < 3 ? 1e3 : -1e3"}}]
steps: {end: 5e-5, count: 1}
)";
  EXPECT_THAT(InMotion(deck_of(yaml)).run(), ::testing::HasSubstr("the energies grow though nothing does that work"));
  EXPECT_EQ(InMotion(deck_of(yaml, {"explicit.time_step=2e-7"})).run(), "");
}

}  // namespace
}  // namespace perinox::test
