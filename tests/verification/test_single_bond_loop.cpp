/// inputs/single_bond.yaml: Mitchell 2011, section 8, his Figure 5, against the closed form of one bond.
#include <gtest/gtest.h>

#include <cmath>

#include "support/runs.hpp"

namespace perinox::test {
namespace {

// 6061-T6 of Mitchell's Table 1; one bond of length 1 between two points of volume 1, omega = 1, so m = 1 at each.
const double mu = 25.9e3;
const double alpha = 15 * mu;                                     // 15 mu/m
const double tau = 203.1 / std::sqrt(3.0);                        // (56)
const double beta = std::sqrt(75 / (4 * std::acos(-1.0))) * tau;  // sqrt(2 psi0) of (51), horizon 1

struct Point {
  double extension;
  double force;  ///< along the bond, tension positive; both points' force states pull
};

std::vector<Point> run_loop() {
  const deck::Deck deck = deck::read(PERINOX_SOURCE_DIR "/inputs/single_bond.yaml", materials::full_schema());
  const RunResult run = run_deck(deck);
  EXPECT_EQ(run.stopped, "");
  std::vector<Point> loop{{0, 0}};
  const double side = std::sqrt(0.5);
  for (const StepRecord& step : run.records.steps) {
    const double x = side + step.history[0], length = std::hypot(x, side);
    loop.push_back({length - 1, (step.history[1] * x + step.history[2] * side) / length});
  }
  return loop;
}

TEST(SingleBondLoop, YieldUnloadReverseYieldReload) {
  const std::vector<Point> loop = run_loop();
  ASSERT_EQ(loop.size(), 101u);

  // First yield: extension beta/alpha, a shear of twice that; the paper's figure shows "approximately 1.5e-3".
  const double yield = beta / alpha;
  EXPECT_NEAR(2 * yield, 1.475e-3, 1e-6);
  // Corner points of the loop: turns at t = 1 and t = 3 (steps 20 and 60).
  const double top = loop[20].extension, bottom = loop[60].extension;
  int elastic_up = 0, flat_up = 0, elastic_down = 0, flat_down = 0, elastic_again = 0, flat_again = 0;
  for (std::size_t k = 1; k <= 100; ++k) {
    const double e = loop[k].extension;
    double expected = 0;
    if (k <= 20) {
      (e < yield ? elastic_up : flat_up)++;
      expected = std::min(2 * alpha * e, 2 * beta);
    } else if (k <= 60) {
      // unloads parallel to loading, yields in reverse after 2 yield extensions
      (e > top - 2 * yield ? elastic_down : flat_down)++;
      expected = std::max(2 * beta - 2 * alpha * (top - e), -2 * beta);
    } else {
      (e < bottom + 2 * yield ? elastic_again : flat_again)++;
      expected = std::min(-2 * beta + 2 * alpha * (e - bottom), 2 * beta);
    }
    // Measured: 2e-13 of the yield force (rounding of the extension, 1e-16 of the length, times alpha/beta = 1356).
    EXPECT_NEAR(loop[k].force, expected, 1e-11 * beta) << "step " << k;
  }
  // Every branch of the loop has been walked.
  EXPECT_GE(elastic_up, 5);
  EXPECT_GE(flat_up, 5);
  EXPECT_GE(elastic_down, 10);
  EXPECT_GE(flat_down, 10);
  EXPECT_GE(elastic_again, 10);
  EXPECT_GE(flat_again, 10);
}

}  // namespace
}  // namespace perinox::test
