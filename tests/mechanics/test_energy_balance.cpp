/// The energies of a plastic load path: what a step dissipates is the yield stress over its flow, and the work of
/// moving the body is what is stored plus what is dissipated, up to the size of the steps.
#include <gtest/gtest.h>

#include "mechanics/path_work.hpp"
#include "support/load_states.hpp"
#include "support/measured.hpp"

namespace perinox::test {
namespace {

MaterialRow row_named(const std::string& name) {
  for (const MaterialRow& row : material_table())
    if (row.name == name) return row;
  throw std::runtime_error("there is no material row " + name);
}

TEST(EnergyBalance, DissipationIsTheMultiplierTimesTheYieldValueSquared) {
  const mechanics::Scene scene =
      small_scene(row_named("plastic_perfect"), deck::Influence::inverse, deck::Quadrature::partial_volume);
  const mechanics::Committed committed = committed_after(scene, {field_of(scene, {2.0})});
  const mechanics::Trial trial = internal_force(scene, committed, field_of(scene, {-1.0})).trial;
  double expected = 0;
  for (LocalIndex i = 0; i < scene.owned(); ++i) {
    const double multiplier = trial.point_history[2 * i] - committed.point_history()[2 * i];
    EXPECT_GE(multiplier, 0);
    // beta^2 = 2 psi0 = d(d+2) tau^2/m, d = 3.
    expected += scene.body().volume[i] * multiplier * 15 * yield_shear * yield_shear / scene.bonds().weighted_volume[i];
  }
  ASSERT_GT(expected, 0);
  EXPECT_LE(measured("energy: dissipation against multipliers", std::abs(trial.dissipated / expected - 1)),
            1e-13);  // 1.1e-16
}

struct Ledger {
  double work = 0, beyond_chord = 0, stored = 0, dissipated = 0;
  double gap() const { return std::abs(work - stored - dissipated) / (stored + dissipated); }
  double gap_of_path() const { return std::abs(work + beyond_chord - stored - dissipated) / (stored + dissipated); }
};

/// Out to twelve yield strains and back to -4, each in `steps` equal steps; work by the trapezoidal rule, and what
/// mechanics::PathWork adds to it.
Ledger ledger_of(const mechanics::Scene& scene, int steps) {
  Ledger ledger;
  mechanics::Evaluation evaluation(scene);
  mechanics::Committed committed(scene);
  Vector previous(scene.owned_unknowns(), 0.0), previous_force(scene.owned_unknowns(), 0.0);
  for (const auto& [from, to] : {std::pair{0.0, 12.0}, std::pair{12.0, -4.0}})
    for (int s = 1; s <= steps; ++s) {
      const Vector here = field_of(scene, {from + (to - from) * s / steps});
      Answer answer = internal_force(scene, committed, here);
      for (std::size_t u = 0; u < here.size(); ++u)
        ledger.work -= 0.5 * (answer.force[u] + previous_force[u]) * (here[u] - previous[u]);
      ledger.dissipated += answer.trial.dissipated;
      ledger.stored = answer.trial.stored;
      const mechanics::PathWork path(evaluation, committed, answer.trial);
      commit(scene, committed, std::move(answer.trial));
      ledger.beyond_chord += path.beyond_chord(evaluation, committed);
      previous = here;
      previous_force = answer.force;
    }
  return ledger;
}

TEST(EnergyBalance, WorkIsStoredOrDissipated) {
  for (const char* name : {"plastic_perfect", "plastic_hardening", "plastic_continuum_hardening",
                           "plane_strain_hardening", "plane_stress_perfect", "plastic_combined", "plastic_table",
                           "plane_strain_combined", "plane_stress_table_kinematic"}) {
    SCOPED_TRACE(name);
    const mechanics::Scene scene = small_scene(row_named(name), deck::Influence::constant, deck::Quadrature::whole);
    const Ledger coarse = ledger_of(scene, 40), fine = ledger_of(scene, 160);
    EXPECT_GT(fine.dissipated, 2 * fine.stored);
    EXPECT_LE(measured(std::string("energy: gap in 2 x 160 steps, ") + name, fine.gap()), 2.5e-4);  // 1.3e-4
    EXPECT_LE(measured("energy: gap in 2 x 160 steps over that in 2 x 40", fine.gap() / coarse.gap()), 0.15);
    for (const bool small : {true, false}) {
      const Ledger single =
          ledger_of(small_scene(row_named(name), deck::Influence::constant, deck::Quadrature::whole, small), 1);
      EXPECT_GE(measured("energy: gap in 2 steps", single.gap()), 0.1);
      EXPECT_LE(measured("energy: gap in 2 steps, with the path", single.gap_of_path()), 1e-12);
    }
  }
}

}  // namespace
}  // namespace perinox::test
