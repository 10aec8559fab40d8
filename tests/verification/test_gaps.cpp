/// Plates with a saw cut against the same plates with a crack; bodies that do not touch.
#include <gtest/gtest.h>

#include "support/measured.hpp"
#include "support/runs.hpp"

namespace perinox::test {
namespace {

/// Force on the upper edge of a plate 40 x 40 in plane stress, pulled by 0.1 at both ends, cut from the left to its
/// middle: by `cut`, part of the body's or the deck's text.
double pull(const std::string& shape, const std::string& extra, double h = 1) {
  const RunResult run = run_deck(deck_of(fmt::format(R"(
dimension: plane-stress
deformation: small
body: [{{name: plate, shape: {0}, spacing: {2}, material: m}}]
horizon: {{ratio: 3.015}}
materials: {{m: {{model: elastic, young_modulus: 1000, poisson_ratio: 0.3}}}}
sets: {{lo: {{where: "y<3"}}, hi: {{where: "y>37"}}}}
boundary: [{{set: lo, displacement: {{y: 0}}}}, {{set: lo, displacement: {{x: 0}}}}, {{set: hi, displacement: {{x: 0, y: 0.1}}}}]
steps: {{end: 1, count: 1}}
history: [{{name: F, reaction: hi, component: y}}]
{1})",
                                                     shape, extra, h)));
  EXPECT_EQ(run.stopped, "");
  return run.records.steps.back().history.front();
}

const char* whole = "{box: {min: [0, 0], max: [40, 40]}}";
std::string slit(double width) {
  return fmt::format("{{difference: [{}, {{box: {{min: [-1, {}], max: [20, {}]}}}}]}}", whole, 20 - width / 2,
                     20 + width / 2);
}
const char* crack = "cracks: [{segment: {start: [-1, 20], end: [20, 20]}}]";

TEST(Gaps, ASawCutWeakensAPlateAsACrackDoes) {
  const double cracked = pull(whole, crack), uncut = pull(whole, "");
  for (const double width : {0.5, 1.0, 2.0}) {
    const double cut = pull(slit(width), ""), bridged = pull(slit(width), "bonds: {across_gaps: keep}");
    std::printf("cut %.1f wide: %.5f of the cracked plate, bridged %.5f, no cut %.5f\n", width, cut / cracked,
                bridged / cracked, uncut / cracked);
    EXPECT_NEAR(cut / cracked, 1, 0.02);
  }
}

TEST(Gaps, BodiesApartCarryNothing) {
  const std::string two = R"(
dimension: 3
body:
  - {name: a, shape: {box: {min: [0,0,0], max: [5,5,8]}}, spacing: 1, material: m}
  - {name: b, shape: {box: {min: [0,0,10], max: [5,5,18]}}, spacing: 1, material: m}
horizon: {ratio: 3.015}
materials: {m: {model: elastic, young_modulus: 1000, poisson_ratio: 0.3}}
sets: {lo: {where: "z<3"}, hi: {where: "z>15"}}
boundary: [{set: lo, displacement: {x: 0, y: 0, z: 0}}, {set: hi, displacement: {x: 0, y: 0, z: "0.1*t"}}]
steps: {end: 1, count: 1}
history: [{name: F, reaction: lo, component: z}, {name: T, reaction: hi, component: z}]
)";
  const RunResult apart = run_deck(deck_of(two));
  const RunResult bridged = run_deck(deck_of(two, {"bonds.across_gaps=keep"}));
  ASSERT_EQ(apart.stopped, "");
  EXPECT_LE(std::abs(apart.records.steps.back().history[0]),
            1e-9 * std::abs(bridged.records.steps.back().history[0]));  // 0
  std::printf("reaction apart %.3e, bridged %.3e\n", apart.records.steps.back().history[0],
              bridged.records.steps.back().history[0]);
}

}  // namespace
}  // namespace perinox::test
