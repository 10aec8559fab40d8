/// What a crack takes, and the load at which it runs, against linear elastic fracture mechanics: the shipped decks in
/// other spacings.
#include <gtest/gtest.h>

#include <cmath>

#include "support/fracture.hpp"
#include "support/verification.hpp"

namespace perinox::test {
namespace {

constexpr double energy_release_rate = 0.05;  // of both decks, N/mm

std::string spacing_of(double h) { return fmt::format("body.0.spacing={}", h); }

/// The foremost particle beside a crack along x, which has lost 0.35 of its family or more, after each step.
class TipRecorder : public FractureRecorder {
 public:
  explicit TipRecorder(const mechanics::Scene& scene) : scene_(scene) {}
  void step_committed(const StepRecord& record) override {
    double tip = 0;
    for (const Field& field : record.fields)
      for (LocalIndex i = 0; field.name == "damage" && i < scene_.owned(); ++i)
        if (field.values[i] > 0.35) tip = std::max(tip, scene_.body().position(i)[0]);
    tips.push_back(tip);
    FractureRecorder::step_committed(record);
  }
  std::vector<double> tips;

 private:
  const mechanics::Scene& scene_;
};

/// Energy released and lost an area while the crack grows, over G_c, less one.
double cantilever_error(test::Verification& table, int particles_a_mm) {
  const deck::Deck deck = input_deck("double_cantilever", {spacing_of(1.0 / particles_a_mm)});
  mechanics::Scene scene = mechanics::build_scene(deck, Communicator(MPI_COMM_SELF));
  stepping::LoadStepper stepper(deck, scene);
  TipRecorder records(scene);
  stepper.run(records);
  // From where the crack has a tip of its own, a horizon past the cut, to the end.
  const double horizon = scene.families().horizon;
  std::size_t first = 0;
  while (first < records.tips.size() && records.tips[first] < records.tips[0] + horizon) ++first;
  if (first >= records.tips.size()) throw std::runtime_error("the crack does not grow");
  const auto taken = [&](std::size_t k) {
    return records.steps[k].fracture->released_energy + records.steps[k].fracture->relaxed_energy;
  };
  const double growth = records.tips.back() - records.tips[first];
  EXPECT_GT(growth, 10);
  return table.row("position-aware", fmt::format("{} particles a mm", particles_a_mm),
                   static_cast<std::size_t>(scene.owned()),
                   (taken(records.tips.size() - 1) - taken(first)) / (growth * energy_release_rate) - 1);
}

TEST(Fracture, ACrackTakesItsEnergyReleaseRate) {
  test::Verification table("fracture", "energy a crack takes an area, double cantilever", "G_c");
  for (const int particles_a_mm : test::resolutions({1}, {2, 4}))
    EXPECT_LE(std::abs(cantilever_error(table, particles_a_mm)), 0.05) << particles_a_mm;  // -0.5, -2.4, +0.4 %
}

/// The stress at which the edge crack of 12 mm in 40 mm runs, over that of linear elastic fracture mechanics (Tada,
/// Paris, Irwin 1973: K = sigma sqrt(pi a) F(a/W)), less one.
double edge_crack_error(test::Verification& table, double h) {
  const double a = 12, share = a / 40, young = 1000;
  const double factor =
      1.12 - 0.231 * share + 10.55 * share * share - 21.72 * std::pow(share, 3) + 30.39 * std::pow(share, 4);
  const double exact = std::sqrt(young * energy_release_rate / (M_PI * a)) / factor;
  EXPECT_NEAR(exact, 0.694, 1e-3);
  // Held at the two particles at the end of the ligament, so that the support shrinks with h.
  const std::string end = fmt::format("where=x > {} && abs(y) < {}", 40 - h, h);
  const FractureRun run(input_deck(
      "edge_crack", {spacing_of(h), "sets.ligament." + end, "sets.end." + end, "steps.count=380", "fallback=none"}));
  EXPECT_NE(run.stopped, "");  // it runs
  const double stress = run.records.steps.back().t + 0.76 / 380;
  return table.row("position-aware", fmt::format("h = {} mm", h), static_cast<std::size_t>(run.scene.owned()),
                   stress / exact - 1);
}

TEST(Fracture, AnEdgeCrackRunsAtTheLoadOfFractureMechanics) {
  test::Verification table("fracture", "load at which an edge crack runs", "Tada, Paris, Irwin 1973");
  EXPECT_LE(std::abs(edge_crack_error(table, 2)), 0.15);  // 6 spacings long
  EXPECT_LE(std::abs(edge_crack_error(table, 1)), 0.05);
  if (!test::full_verification()) return;
  EXPECT_LE(std::abs(edge_crack_error(table, 0.5)), 0.1);
  EXPECT_LE(std::abs(edge_crack_error(table, 0.25)), 0.1);
}

}  // namespace
}  // namespace perinox::test
