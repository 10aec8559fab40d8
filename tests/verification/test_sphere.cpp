/// A thick sphere, bore 1 and outer radius 2, under pressure in the bore: elastic (Lame; Timoshenko & Goodier art.
/// 136), with a growing plastic zone and at its limit (Hill, The Mathematical Theory of Plasticity, 1950, chapter V.2).
#include <gtest/gtest.h>

#include "support/particles.hpp"
#include "support/verification.hpp"

namespace perinox::test {
namespace {

constexpr double young = 200e3;
constexpr double poisson = 0.3;
constexpr double yield = 300;
constexpr double b3 = 8;  ///< outer radius cubed; that of the bore is 1

/// `across`: odd number of spacings from side to side, so that a layer of particles lies in each plane of symmetry and
/// holds the sphere without constraining it.
std::string sphere(const std::string& quadrature, int across, const std::string& material, const std::string& pressure,
                   const std::string& steps, const std::string& more = "") {
  return fmt::format(
      R"yaml(
dimension: 3
body:
  - name: sphere
    shape: {{difference: [{{sphere: {{center: [0, 0, 0], radius: 2}}}}, {{sphere: {{center: [0, 0, 0], radius: 1}}}}]}}
    spacing: {0:.17g}
    material: steel
horizon: {{ratio: 3.015}}
quadrature: {1}
deformation: small
materials: {{steel: {{{2}, young_modulus: {3}, poisson_ratio: {4}}}}}
sets:
  bore: {{where: "x^2 + y^2 + z^2 < 2.25"}}
  across_x: {{where: "abs(x) < {5:.17g}"}}
  across_y: {{where: "abs(y) < {5:.17g}"}}
  across_z: {{where: "abs(z) < {5:.17g}"}}
{8}boundary:
  - {{set: bore, pressure: "{6}"}}
  - {{set: across_x, displacement: {{x: 0}}}}
  - {{set: across_y, displacement: {{y: 0}}}}
  - {{set: across_z, displacement: {{z: 0}}}}
steps: {{{7}}}
)yaml",
      4.0 / across, quadrature, material, young, poisson, 1.0 / across, pressure, steps, more);
}

double radius(const deck::Point& x) { return std::hypot(x[0], x[1], x[2]); }
/// Without the innermost layers, where the load of the bore's steps is spread over three rows of particles.
bool in_the_wall(const deck::Point& x) { return radius(x) > 1.25; }

/// u = stretch(r) x.
double radial_error(const Solution& solution, const std::function<double(double)>& stretch) {
  return field_error(solution, in_the_wall, [&](const deck::Point& x) {
    const double s = stretch(radius(x));
    return std::array<double, 3>{s * x[0], s * x[1], s * x[2]};
  });
}

/// Hill's radial displacement over the radius r while the plastic zone reaches to c.
double stretch(double r, double c) {
  const double c3 = c * c * c, r3 = r * r * r;
  if (r > c) return 2 * yield * c3 / (3 * young * b3) * ((1 - 2 * poisson) + (1 + poisson) * b3 / (2 * r3));
  return yield / young * ((1 - poisson) * c3 / r3 - 2.0 / 3 * (1 - 2 * poisson) * (1 + 3 * std::log(c / r) - c3 / b3));
}

double lame_error(Verification& table, const std::string& quadrature, int across) {
  const double p = 100;
  const Solution solution =
      solve_to_end(sphere(quadrature, across, "model: elastic", fmt::format("{}*t", p), "end: 1, count: 1"));
  const auto lame = [&](double r) {
    return p / (young * (b3 - 1)) * ((1 - 2 * poisson) + (1 + poisson) * b3 / (2 * r * r * r));
  };
  return table.converging(quadrature, fmt::format("{} h across", across), solution.particles.size(),
                          radial_error(solution, lame), across);
}

const std::string plastic = fmt::format("model: elastic-plastic, yield_stress: {{tension: {}}}", yield);

/// At the pressure at which the plastic zone reaches 1.3.
double plastic_zone(Verification& displacement, Verification& zone, const std::string& quadrature, int across) {
  const double c = 1.3, c3 = c * c * c;
  const double pressure = 2 * yield * std::log(c) + 2 * yield / 3 * (1 - c3 / b3);
  const Solution solution =
      solve_to_end(sphere(quadrature, across, plastic, fmt::format("{:.17g}*t", pressure), "end: 1, count: 10"));
  const std::string resolution = fmt::format("{} h across", across);
  displacement.converging(quadrature, resolution, solution.particles.size(),
                          radial_error(solution, [&](double r) { return stretch(r, c); }), across);
  double flowing = 0;
  for (const Particle& particle : solution.particles)
    if (particle.equivalent_plastic_strain > 0) flowing += particle.volume;
  const double found = std::cbrt(1 + 3 * flowing / (4 * std::acos(-1.0)));
  return zone.converging(quadrature, resolution, solution.particles.size(), found / c - 1, across);
}

/// The pressure over 2 yield ln 2 at which the outer surface has moved twice as far as in Hill's solution when all the
/// wall flows: there he has a plateau, here a knee.
double limit_error(Verification& table, const std::string& quadrature, int across) {
  const double limit = 2 * yield * std::log(2.0), tip = 2 - 2.0 / across;  // the outermost particle on the x axis
  // Up to 0.8 of it in four steps, then by 0.01 a step.
  const std::string pressure = fmt::format("{:.17g}*(t < 4 ? 0.2*t : 0.8 + 0.01*(t - 4))", limit);
  const std::string at_tip = fmt::format(R"yaml(  tip: {{where: "x > {:.17g} && y^2 + z^2 < 1e-6"}}
history: [{{name: tip, displacement: tip, component: x}}]
)yaml",
                                         tip - 1.0 / across);
  const double exact = 2 * tip * stretch(tip, 2);
  const auto moved = [&](const Step& step) { return step.history.at(0) > exact; };
  const Solution solution = solve(sphere(quadrature, across, plastic, pressure, "end: 40, count: 40", at_tip), moved);
  const auto pressure_at = [](double t) { return t < 4 ? 0.2 * t : 0.8 + 0.01 * (t - 4); };
  if (solution.steps.size() < 2 || !moved(solution.steps.back())) {
    ADD_FAILURE() << "the surface moved less than " << exact << ": " << solution.stopped;
    return std::nan("");
  }
  const Step &before = solution.steps[solution.steps.size() - 2], &after = solution.steps.back();
  const double share = (exact - before.history[0]) / (after.history[0] - before.history[0]);
  const double reached = pressure_at(before.t) + share * (pressure_at(after.t) - pressure_at(before.t));
  return table.converging(quadrature, fmt::format("{} h across", across), solution.particles.size(), reached - 1,
                          across);
}

