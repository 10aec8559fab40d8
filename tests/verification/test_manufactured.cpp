/// A smooth displacement with the body force that local elasticity gives it, prescribed around a square or cube. Two
/// limits: the horizon shrinks, always 3.015 spacings, and the error falls with its square if uniform strain is exact;
/// the horizon stays and holds ever more spacings, and the error settles on that of the nonlocal model.
#include <gtest/gtest.h>

#include <cmath>

#include "support/particles.hpp"
#include "support/verification.hpp"

namespace perinox::test {
namespace {

constexpr double kappa = 2, shear = 1;  // of the dimension at hand
const double circle = std::acos(-1.0);

struct Found {
  double error = 0;  ///< root mean square inside, over the field's own
  std::size_t particles = 0;
};

/// n spacings an edge, the horizon `ratio` spacings.
Found error_of(const std::string& quadrature, const std::string& dimension, int n, double ratio) {
  const bool solid = dimension == "3";
  // u = a (sin px sin py, cos px cos py) with p = pi has the divergence zero; a quadratic part has not.
  // sigma = kappa tr I + 2 mu dev, f = -div sigma.
  const std::string ux = "1e-3*(sin(pi*x)*sin(pi*y) + x*x)", uy = "1e-3*(cos(pi*x)*cos(pi*y) + x*y)";
  const int d = solid ? 3 : 2;
  // laplacian u = a (-2 pi^2 s s + 2, -2 pi^2 c c), grad div u = a (3, 0), div of the quadratic part 3 x.
  const double along = kappa + shear * (1 - 2.0 / d);
  const std::string fx = fmt::format("-1e-3*({}*(2 - 2*pi*pi*sin(pi*x)*sin(pi*y)) + {})", shear, 3 * along);
  const std::string fy = fmt::format("-1e-3*({}*(-2*pi*pi*cos(pi*x)*cos(pi*y)))", shear);
  std::string inside = "x > 0.3 && x < 0.7 && y > 0.3 && y < 0.7";
  if (solid) inside += " && z > 0.3 && z < 0.7";
  // Bulk and shear modulus of the solid that has kappa in this dimension.
  const double bulk = dimension == "plane-strain" ? kappa - shear / 3 : kappa;
  const double stress_bulk = 4 * kappa * shear / (9 * shear - 3 * kappa);  // of plane stress
  const std::string yaml = fmt::format(R"yaml(
dimension: {0}
body: [{{name: body, shape: {{box: {{min: [0, 0{1}], max: [1, 1{2}]}}}}, spacing: {3:.17g}, material: m}}]
horizon: {{ratio: {13:.17g}}}
quadrature: {4}
deformation: small
materials: {{m: {{model: elastic, bulk_modulus: {5:.17g}, shear_modulus: {6}}}}}
sets: {{inside: {{where: "{7}"}}, around: {{where: "({7}) == 0"}}}}
boundary:
  - {{set: around, displacement: {{x: "{8}", y: "{9}"{12}}}}}
  - {{set: inside, body_force: {{x: "{10}", y: "{11}"}}}}
steps: {{end: 1, count: 1}}
solver: {{newton: {{tolerance: 1e-11}}}}
)yaml",
                                       dimension, solid ? ", 0" : "", solid ? ", 1" : "", 1.0 / n, quadrature,
                                       dimension == "plane-stress" ? stress_bulk : bulk, shear, inside, ux, uy, fx, fy,
                                       solid ? ", z: 0" : "", ratio);
  const Solution solution = solve_to_end(yaml);
  const auto within = [&](const deck::Point& x) {
    bool all = true;
    for (int c = 0; c < d; ++c) all = all && x[c] > 0.3 && x[c] < 0.7;
    return all;
  };
  const auto exact = [](const deck::Point& x) {
    return std::array<double, 3>{1e-3 * (std::sin(circle * x[0]) * std::sin(circle * x[1]) + x[0] * x[0]),
                                 1e-3 * (std::cos(circle * x[0]) * std::cos(circle * x[1]) + x[0] * x[1]), 0};
  };
  return {field_error(solution, within, exact), solution.particles.size()};
}

std::string shown(const std::string& dimension) { return dimension == "3" ? "3-D" : dimension; }

/// The order of the last two resolutions.
double horizon_order(const std::string& quadrature, const std::string& dimension, const std::vector<int>& edges) {
  Verification table("smooth", "horizon shrinks, " + shown(dimension), "manufactured");
  for (const int n : edges) {
    const Found found = error_of(quadrature, dimension, n, 3.015);
    table.converging(quadrature, fmt::format("h = 1/{}", n), found.particles, found.error, n);
  }
  return table.order();
}

/// Errors with a horizon of 0.1 and 2.015, 3.015, ... spacings in it.
std::vector<double> settling(const std::string& quadrature, const std::string& dimension,
                             const std::vector<int>& spacings) {
  Verification table("smooth", "horizon 0.1 stays, " + shown(dimension), "manufactured");
  std::vector<double> errors;
  for (const int m : spacings) {
    const Found found = error_of(quadrature, dimension, 10 * m, m + 0.015);
    errors.push_back(
        table.row(quadrature, fmt::format("horizon {} h, h = 1/{}", m + 0.015, 10 * m), found.particles, found.error));
  }
  return errors;
}

TEST(Manufactured, ConvergesWithTheHorizon) {
  EXPECT_GE(horizon_order("position-aware", "plane-strain", resolutions({20, 40, 80}, {160})), 1.9);  // 2.2
  EXPECT_GE(horizon_order("position-aware", "plane-stress", resolutions({20, 40, 80}, {160})), 1.9);  // 2.2
  EXPECT_GE(horizon_order("position-aware", "3", resolutions({20, 40}, {60})), 1.9);                  // 2.5
}

TEST(Manufactured, DoesNotWithoutIsotropicWeights) {  // the moduli of whole neighbours are wrong at any resolution
  EXPECT_LE(horizon_order("whole", "plane-strain", resolutions({20, 40, 80}, {160})), 0.5);  // 0.1
  horizon_order("whole", "3", resolutions({20, 40}, {60}));
}

TEST(Manufactured, SettlesAsTheFamilyFills) {
  for (const std::string dimension : {"plane-strain", "3"}) {
    const std::vector<int> spacings =
        dimension == "3" ? resolutions({2, 3}, {4, 5, 6}) : resolutions({2, 3, 4, 5, 6}, {8, 12});
    const std::vector<double> errors = settling("position-aware", dimension, spacings);
    EXPECT_LE(*std::max_element(errors.begin(), errors.end()), 3e-3);
    settling("whole", dimension, spacings);
  }
}

}  // namespace
}  // namespace perinox::test
