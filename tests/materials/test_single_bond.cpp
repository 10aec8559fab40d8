/// Mitchell's section 8: two points with V = 1 and one bond of length 1 at 45 degrees to the shear, with horizon 1 and
/// the dilatation taken as zero. Everything about it is known in closed form.
#include <gtest/gtest.h>

#include <cmath>

#include "materials/elastic_plastic.hpp"
#include "support/families.hpp"
#include "support/measured.hpp"

namespace perinox::test {
namespace {

const double pi = std::acos(-1.0);
// Constants of section 8 (MPa): bulk and shear modulus, yield stress in tension; tau_y follows by Eq. 56.
constexpr double bulk = 67.5e3;
constexpr double shear = 25.9e3;
const double tau = 203.1 / std::sqrt(3.0);

class SingleBond : public ::testing::Test {
 protected:
  SingleBond() {
    family_.length = family_.influence = family_.weight = {1.0};
    family_.weighted_volume = 1;                     // omega xi^2 V
    family_.continuum_weighted_volume = 4 * pi / 5;  // 4 pi delta^5/5
  }
  /// Extension under small strain: e = xi gamma cos(45) sin(45) (Eq. 48).
  static Vector extension(double gamma) { return {0.5 * gamma}; }

  RandomFamily family_;
  materials::ElasticPlastic material_{{bulk, shear, tau, 0, true, false}};
};

// The bond yields where t = 15 mu e meets beta = sqrt(2 psi0) = tau sqrt(75/(4 pi)) (Eq. 51), at e = gamma/2.
const double alpha = 15 * shear;
const double beta = tau * std::sqrt(75 / (4 * pi));
const double yield_gamma = 2 * beta / alpha;

TEST_F(SingleBond, YieldsWhereThePaperSays) {
  EXPECT_NEAR(yield_gamma, 1.475e-3, 0.5e-6);  // the closed form, to the digits given
  EXPECT_NEAR(yield_gamma, 1.5e-3, 0.05e-3);   // the paper: "approximately 1.5e-3 (from the figure)"
  const MaterialPoint point(material_, family_);
  EXPECT_FALSE(point.evaluate(extension(yield_gamma * (1 - 1e-9))).response.yielding);
  EXPECT_TRUE(point.evaluate(extension(yield_gamma * (1 + 1e-9))).response.yielding);
}

TEST_F(SingleBond, LoopOfLoadingUnloadingAndReloading) {
  // The path goes to the right, back through reverse yield, and to the right again, as in figure 5, in steps that do
  // not meet the kinks. In the exact answer t moves along alpha e and is cut off at +-beta.
  const double turns[] = {0, 4.2e-3, -3.3e-3, 5.1e-3};
  const int steps = 37;
  MaterialPoint point(material_, family_);
  double expected = 0, largest_error = 0, dissipated = 0, work = 0;
  double previous_extension = 0, previous_force = 0;
  int flowing = 0, elastic = 0;
  for (int leg = 0; leg < 3; ++leg)
    for (int s = 1; s <= steps; ++s) {
      const double gamma = turns[leg] + (turns[leg + 1] - turns[leg]) * s / steps;
      const Vector e = extension(gamma);
      const Evaluation now = point.evaluate(e);
      const double trial = expected + alpha * (e[0] - previous_extension);
      expected = std::max(-beta, std::min(beta, trial));
      EXPECT_EQ(now.response.yielding, std::abs(trial) > beta);
      (now.response.yielding ? flowing : elastic) += 1;
      largest_error = std::max(largest_error, std::abs(now.force_state[0] - expected) / beta);
      dissipated += now.response.dissipation;
      work += beta * std::abs(now.bond_history[0] - point.committed_bond()[0]);
      EXPECT_EQ(now.response.dilatation, 0);
      previous_extension = e[0];
      previous_force = now.force_state[0];
      point.commit(now);
    }
  EXPECT_LE(measured("single bond: force along the loop", largest_error), 1e-13);  // 3.0e-16
  EXPECT_NEAR(previous_force, beta, 1e-12 * beta);
  EXPECT_GT(flowing, steps);
  EXPECT_GT(elastic, steps / 2);
  // The plastic work of the loop is beta times the plastic paths 4.2, 7.5 and 8.4 (1e-3) less the elastic spans,
  // halved.
  const double path = 0.5 * ((4.2e-3 - yield_gamma) + (7.5e-3 - 2 * yield_gamma) + (8.4e-3 - 2 * yield_gamma));
  EXPECT_NEAR(work / (beta * path), 1, 1e-12);
  EXPECT_NEAR(dissipated / (beta * path), 1, 1e-12);
}

TEST_F(SingleBond, FlatAfterYieldAndUnloadsParallel) {
  MaterialPoint point(material_, family_);
  const Evaluation yielded = point.evaluate(extension(3e-3));
  EXPECT_NEAR(point.evaluate(extension(4e-3)).force_state[0], yielded.force_state[0], 1e-12 * beta);
  point.commit(yielded);
  const double slope = (yielded.force_state[0] - point.evaluate(extension(2e-3)).force_state[0]) / 1e-3;
  EXPECT_NEAR(slope / (0.5 * alpha), 1, 1e-12);
}

}  // namespace
}  // namespace perinox::test
