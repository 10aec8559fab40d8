/// A cube cut out of the wall of a thick sphere whose plastic zone grows outwards (Hill, The Mathematical Theory of
/// Plasticity, 1950, chapter V.2): Hill's displacement is prescribed around it, displacement and plastic strain inside
/// are compared with his. Convergence to the local answer as the horizon shrinks.
#include <gtest/gtest.h>

#include "support/particles.hpp"
#include "support/verification.hpp"

namespace perinox::test {
namespace {

// Bore 1, outer radius 2, perfect plasticity; the plastic zone grows from the bore to 1.5. The cube is x from 1 to 2.
constexpr double young = 200e3;
constexpr double poisson = 0.3;
constexpr double yield = 300;
constexpr double outer = 2;
constexpr double front = 1.5;

/// Radial displacement over the radius; c: radius of the plastic zone.
double stretch(double r, double c) {
  const double b3 = outer * outer * outer, c3 = c * c * c, r3 = r * r * r;
  if (r > c) return 2 * yield * c3 / (3 * young * b3) * ((1 - 2 * poisson) + (1 + poisson) * b3 / (2 * r3));
  return yield / young * ((1 - poisson) * c3 / r3 - 2.0 / 3 * (1 - 2 * poisson) * (1 + 3 * std::log(c / r) - c3 / b3));
}
double plastic_strain(double r, double c) {
  return r < c ? 2 * (1 - poisson) * yield / young * (c * c * c / (r * r * r) - 1) : 0;
}

struct Found {
  double displacement = 0, plastic_strain = 0;
};

Found errors(Verification& displacement, Verification& strain, const std::string& quadrature, int n, int steps) {
  const double h = 1.0 / n;
  const std::string r = "sqrt(x^2+y^2+z^2)", c = "(1+0.5*t)";
  const std::string u = fmt::format(
      "({r} > {c} ? 2*{s}*{c}^3/(3*{e}*8)*(1-2*{v}+(1+{v})*8/(2*{r}^3)) : "
      "{s}/{e}*((1-{v})*{c}^3/{r}^3-2/3*(1-2*{v})*(1+3*ln({c}/{r})-{c}^3/8)))",
      fmt::arg("r", r), fmt::arg("c", c), fmt::arg("s", yield), fmt::arg("e", young), fmt::arg("v", poisson));
  const std::string inside = "x > 1.3 && x < 1.7 && abs(y) < 0.2 && abs(z) < 0.2";
  const Solution solution = solve_to_end(fmt::format(
      R"yaml(
dimension: 3
body: [{{name: wall, shape: {{box: {{min: [1, -0.5, -0.5], max: [2, 0.5, 0.5]}}}}, spacing: {0:.17g}, material: m}}]
horizon: {{ratio: 3.015}}
quadrature: {1}
deformation: small
materials: {{m: {{model: elastic-plastic, young_modulus: {2}, poisson_ratio: {3}, yield_stress: {{tension: {4}}}}}}}
sets: {{around: {{where: "({5}) == 0"}}}}
boundary:
  - set: around
    displacement: {{x: "x*{6}", y: "y*{6}", z: "z*{6}"}}
steps: {{end: 1, count: {7}}}
)yaml",
      h, quadrature, young, poisson, yield, inside, u, steps));
  const auto within = [](const deck::Point& x) {
    return x[0] > 1.3 && x[0] < 1.7 && std::abs(x[1]) < 0.2 && std::abs(x[2]) < 0.2;
  };
  const auto radius = [](const deck::Point& x) { return std::hypot(x[0], x[1], x[2]); };
  const auto exact = [&](const deck::Point& x) {
    const double s = stretch(radius(x), front);
    return std::array<double, 3>{s * x[0], s * x[1], s * x[2]};
  };
  double difference = 0, size = 0;
  for (const Particle& particle : solution.particles) {
    if (!within(particle.x)) continue;
    const double p = plastic_strain(radius(particle.x), front);
    difference += std::pow(particle.equivalent_plastic_strain - p, 2);
    size += p * p;
  }
  const std::string resolution = fmt::format("h = 1/{}, {} steps", n, steps);
  Found found;
  found.displacement = displacement.converging(quadrature, resolution, solution.particles.size(),
                                               field_error(solution, within, exact), n);
  found.plastic_strain =
      strain.converging(quadrature, resolution, solution.particles.size(), std::sqrt(difference / size), n);
  return found;
}

TEST(PlasticField, ConvergesToTheLocalAnswer) {
  Verification displacement("plastic field", "wall of a sphere: displacement", "Hill 1950");
  Verification strain("plastic field", "wall of a sphere: plastic strain", "Hill 1950");
  for (const int n : resolutions({20, 30}, {40, 60})) {
    const Found found = errors(displacement, strain, "position-aware", n, 10);
    EXPECT_LE(found.displacement, 0.6 / (n * n));             // 0.52, 0.51, 0.50 over n^2
    EXPECT_LE(found.plastic_strain, 15 * std::pow(n, -1.7));  // 12.2, 12.0, 11.9
  }
  EXPECT_GE(displacement.order(), 1.9);  // 2.05
  EXPECT_GE(strain.order(), 1.6);        // 1.74
  for (const int n : resolutions({20}, {30, 40, 60})) errors(displacement, strain, "whole", n, 10);
}

}  // namespace
}  // namespace perinox::test
