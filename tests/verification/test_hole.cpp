/// A small round hole in a plate under tension, plane stress: Kirsch's infinite plate prescribed around a square.
#include <gtest/gtest.h>

#include "support/particles.hpp"
#include "support/verification.hpp"

namespace perinox::test {
namespace {

constexpr double young = 68.9e3;
constexpr double poisson = 0.33;
constexpr double tension = 100;

/// Displacement around a hole of radius 1 under tension along x (Kirsch 1898; Timoshenko & Goodier art. 35,
/// integrated).
std::array<double, 3> kirsch(const deck::Point& x) {
  const double g = young / (2 * (1 + poisson)), k = (3 - poisson) / (1 + poisson);
  const double r = std::hypot(x[0], x[1]), a = std::atan2(x[1], x[0]), f = tension / (8 * g);
  return {f * (r * (k + 1) * std::cos(a) + 2 / r * ((1 + k) * std::cos(a) + std::cos(3 * a)) -
               2 / (r * r * r) * std::cos(3 * a)),
          f * (r * (k - 3) * std::sin(a) + 2 / r * ((1 - k) * std::sin(a) + std::sin(3 * a)) -
               2 / (r * r * r) * std::sin(3 * a)),
          0};
}

struct Tables {
  Verification field{"hole", "plate with a hole: displacement", "Kirsch 1898"};
  Verification rim{"hole", "plate with a hole: opening of the hole", "Kirsch 1898"};
  Verification edge{"hole", "stress beside the hole, first particle", "Kirsch 1898"};
  Verification inside{"hole", "stress beside the hole, fourth particle", "Kirsch 1898"};
};

struct Found {
  double field = 0, opening = 0, edge = 0, inside = 0;
};

/// A square of eight radii, n spacings a radius. opening: the stretch between the particles that touch the hole at its
/// two ends along x, over the exact one at the same places.
Found errors(Tables& tables, const std::string& quadrature, int n) {
  const double h = 1.0 / n, rim = 4 - 6 * h;
  const double g = young / (2 * (1 + poisson)), k = (3 - poisson) / (1 + poisson), f = tension / (8 * g);
  const std::string r = "sqrt(x^2 + y^2)", a = "atan2(y, x)";
  const auto component = [&](double with_r, double with_one, const char* wave) {
    return fmt::format("{0:.17g}*({1}*{2:.17g}*{4}({3}) + 2/{1}*({5:.17g}*{4}({3}) + {4}(3*{3})) - 2/{1}^3*{4}(3*{3}))",
                       f, r, with_r, a, wave, with_one);
  };
  const Solution solution = solve_to_end(fmt::format(
      R"yaml(
dimension: plane-stress
body:
  - name: plate
    shape: {{plate_with_hole: {{min: [-4, -4], max: [4, 4], center: [0, 0], radius: 1}}}}
    spacing: {0:.17g}
    material: m
horizon: {{ratio: 3.015}}
quadrature: {1}
deformation: small
materials: {{m: {{model: elastic, young_modulus: {2}, poisson_ratio: {3}}}}}
sets: {{rim: {{where: "max(abs(x), abs(y)) > {4:.17g}"}}}}
boundary:
  - set: rim
    displacement: {{x: "{5}", y: "{6}"}}
steps: {{end: 1, count: 1}}
output: {{fields: [displacement, stress]}}
solver: {{newton: {{tolerance: 1e-10}}}}
)yaml",
      h, quadrature, young, poisson, rim, component(k + 1, 1 + k, "cos"), component(k - 3, 1 - k, "sin")));
  const auto at_hole = [&](const Particle& p) { return std::abs(p.x[1]) < h && std::abs(p.x[0]) < 1 + h; };
  const auto outwards = [](const deck::Point& x, double ux) { return x[0] > 0 ? ux : -ux; };
  const double opening = total(solution, at_hole, [&](auto& p) { return outwards(p.x, p.u[0]); });
  const double exact = total(solution, at_hole, [&](auto& p) { return outwards(p.x, kirsch(p.x)[0]); });
  const std::string resolution = fmt::format("radius {} h", n);
  Found found;
  found.field = tables.field.converging(
      quadrature, resolution, solution.particles.size(),
      field_error(
          solution, [&](auto& x) { return std::max(std::abs(x[0]), std::abs(x[1])) < rim; }, kirsch),
      n);
  found.opening = tables.rim.converging(quadrature, resolution, solution.particles.size(), opening / exact - 1, n);
  // Where it is largest, tension (1 + 1/(2 r^2) + 3/(2 r^4)): the particles next to the y axis, `layer` from the hole.
  const auto stress_error = [&](int layer) {
    double sum = 0, kirsch_sum = 0;
    for (const Particle& p : solution.particles) {
      const double y = std::abs(p.x[1]), r2 = y * y;
      if (std::abs(p.x[0]) > h || y < 1 + layer * h || y > 1 + (layer + 1) * h) continue;
      sum += p.stress_xx;
      kirsch_sum += tension * (1 + 1 / (2 * r2) + 3 / (2 * r2 * r2));
    }
    return sum / kirsch_sum - 1;
  };
  found.edge = tables.edge.converging(quadrature, resolution, solution.particles.size(), stress_error(0), n);
  found.inside = tables.inside.converging(quadrature, resolution, solution.particles.size(), stress_error(3), n);
  return found;
}

TEST(Hole, InAPlateUnderTension) {
  Tables tables;
  for (const int n : resolutions({8, 16, 32}, {64})) {
    const Found found = errors(tables, "position-aware", n);
    EXPECT_LE(found.field, 0.1 / n);               // 0.076, 0.054, 0.044 over n
    EXPECT_LE(std::abs(found.opening), 0.12 / n);  // 0.098, 0.064, 0.050 over n
    EXPECT_LE(std::abs(found.edge), 0.17);         // 0.163, 0.112, 0.123: the outermost layer does not converge
    EXPECT_LE(std::abs(found.inside), 0.045);      // 0.039, 0.027, 0.016
  }
  for (const int n : resolutions({8, 16, 32}, {64})) errors(tables, "whole", n);
}

}  // namespace
}  // namespace perinox::test
