/// Chebyshev's iteration as a preconditioner: symmetric and positive definite whatever the estimate, and a third of the
/// iterations where there are many.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "linear/chebyshev_acceleration.hpp"
#include "linear/masked_tangent.hpp"
#include "support/linear_problem.hpp"
#include "support/runs.hpp"

namespace perinox::test {
namespace {

using Vector = std::vector<double>;

const char* const whole = "quadrature: whole\n";
const char* const fitted = "quadrature: position-aware\n";

/// A problem with its preconditioner, and the same in several steps.
struct Accelerated {
  explicit Accelerated(const std::string& yaml, int steps = 3)
      : problem(yaml),
        two_level(problem.two_level()),
        product(two_level->getDomainMap(), *problem.tangent, problem.boundary.prescribed()),
        steps_of(two_level->getDomainMap(), problem.scene.body(), problem.boundary.prescribed(), product, *two_level,
                 steps) {
    steps_of.estimate();
  }
  LinearProblem problem;
  std::unique_ptr<linear::TwoLevel> two_level;
  linear::MaskedTangent product;
  linear::ChebyshevAcceleration steps_of;
};

Vector random_free_vector(const LinearProblem& problem, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> entry(-1, 1);
  Vector v(problem.unknowns);
  for (std::size_t u = 0; u < v.size(); ++u) v[u] = problem.held(u) ? 0 : entry(generator);
  return v;
}

TEST(ChebyshevAcceleration, FindsTheLargestEigenvalue) {
  const Accelerated of(held_cube(12, 0.499, whole));
  Vector v = random_free_vector(of.problem, 1), w(v.size()), z(v.size());
  double largest = 0;
  for (int k = 0; k < 300; ++k) {
    of.product.multiply(v.data(), w.data());
    of.two_level->multiply(w.data(), z.data());
    largest = of.problem.dot(z, w) / of.problem.dot(v, w);
    const double length = std::sqrt(of.problem.dot(z, z));
    for (std::size_t u = 0; u < v.size(); ++u) v[u] = z[u] / length;
  }
  std::printf("largest eigenvalue %.2f, taken for %.2f\n", largest, of.steps_of.interval().highest);  // 124.2, 126.2
  EXPECT_GT(of.steps_of.interval().highest, largest);
  EXPECT_LT(of.steps_of.interval().highest, 1.1 * largest);
}

TEST(ChebyshevAcceleration, SymmetricAndPositiveDefiniteWhateverTheEstimate) {
  for (const double share : {1.0, 0.2, 5.0}) {
    Accelerated of(held_cube(10, 0.499, whole));
    of.steps_of.set_interval({of.steps_of.interval().lowest, share * of.steps_of.interval().highest});
    for (unsigned seed = 1; seed <= 3; ++seed) {
      const Vector w = random_free_vector(of.problem, seed), z = random_free_vector(of.problem, 100 + seed);
      Vector mw(w.size()), mz(w.size());
      of.steps_of.multiply(w.data(), mw.data());
      of.steps_of.multiply(z.data(), mz.data());
      const double size = std::sqrt(of.problem.dot(z, z) * of.problem.dot(mw, mw));
      const double difference = std::abs(of.problem.dot(z, mw) - of.problem.dot(w, mz)) / size;
      std::printf("estimate times %.1f: asymmetry %.1e\n", share, difference);
      EXPECT_LT(difference, 1e-13);
      EXPECT_GT(of.problem.dot(w, mw), 0);
    }
  }
}

TEST(ChebyshevAcceleration, EvenNumbersOfStepsAreRefused) {
  EXPECT_THROW(Accelerated(held_cube(10, 0.499, whole), 2), std::logic_error);
}

/// A tangent that is not finite.
struct NotANumber : linear::OwnedOperator {
  using OwnedOperator::OwnedOperator;
  void multiply(const double*, double* y) const override { std::fill_n(y, getDomainMap()->getNodeNumElements(), NAN); }
};

TEST(ChebyshevAcceleration, IsThePreconditionerAloneWhereThereIsNoInterval) {
  const Accelerated of(held_cube(10, 0.499, whole));
  const NotANumber broken(of.two_level->getDomainMap());
  linear::ChebyshevAcceleration three(of.two_level->getDomainMap(), of.problem.scene.body(),
                                      of.problem.boundary.prescribed(), broken, *of.two_level, 3);
  three.estimate();
  EXPECT_EQ(three.interval().highest, 0);
  const Vector r = random_free_vector(of.problem, 1);
  Vector z(r.size()), alone(r.size());
  three.multiply(r.data(), z.data());
  of.two_level->multiply(r.data(), alone.data());
  EXPECT_EQ(z, alone);
}

int counted(const std::string& name, const std::string& yaml) {
  const Accelerated of(yaml);
  const int one = of.problem.iterations(*of.two_level), three = of.problem.iterations(of.steps_of);
  std::printf("%-20s %3d iterations of one product, %d of three: %.2f times the products\n", name.c_str(), one, three,
              3.0 * three / one);
  EXPECT_LE(3 * three, 1.3 * one) << name;
  return three;
}

TEST(ChebyshevAcceleration, NearlyIncompressible) {
  EXPECT_LE(counted("nu 0.499, 16", held_cube(16, 0.499, whole)), 45);
  EXPECT_LE(counted("nu 0.499, 24", held_cube(24, 0.499, whole)), 45);
  EXPECT_LE(counted("fitted, nu 0.499, 16", held_cube(16, 0.499, fitted)), 50);
}

TEST(ChebyshevAcceleration, IsWhatNearlyIncompressibleScenesTake) {
  const auto iterations = [](double ratio, const std::vector<std::string>& more) {
    std::vector<std::string> overrides{"solver.newton.forcing=constant", "solver.linear.tolerance=1e-8"};
    overrides.insert(overrides.end(), more.begin(), more.end());
    const RunResult run = run_deck(deck_of(held_cube(14, ratio, whole), overrides));
    EXPECT_EQ(run.stopped, "");
    EXPECT_EQ(run.preconditioner, "two-level");
    const StepRecord& step = run.records.steps.back();
    const auto products = step.profile.count_of(Section::product);
    std::printf("nu %g: %d Newton iterations, %d linear, %lld products\n", ratio, step.newton_iterations,
                step.linear_iterations, products);
    return std::array<double, 2>{static_cast<double>(step.linear_iterations), static_cast<double>(products)};
  };
  const std::array<double, 2> automatic = iterations(0.499, {}),
                              three = iterations(0.499, {"solver.linear.chebyshev_steps=3"}),
                              one = iterations(0.499, {"solver.linear.chebyshev_steps=1"}),
                              compressible = iterations(0.4975, {});
  EXPECT_EQ(automatic, three);
  EXPECT_LT(2.2 * automatic[0], one[0]);
  EXPECT_GT(automatic[1], 3 * automatic[0]);
  EXPECT_LT(compressible[1], 1.2 * compressible[0]);
}

}  // namespace
}  // namespace perinox::test