/// A tube in plane strain, the same radii and pressure: u_r = (1 + nu) p/(E (b^2 - 1)) ((1 - 2 nu) r + b^2/r).
double tube_error(Verification& table, const std::string& quadrature, int across) {
  const double p = 100;
  const Solution solution = solve_to_end(fmt::format(
      R"yaml(
dimension: plane-strain
body:
  - name: tube
    shape: {{difference: [{{sphere: {{center: [0, 0], radius: 2}}}}, {{sphere: {{center: [0, 0], radius: 1}}}}]}}
    spacing: {0:.17g}
    material: steel
horizon: {{ratio: 3.015}}
quadrature: {1}
deformation: small
materials: {{steel: {{model: elastic, young_modulus: {2}, poisson_ratio: {3}}}}}
sets:
  bore: {{where: "x^2 + y^2 < 2.25"}}
  across_x: {{where: "abs(x) < {4:.17g}"}}
  across_y: {{where: "abs(y) < {4:.17g}"}}
boundary:
  - {{set: bore, pressure: "{5}*t"}}
  - {{set: across_x, displacement: {{x: 0}}}}
  - {{set: across_y, displacement: {{y: 0}}}}
steps: {{end: 1, count: 1}}
)yaml",
      4.0 / across, quadrature, young, poisson, 1.0 / across, p));
  const double error = radial_error(
      solution, [&](double r) { return (1 + poisson) * p / (young * 3) * ((1 - 2 * poisson) + 4 / (r * r)); });
  return table.converging(quadrature, fmt::format("{} h across", across), solution.particles.size(), error, across);
}

TEST(Sphere, ElasticTube) {
  Verification table("sphere", "tube, plane strain, elastic: displacement", "Lame 1852");
  for (const int across : resolutions({25, 49, 97, 193}, {385, 769}))
    EXPECT_LE(tube_error(table, "position-aware", across), 0.05);  // 0.045, 0.027, 0.012, 0.005
  for (const int across : resolutions({25, 49, 97, 193}, {385, 769})) tube_error(table, "whole", across);
}

TEST(Sphere, ElasticUnderPressure) {
  // Over the goal of 1 % at every resolution that was run: 0.021 at 65 across, 0.012 at 97.
  Verification table("sphere", "elastic: displacement", "Lame 1852");
  for (const int across : resolutions({25, 33, 49}, {65, 97}))
    // 0.051, 0.046, 0.032; with sampled volumes, which were up to 5 % too large, it was 0.049, 0.041, 0.030
    EXPECT_LE(lame_error(table, "position-aware", across), 0.052);
  for (const int across : resolutions({25, 33, 49}, {65, 97}))
    EXPECT_GE(lame_error(table, "whole", across), 0.12);  // 0.189, 0.161, 0.141
}

TEST(Sphere, PlasticZone) {
  // The error of the elastic wall, enlarged by the flow that follows it.
  Verification displacement("sphere", "plastic zone to 1.3: displacement", "Hill 1950");
  Verification zone("sphere", "plastic zone to 1.3: its radius", "Hill 1950");
  for (const int across : resolutions({25}, {33, 49, 65}))
    EXPECT_LE(plastic_zone(displacement, zone, "position-aware", across), 0.09);  // 0.073, 0.047, 0.016, 0.008
  for (const int across : resolutions({25}, {33, 49})) plastic_zone(displacement, zone, "whole", across);
}

TEST(Sphere, LimitPressure) {
  Verification table("sphere", "limit pressure", "Hill 1950: 2 yield ln(b/a)");
  for (const int across : resolutions({25}, {33, 49, 65}))
    EXPECT_LE(std::abs(limit_error(table, "position-aware", across)),
              across < 49 ? 0.09 : 0.02);                                              // 0.085, 0.048; 0.019, 0.010
  for (const int across : resolutions({}, {33})) limit_error(table, "whole", across);  // at 25 no knee below 1.16
}

}  // namespace
}  // namespace perinox::test
