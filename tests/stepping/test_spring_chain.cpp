/// A medium that is no peridynamic one goes through the same Newton iteration, load stepper, checkpoint and output.
#include <gmock/gmock.h>

#include "perinox/output/checkpoint.hpp"
#include "perinox/output/results_reader.hpp"
#include "perinox/output/run_writer.hpp"
#include "support/measured.hpp"
#include "support/restarts.hpp"
#include "support/spring_chain.hpp"

namespace perinox::test {
namespace {

constexpr int particles = 11;
constexpr double peak = 20;

/// Pulled to twice the yield force and let go again. The materials are not used.
deck::Deck chain_deck(const std::vector<std::string>& overrides = {}) {
  return deck_of(fmt::format(R"yaml(
dimension: plane-stress
body: [{{name: row, shape: {{box: {{min: [0, 0], max: [{}, 1]}}}}, spacing: 1, material: none}}]
horizon: {{ratio: 1.5}}
deformation: small
materials: {{none: {{model: elastic, young_modulus: 1, poisson_ratio: 0.3}}}}
sets: {{foot: {{where: "x < 1"}}, head: {{where: "x > {}"}}}}
boundary:
  - {{set: foot, displacement: {{x: 0, y: 0}}}}
  - {{set: head, force: {{x: "t < 1 ? {}*t : {}*(2 - t)"}}}}
steps: {{end: 2, count: 10}}
history:
  - {{name: reaction, reaction: foot, component: x}}
  - {{name: end, displacement: head, component: x}}
  - {{name: flowed, yielded: row}}
output: {{fields: [equivalent_plastic_strain, stored_energy]}}
)yaml",
                             particles, particles - 1, peak, peak),
                 overrides);
}

SpringChain chain_of(const deck::Deck& deck) {
  return SpringChain(body::build(deck, Communicator(MPI_COMM_SELF), 1.5), SpringLaw());
}

RunResult run_chain(const deck::Deck& deck, const std::string& restart = "", const CheckpointFolder* folder = nullptr) {
  SpringChain chain = chain_of(deck);
  stepping::LoadStepper stepper(deck, chain);
  RunResult run;
  if (!restart.empty()) {
    output::CheckpointReader reader(restart, chain.model().body());
    stepper.restore(reader);
  }
  if (folder)
    stepper.on_commit([&](const StepRecord& record) {
      output::CheckpointWriter writer(folder->of_step(record.step), chain.model().body());
      writer.write({record.step, record.t}, [&](StateWriter& to) { stepper.save(to); });
    });
  run = run_with(stepper);
  run.energies = stepper.energies();
  run.preconditioner = stepper.newton().system().preconditioner_name();
  for (LocalIndex i = 0; i < particles; ++i) run.displacement[i] = {chain.displacement()[2 * i]};
  return run;
}

double elongation(double force) {  // of the first loading
  const SpringLaw law;
  return (particles - 1) * (force / law.stiffness + std::max(0.0, force - law.yield) / law.hardening);
}

/// Prints and returns how far off a value is, over a scale.
double off(const std::string& what, double value, double exact, double scale) {
  return measured("spring chain: " + what, std::abs(value - exact) / scale);
}

TEST(SpringChain, FollowsItsLawThroughLoadingAndUnloading) {
  const RunResult run = run_chain(chain_deck());
  ASSERT_EQ(run.stopped, "");
  EXPECT_EQ(run.preconditioner, "block-jacobi");
  ASSERT_EQ(run.records.steps.size(), 10u);
  for (int k = 0; k < 5; ++k) {
    const StepRecord& row = run.records.steps[static_cast<std::size_t>(k)];
    const double force = peak * (k + 1) / 5;
    EXPECT_LE(off("reaction", row.history[0], -force, peak), 1e-13) << k;                           // 5.3e-16
    EXPECT_LE(off("elongation", row.history[1], elongation(force), elongation(peak)), 1e-13) << k;  // 5.6e-16
    EXPECT_EQ(row.history[2] > 0, k >= 2) << k;
    EXPECT_LE(row.newton_iterations, 3) << k;
  }
  const double left = elongation(peak) - (particles - 1) * peak / SpringLaw().stiffness;
  EXPECT_LE(off("what is left", run.records.steps.back().history[1], left, left), 1e-13);  // 0
  for (LocalIndex i = 0; i < particles; ++i)
    EXPECT_LE(off("displacement left", run.displacement.at(i)[0], left * i / (particles - 1), left), 1e-13)
        << i;  // 4.2e-16
}

TEST(SpringChain, WorkIsStoredOrDissipated) {
  const RunResult run = run_chain(chain_deck());
  const SpringLaw law;
  const double slip = (peak - law.yield) / law.hardening;
  const double dissipated = (particles - 1) * slip * (law.yield + 0.5 * law.hardening * slip);
  EXPECT_LE(off("dissipated", run.energies.dissipated, dissipated, dissipated), 1e-13);           // 8.9e-16
  EXPECT_LE(off("stored", run.energies.stored, 0, dissipated), 1e-13);                            // 5.6e-30
  EXPECT_LE(measured("spring chain: unaccounted", std::abs(run.energies.unaccounted())), 1e-13);  // 2.2e-16
}

TEST(SpringChain, GoesOnFromACheckpointToTheLastBit) {
  const CheckpointFolder folder{Communicator(MPI_COMM_SELF)};
  const RunResult whole = run_chain(chain_deck(), "", &folder);
  for (const int step : {1, 3, 6}) {
    const RunResult rest = run_chain(chain_deck(), folder.of_step(step));
    EXPECT_EQ(rest.displacement, whole.displacement) << step;
    ASSERT_EQ(rest.records.steps.size(), whole.records.steps.size() - static_cast<std::size_t>(step));
    for (std::size_t k = 0; k < rest.records.steps.size(); ++k)
      EXPECT_EQ(numbers_of(rest.records.steps[k]), numbers_of(whole.records.steps[k + static_cast<std::size_t>(step)]))
          << step << " " << k;
  }
}

TEST(SpringChain, IsWrittenLikeEveryOtherRun) {
  const CheckpointFolder folder{Communicator(MPI_COMM_SELF)};
  const deck::Deck deck = chain_deck();
  SpringChain chain = chain_of(deck);
  {
    stepping::LoadStepper stepper(deck, chain);
    output::RunWriter writer(deck, chain.model().body(), folder.path() + "/out", true);
    stepper.run(writer);
  }
  const output::ResultsReader results(folder.path() + "/out/results.h5");
  ASSERT_EQ(results.particles(), static_cast<std::size_t>(particles));
  const std::vector<double> slip = results.field(10, "equivalent_plastic_strain"),
                            u = results.field(10, "displacement");
  for (std::size_t s = 0; s + 1 < static_cast<std::size_t>(particles); ++s) {
    EXPECT_LE(off("slip written", slip[s], 0.04, 0.04), 1e-13);                          // 1.4e-15
    EXPECT_LE(off("displacement written", u[3 * s + 3] - u[3 * s], 0.04, 0.04), 1e-13);  // 4.3e-15
  }
}

TEST(SpringChain, SolvesThatItCannotServeAreRefused) {
  EXPECT_THROW(run_chain(chain_deck({"solver.tangent=assembled"})), std::logic_error);
  EXPECT_THROW(run_chain(chain_deck({"solver.linear.preconditioner=two-level"})), std::logic_error);
  SpringChain chain = chain_of(chain_deck());
  std::vector<double> x(2 * particles, 0.0), y = x;
  EXPECT_THROW(chain.make_tangent(deck::TangentForm::consistent)->apply_transposed(x.data(), y.data()),
               std::logic_error);
}

TEST(SpringChain, GoesAlongAnArcToo) {
  const RunResult run =
      run_chain(chain_deck({"steps.control=arc-length", "steps.end=0.9", "steps.count=4", "arc_length.max_steps=40"}));
  ASSERT_EQ(run.stopped, "");
  const StepRecord& last = run.records.steps.back();
  EXPECT_LE(off("t along the arc", last.t, 0.9, 1), 1e-13);  // 0
  EXPECT_LE(off("elongation along the arc", last.history[1], elongation(0.9 * peak), elongation(peak)),
            1e-13);  // 2.2e-15
}

}  // namespace
}  // namespace perinox::test
