/// Bending: a cantilever in plane stress whose ends follow the exact solution, and a square bar in pure bending.
#include <gtest/gtest.h>

#include "support/particles.hpp"
#include "support/verification.hpp"

namespace perinox::test {
namespace {

constexpr double young = 68.9e3;
constexpr double poisson = 0.33;

/// Timoshenko & Goodier, Theory of Elasticity, art. 21: a beam of height 2c = 1 and unit thickness, shear P at x = 0,
/// held at x = 4. Both ends, two horizons long, follow that field; the sides are free.
double cantilever_error(Verification& force, Verification& field, const std::string& quadrature, int across) {
  const double length = 4, c = 0.5, h = 1.0 / across, rim = 6 * h, p = 1;
  const double inertia = 1 / 12.0, g = young / (2 * (1 + poisson)), ei = young * inertia, ig = inertia * g;
  const std::string ux =
      fmt::format("{p}*(-x^2*y/(2*{ei}) - {nu}*y^3/(6*{ei}) + y^3/(6*{ig}) + ({l}^2/(2*{ei}) - {c}^2/(2*{ig}))*y)",
                  fmt::arg("p", p), fmt::arg("ei", ei), fmt::arg("ig", ig), fmt::arg("nu", poisson),
                  fmt::arg("l", length), fmt::arg("c", c));
  const std::string uy =
      fmt::format("{p}*({nu}*x*y^2/(2*{ei}) + x^3/(6*{ei}) - {l}^2*x/(2*{ei}) + {l}^3/(3*{ei}))", fmt::arg("p", p),
                  fmt::arg("ei", ei), fmt::arg("nu", poisson), fmt::arg("l", length));
  const Solution solution = solve_to_end(fmt::format(
      R"yaml(
dimension: plane-stress
body: [{{name: beam, shape: {{box: {{min: [0, -0.5], max: [4, 0.5]}}}}, spacing: {0:.17g}, material: m}}]
horizon: {{ratio: 3.015}}
quadrature: {1}
deformation: small
materials: {{m: {{model: elastic, young_modulus: {2}, poisson_ratio: {3}}}}}
sets: {{ends: {{where: "x < {4:.17g} || x > {5:.17g}"}}}}
boundary: [{{set: ends, displacement: {{x: "{6}", y: "{7}"}}}}]
steps: {{end: 1, count: 1}}
solver: {{newton: {{tolerance: 1e-11}}}}
)yaml",
      h, quadrature, young, poisson, rim, length - rim, ux, uy));
  const auto exact = [&](const deck::Point& x) {
    const double a = x[0], b = x[1];
    return std::array<double, 3>{p * (-a * a * b / (2 * ei) - poisson * b * b * b / (6 * ei) + b * b * b / (6 * ig) +
                                      (length * length / (2 * ei) - c * c / (2 * ig)) * b),
                                 p * (poisson * a * b * b / (2 * ei) + a * a * a / (6 * ei) -
                                      length * length * a / (2 * ei) + length * length * length / (3 * ei)),
                                 0};
  };
  const double found = total(
      solution, [&](auto& q) { return q.x[0] > length - rim; }, [](auto& q) { return q.pull[1]; });
  const std::string resolution = fmt::format("height {} h", across);
  field.converging(quadrature, resolution, solution.particles.size(),
                   field_error(
                       solution, [&](auto& x) { return x[0] > rim && x[0] < length - rim; }, exact),
                   across);
  return force.converging(quadrature, resolution, solution.particles.size(), std::abs(found) / p - 1, across);
}

/// Saint-Venant's pure bending, u = curvature (-nu x y, -(z^2 + nu (y^2 - x^2))/2, y z), at both ends, two horizons
/// long, of a square bar: E from the moment over the curvature of the middle
/// third, against E width^4/12.
double pure_bending_error(Verification& table, const std::string& quadrature, int width) {
  const double half = width / 2.0, length = 4 * width, curvature = 1e-3 / width;
  const Solution solution = solve_to_end(fmt::format(
      R"yaml(
dimension: 3
body: [{{name: bar, shape: {{box: {{min: [-{0}, -{0}, -{1}], max: [{0}, {0}, {1}]}}}}, spacing: 1, material: m}}]
horizon: {{length: 3.015}}
quadrature: {2}
deformation: small
materials: {{m: {{model: elastic, young_modulus: {3}, poisson_ratio: {4}}}}}
sets: {{ends: {{where: "abs(z) > {5}"}}}}
boundary:
  - set: ends
    displacement: {{x: "-{6:.17g}*{4}*x*y", y: "-{6:.17g}/2*(z^2 + {4}*(y^2 - x^2))", z: "{6:.17g}*y*z"}}
steps: {{end: 1, count: 1}}
solver: {{newton: {{tolerance: 1e-10}}}}
)yaml",
      half, length / 2, quadrature, young, poisson, length / 2 - 6, curvature));
  const double moment = total(
      solution, [&](auto& q) { return q.x[2] > length / 2 - 6; },
      [](auto& q) { return q.x[1] * q.pull[2] - q.x[2] * q.pull[1]; });
  const auto middle = [&](const Particle& q) { return std::abs(q.x[2]) < length / 6; };
  const double square = total(solution, middle, [](auto& q) { return q.x[1] * q.x[1]; }) /
                        total(solution, middle, [](auto&) { return 1.0; });
  const double bent = slope(
      solution, middle, [](auto& q) { return q.x[2]; }, [&](auto& q) { return q.x[1] * q.u[2] / square; });
  return table.converging(quadrature, fmt::format("{0} x {0} x {1} h", width, length), solution.particles.size(),
                          moment / (young * std::pow(width, 4) / 12 * bent) - 1, width);
}

TEST(Bending, Cantilever) {
  Verification force("bending", "cantilever, plane stress: shear force", "Timoshenko & Goodier art. 21");
  Verification field("bending", "cantilever, plane stress: displacement", "Timoshenko & Goodier art. 21");
  for (const int across : resolutions({10, 20, 40}, {80}))
    EXPECT_LE(std::abs(cantilever_error(force, field, "position-aware", across)),
              0.3 / across);  // 0.024, 0.011, 0.0041
  for (const int across : resolutions({10, 20, 40}, {80})) cantilever_error(force, field, "whole", across);
}

TEST(Bending, SquareBar) {
  Verification table("bending", "square bar, pure bending: E I", "Saint-Venant");
  // Over the goal of 1 % up to 16 particles. The particles' own moment of inertia, width^4/12 (1 - 1/width^2), is a
  // quarter of it.
  for (const int width : resolutions({8, 12, 16}, {24, 32}))
    EXPECT_LE(std::abs(pure_bending_error(table, "position-aware", width)),
              7.0 / (width * width));  // 4.0, 4.7, 5.2, 5.9, 6.5 over width^2
  for (const int width : resolutions({8, 12, 16}, {24, 32})) pure_bending_error(table, "whole", width);
}

}  // namespace
}  // namespace perinox::test
