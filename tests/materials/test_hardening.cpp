/// Compares isotropic hardening, linear and from a table, and kinematic hardening in 3-D with classical J2 plasticity.
/// Also tests the curve itself and the keys of the deck.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "perinox/core/error.hpp"
#include "support/isotropic_family.hpp"
#include "support/measured.hpp"

namespace perinox::test {
namespace {

/// Strains in yield strains: shear to and fro, tension to and fro, all components turning.
const std::vector<std::vector<Tensor>> paths{
    {{0, 0, 0, 0, 0, 0.4}, {0, 0, 0, 0, 0, 2}, {0, 0, 0, 0, 0, 4}, {0, 0, 0, 0, 0, -4}, {0, 0, 0, 0, 0, 1}},
    {{1.5, 0, 0, 0, 0, 0}, {4, 0, 0, 0, 0, 0}, {-2, 0, 0, 0, 0, 0}, {5, 0, 0, 0, 0, 0}},
    {{2, -1, 0, 1, 0, 0}, {2, -1, 1, 1, -2, 0}, {-1, 2, 0, -1, -2, 1}, {0, 0, 0, 0, 0, 0}, {1, 1, -4, 2, 2, 2}},
};

TEST(Hardening, IsClassicalUnderUniformStrain) {
  const IsotropicFamily ball(3, 3.015);
  for (const Hardening& hardening : hardenings())
    for (const auto& path : paths) {
      SCOPED_TRACE(hardening.name);
      const materials::ElasticPlastic material(hardening.parameters());
      MaterialPoint point(material, ball.family);
      LocalPlasticity solid = hardening.point();
      for (Tensor strain : path) {
        for (double& value : strain) value *= yield_strain;
        LocalPlasticity next;
        const Tensor expected = solid.stress(strain, &next);
        const Evaluation now = point.evaluate(ball.extension(strain));
        const Tensor found = ball.stress(now.force_state);
        for (int c = 0; c < 6; ++c)
          EXPECT_LE(measured("hardening: stress against J2", std::abs(found[c] - expected[c]) / yield_shear),
                    1e-12);  // 3.9e-14
        const double scale = std::max(1.0, next.gamma / yield_strain) * yield_strain;
        EXPECT_LE(measured("hardening: gamma_p against J2",
                           std::abs(std::sqrt(3.0) * now.point_history[1] - next.gamma) / scale),
                  1e-12);  // 1.0e-15
        EXPECT_LE(
            measured("hardening: stored energy against J2",
                     std::abs(now.response.stored_energy - next.stored_energy(strain)) / (yield_shear * yield_strain)),
            1e-12);  // 8.4e-14
        point.commit(now);
        solid = next;
      }
    }
}

/// In shear the elastic range of kinematic hardening keeps its width, 2 tau. With isotropic hardening it widens.
TEST(Hardening, ReverseYieldOfKinematicHardeningComesEarlier) {
  const IsotropicFamily ball(3, 3.015);
  for (const Hardening& hardening : hardenings()) {
    if (hardening.table) continue;
    const materials::ElasticPlastic material(hardening.parameters());
    MaterialPoint point(material, ball.family);
    const double there = 5 * yield_strain;
    const auto sheared = [&](double gamma) { return ball.extension({0, 0, 0, 0, 0, gamma / 2}); };
    point.commit(point.evaluate(sheared(there)));
    const double flowed = std::sqrt(3.0) * point.committed_point()[1];
    const double range = 2 * (yield_shear + hardening.isotropic * flowed) / shear;
    EXPECT_FALSE(point.evaluate(sheared(there - range * (1 - 1e-9))).response.yielding) << hardening.name;
    EXPECT_TRUE(point.evaluate(sheared(there - range * (1 + 1e-9))).response.yielding) << hardening.name;
  }
}

TEST(HardeningCurve, FlowEndsOnTheCurveAndItsWorkIsTheAreaBelow) {
  const materials::HardeningCurve curve = Hardening::curve();
  const auto rows = Hardening::rows();
  const LocalPlasticity point = Hardening{"", 0, 0, true}.point();
  const double end = rows.back()[0];
  for (const double from : {0.0, 0.3 * end, rows[1][0], 1.2 * end})
    for (const double step : {1e-3 * end, 0.4 * end, 1.5 * end}) {
      // The driving stress falls with 0.7 mu and meets the curve after `step`.
      const double driving = point.yield_stress(from + step) + 0.7 * shear * step;
      const auto flow =
          curve.flow(from, [&](double stress, double slope) { return (driving - stress) / (slope + 0.7 * shear); });
      EXPECT_LE(measured("hardening curve: flow", std::abs(flow.strain / step - 1)), 1e-12);  // 3.5e-14
      EXPECT_LE(measured("hardening curve: stress", std::abs(flow.stress / point.yield_stress(from + step) - 1)),
                1e-13);  // 2.2e-16
      double area = 0;   // midpoints of pieces that end at every row: exact
      for (std::size_t k = 0; k < rows.size(); ++k) {
        const double low = std::max(from, rows[k][0]);
        const double high = k + 1 < rows.size() ? std::min(from + step, rows[k + 1][0]) : from + step;
        if (high > low) area += (high - low) * point.yield_stress((low + high) / 2);
      }
      EXPECT_LE(measured("hardening curve: work", std::abs(flow.work / area - 1)), 1e-12);  // 4.1e-14
    }
}

TEST(HardeningCurve, WhatIsNotANumberStaysSo) {
  const double nothing = std::numeric_limits<double>::quiet_NaN();
  for (const materials::HardeningCurve& curve :
       {Hardening::curve(), materials::HardeningCurve(2.0, 0.0), materials::HardeningCurve(2.0, 0.5)}) {
    EXPECT_TRUE(std::isnan(curve.flow(0.1, [&](double, double) { return nothing; }).strain));
    EXPECT_TRUE(std::isnan(curve.flow(nothing, [&](double stress, double) { return nothing * stress; }).strain));
  }
}

/// A file that is gone when the test ends.
struct Table {
  explicit Table(const std::string& text)
      : path(std::filesystem::temp_directory_path() / ("perinox_table_" + std::to_string(::getpid()) + ".csv")) {
    std::ofstream(path) << text;
  }
  ~Table() { std::filesystem::remove(path); }
  std::filesystem::path path;
};

TEST(HardeningTable, OfATensionTestIsThatInShear) {
  const Table file("plastic_strain,yield_stress\n0,200\n0.01,260\n0.05,300\n");
  const double root3 = std::sqrt(3.0);
  const auto tension = materials::read_hardening_table(file.path.string(), {}, true);
  EXPECT_NEAR(tension.stress(0), 200 / root3, 1e-12);
  EXPECT_NEAR(tension.stress(0.03 * root3), 280 / root3, 1e-12);
  EXPECT_NEAR(tension.stress(0.2), 300 / root3, 1e-12);
  const auto shear_test = materials::read_hardening_table(file.path.string(), {}, false);
  EXPECT_NEAR(shear_test.stress(0.005), 230, 1e-12);
}

TEST(HardeningTable, RefusesWhatIsNoCurve) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"plastic_strain,yield_stress\n", "but no rows"},
      {"plastic_strain,yield_stress\n0.1,200\n",
       "2:1: a hardening table begins at plastic strain 0, but this one at 0.1"},
      {"plastic_strain,yield_stress\n0,200\n0.1,210\n0.1,220\n", "4:1: plastic_strain is 0.1 after 0.1"},
      {"plastic_strain,yield_stress\n0,200\n0.1,0\n", "3:5: yield_stress is 0 but must be greater than 0"},
      {"strain,yield_stress\n0,200\n", "strain"},
  };
  for (const auto& [text, sentence] : cases) {
    const Table file(text);
    try {
      materials::read_hardening_table(file.path.string(), {"deck.yaml", 3, 4}, true);
      ADD_FAILURE() << "was read: " << text;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(sentence), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace perinox::test
