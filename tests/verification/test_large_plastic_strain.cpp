/// Perfect plasticity at large strain: what the law makes of a bar and of a block in shear up to 50 %, and up to which
/// stretch it keeps to its yield stress. The table of docs/accuracy.md is what this prints.
#include <gtest/gtest.h>

#include <cmath>

#include "perinox/stepping/plastic_stretch.hpp"
#include "support/runs.hpp"

namespace perinox::test {
namespace {

constexpr int width = 10;  ///< particles
constexpr int steps = 100;
constexpr double end = 0.5;

/// A cube strained alike everywhere. along: with free sides, along z; else simple shear of its planes z = constant.
std::string cube(const std::string& quadrature, bool along, double sign) {
  const std::string motion = along ? fmt::format("  - {{set: all, displacement: {{z: \"{}*t*z\"}}}}\n", sign) +
                                         "  - {set: origin, displacement: {x: 0, y: 0}}\n"
                                         "  - {set: beside, displacement: {y: 0}}\n"
                                   : "  - {set: all, displacement: {x: \"t*z\", y: 0, z: 0}}\n";
  return fmt::format(R"(
dimension: 3
body: [{{name: cube, shape: {{box: {{min: [0, 0, 0], max: [{0}, {0}, {0}]}}}}, spacing: 1, material: m}}]
horizon: {{ratio: 3.015}}
quadrature: {1}
materials: {{m: {{model: elastic-plastic, young_modulus: 200e3, poisson_ratio: 0.3, yield_stress: {{tension: 350}}}}}}
sets:
  origin: {{where: "x < 1 && y < 1 && z < 1"}}
  beside: {{where: "x > {2} && y < 1 && z < 1"}}
  upper: {{where: "z > {3}"}}
  left: {{where: "x < 1"}}
  right: {{where: "x > {2}"}}
  front: {{where: "y < 1"}}
  back: {{where: "y > {2}"}}
boundary:
{4}steps: {{end: {5}, count: {6}}}
history:
  - {{name: along, reaction: upper, component: {7}}}
  - {{name: normal, reaction: upper, component: z}}
  - {{name: left, displacement: left, component: x}}
  - {{name: right, displacement: right, component: x}}
  - {{name: front, displacement: front, component: y}}
  - {{name: back, displacement: back, component: y}}
)",
                     width, quadrature, width - 1, width / 2, motion, end, steps, along ? "z" : "x");
}

struct Row {
  double strain = 0;
  double nominal = 0, stress = 0;  ///< of the undeformed and of the deformed section
  double volume = 1;               ///< over that of the undeformed cube
  double normal = 0;               ///< on the planes that slide
};

std::vector<Row> strained(const std::string& quadrature, bool along, double sign = 1) {
  const RunResult run = run_deck(deck_of(cube(quadrature, along, sign)));
  EXPECT_EQ(run.stopped, "");
  std::vector<Row> rows;
  for (const StepRecord& step : run.records.steps) {
    Row row;
    row.strain = sign * step.t;
    row.nominal = step.history[0] / (width * width);
    const double x = 1 + (step.history[3] - step.history[2]) / (width - 1);
    const double y = 1 + (step.history[5] - step.history[4]) / (width - 1);
    row.stress = along ? row.nominal / (x * y) : row.nominal;
    row.volume = along ? x * y * (1 + row.strain) : 1;
    row.normal = step.history[1] / (width * width);
    rows.push_back(row);
  }
  return rows;
}

/// Of a row, the stress over what it was just after the yield, less 1; the yield stress itself is as the quadrature has
/// it. Straight back to no strain, so that what the law makes of it up to there counts too.
double excess(const std::vector<Row>& rows, const Row& at) {
  const Row &first = rows[1], &second = rows[2];  // at 1 and 1.5 %
  const double yield = first.stress - (second.stress - first.stress) / (second.strain - first.strain) * first.strain;
  return at.stress / yield - 1;
}

const Row& row_at(const std::vector<Row>& rows, double strain) {
  return rows[static_cast<std::size_t>(std::lround(std::abs(strain) / end * steps)) - 1];
}

void print(const char* quadrature, const char* how, const std::vector<Row>& rows) {
  for (const double strain : {0.01, 0.02, 0.025, 0.03, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5}) {
    const Row& row = row_at(rows, strain);
    std::printf("| `%s` | %s | %g %% | %.1f | %.1f | %+.1f %% | %.4f | %.0f |\n", quadrature, how, 100 * strain,
                row.nominal, row.stress, 100 * excess(rows, row), row.volume, row.normal);
  }
}

class LargePlasticStrain : public ::testing::TestWithParam<const char*> {
 protected:
  bool exact() const { return std::string(GetParam()) == "position-aware"; }
};

TEST_P(LargePlasticStrain, Tension) {
  const std::vector<Row> rows = strained(GetParam(), true);
  print(GetParam(), "tension", rows);
  EXPECT_NEAR(row_at(rows, 0.05).nominal, exact() ? 349.2 : 381.8, 0.5);
  EXPECT_NEAR(row_at(rows, 0.05).volume, 0.998, 0.001);
  if (!exact()) return;  // its surfaces yield later than its inside, so that the limit is not a matter of the law alone
  EXPECT_LT(excess(rows, row_at(rows, stepping::most_plastic_stretch)), 0.05);      // measured 0.031
  EXPECT_GT(excess(rows, row_at(rows, 2 * stepping::most_plastic_stretch)), 0.05);  // measured 0.074
  EXPECT_NEAR(row_at(rows, 0.3).stress, 553, 5);
  EXPECT_NEAR(row_at(rows, 0.3).volume, 0.899, 0.005);
}

TEST_P(LargePlasticStrain, Compression) {
  const std::vector<Row> rows = strained(GetParam(), true, -1);
  print(GetParam(), "compression", rows);
  EXPECT_NEAR(row_at(rows, 0.05).volume, 0.997, 0.002);
  if (!exact()) return;
  EXPECT_GT(excess(rows, row_at(rows, stepping::most_plastic_stretch)), -0.05);  // -4.2%
}

TEST_P(LargePlasticStrain, SimpleShear) {
  const std::vector<Row> rows = strained(GetParam(), false);
  print(GetParam(), "shear", rows);
  // Bonds at 45 degrees are stretched by half of the shear.
  EXPECT_LT(excess(rows, row_at(rows, 2 * stepping::most_plastic_stretch)), 0.05);  // measured 0.035, whole 0.038
  EXPECT_GT(excess(rows, row_at(rows, 0.06)), 0.05);                                // measured 0.060, whole 0.065
  EXPECT_NEAR(row_at(rows, 0.1).normal, exact() ? 689 : 794, 5);
}

INSTANTIATE_TEST_SUITE_P(Quadratures, LargePlasticStrain, ::testing::Values("position-aware", "whole"),
                         [](const auto& quadrature) { return quadrature.index == 0 ? "PositionAware" : "Whole"; });

}  // namespace
}  // namespace perinox::test
