/// A smooth displacement with the body force that local elasticity gives it, prescribed around a square or cube: the
/// error inside falls with the square of the horizon, the horizon always 3.015 spacings, if uniform strain is exact.
#include <gtest/gtest.h>

#include <cmath>

#include "support/measured.hpp"
#include "support/runs.hpp"

namespace perinox::testing {
namespace {

constexpr double kappa = 2, shear = 1;  // of the dimension at hand
const double circle = std::acos(-1.0);

/// Root mean square error inside over the field's own, n spacings an edge.
double error_of(const std::string& quadrature, const std::string& dimension, int n) {
  const bool solid = dimension == "3";
  // u = a (sin px sin py, cos px cos py) with p = pi has the divergence zero; a quadratic part has not.
  // sigma = kappa tr I + 2 mu dev, f = -div sigma.
  const std::string ux = "1e-3*(sin(pi*x)*sin(pi*y) + x*x)", uy = "1e-3*(cos(pi*x)*cos(pi*y) + x*y)";
  const double d = solid ? 3 : 2;
  // laplacian u = a (-2 pi^2 s s + 2, -2 pi^2 c c), grad div u = a (3, 0), div of the quadratic part 3 x.
  const double along = kappa + shear * (1 - 2 / d);
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
horizon: {{ratio: 3.015}}
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
                                       solid ? ", z: 0" : "");
  const deck::Deck deck = deck_of(yaml);
  const RunResult run = run_deck(deck);
  EXPECT_EQ(run.stopped, "");
  const mechanics::Scene scene = mechanics::build_scene(deck, Communicator(MPI_COMM_SELF));
  double error = 0, size = 0;
  for (LocalIndex i = 0; i < scene.owned(); ++i) {
    const deck::Point x = scene.body().position3(i);
    bool within = true;
    for (int c = 0; c < static_cast<int>(d); ++c) within = within && x[c] > 0.3 && x[c] < 0.7;
    if (!within) continue;
    const std::vector<double>& u = run.displacement.at(scene.body().id[i]);
    const double exact[3] = {1e-3 * (std::sin(circle * x[0]) * std::sin(circle * x[1]) + x[0] * x[0]),
                             1e-3 * (std::cos(circle * x[0]) * std::cos(circle * x[1]) + x[0] * x[1]), 0};
    for (std::size_t c = 0; c < u.size(); ++c) {
      error += std::pow(u[c] - exact[c], 2);
      size += exact[c] * exact[c];
    }
  }
  return std::sqrt(error / size);
}

double order_of(const std::string& quadrature, const std::string& dimension, int coarse, int fine) {
  const double first = error_of(quadrature, dimension, coarse), second = error_of(quadrature, dimension, fine);
  const double order = std::log(first / second) / std::log(static_cast<double>(fine) / coarse);
  std::printf("%s, %s: error %.3e at 1/%d, %.3e at 1/%d, order %.2f\n", dimension.c_str(), quadrature.c_str(), first,
              coarse, second, fine, order);
  return order;
}

TEST(Manufactured, ConvergesWithTheHorizon) {
  EXPECT_GE(order_of("position-aware", "plane-strain", 40, 80), 1.9);
  EXPECT_GE(order_of("position-aware", "plane-stress", 40, 80), 1.9);
  EXPECT_GE(order_of("position-aware", "3", 20, 40), 1.9);
}

TEST(Manufactured, DoesNotWithoutIsotropicWeights) {  // what the page on accuracy says of whole neighbours
  EXPECT_LE(order_of("whole", "plane-strain", 40, 80), 0.5);
}

}  // namespace
}  // namespace perinox::testing
