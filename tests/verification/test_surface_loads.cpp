/// Tractions and pressures on free surfaces: the strain they cause in the middle of a body, against Hooke's law.
#include <gtest/gtest.h>

#include <cmath>

#include "support/measured.hpp"
#include "support/runs.hpp"

namespace perinox::test {
namespace {

constexpr double young = 70e3;
constexpr double poisson = 0.3;

struct Strain {
  double xx = 0, yy = 0, zz = 0, von_mises = 0;
};

double error_of(const std::string& what, double ratio) { return test::measured(what, std::abs(ratio - 1)); }

/// Of the particles at which `inside` is true, their mean.
template <class Inside>
Strain mean_strain(const deck::Deck& deck, Inside&& inside) {
  mechanics::Scene scene = mechanics::build_scene(deck, Communicator(MPI_COMM_SELF));
  stepping::LoadStepper stepper(deck, scene);
  Recorder records;
  stepper.run(records);
  mechanics::Stress stress(scene);
  stress.evaluate(stepper.committed());
  Strain sum;
  double n = 0;
  for (LocalIndex i = 0; i < scene.owned(); ++i) {
    if (!inside(scene.body().position(i))) continue;
    const double* e = &stress.strain()[6 * static_cast<std::size_t>(i)];
    sum.xx += e[0], sum.yy += e[3], sum.zz += e[5], sum.von_mises += stress.von_mises()[i], n += 1;
  }
  return {sum.xx / n, sum.yy / n, sum.zz / n, sum.von_mises / n};
}

TEST(SurfaceLoads, ABarPulledByTractionsAtBothEnds) {
  const deck::Deck deck = deck_of(fmt::format(R"(
dimension: 3
body: [{{name: bar, shape: {{box: {{min: [-4.5, -4.5, -14.5], max: [4.5, 4.5, 14.5]}}}}, spacing: 1, material: m}}]
horizon: {{ratio: 3.015}}
deformation: small
materials: {{m: {{model: elastic, young_modulus: {}, poisson_ratio: {}}}}}
sets:
  ends: {{where: "abs(z) > 13.5"}}
  across_x: {{where: "abs(x) < 0.5"}}
  across_y: {{where: "abs(y) < 0.5"}}
  across_z: {{where: "abs(z) < 0.5"}}
boundary:
  - {{set: ends, traction: {{z: "100*t"}}, facing: [0, 0, 1]}}
  - {{set: ends, traction: {{z: "-100*t"}}, facing: [0, 0, -1]}}
  - {{set: across_x, displacement: {{x: 0}}}}
  - {{set: across_y, displacement: {{y: 0}}}}
  - {{set: across_z, displacement: {{z: 0}}}}
steps: {{end: 1, count: 1}}
)",
                                              young, poisson));
  const Strain found = mean_strain(deck, [](const double* x) { return std::abs(x[2]) < 3; });
  const double exact = 100 / young;
  EXPECT_LE(error_of("tractions: strain along a bar", found.zz / exact), 0.01);                // 0.00014
  EXPECT_LE(error_of("tractions: strain across a bar", -found.xx / (poisson * exact)), 0.03);  // 0.00045
  EXPECT_LE(error_of("tractions: von Mises stress of a bar", found.von_mises / 100), 0.01);    // 0.00005
}

double compression(const std::string& shape, const std::string& dimension, double modulus) {
  const deck::Deck deck = deck_of(fmt::format(R"(
dimension: {}
body: [{{name: all_round, shape: {}, spacing: 1, material: m}}]
horizon: {{ratio: 3.015}}
deformation: small
materials: {{m: {{model: elastic, young_modulus: {}, poisson_ratio: {}}}}}
sets:
  across_x: {{where: "abs(x) < 0.5"}}
  across_y: {{where: "abs(y) < 0.5"}}
  across_z: {{where: "abs(z) < 0.5"}}
boundary:
  - {{set: all, pressure: "100*t"}}
  - {{set: across_x, displacement: {{x: 0}}}}
  - {{set: across_y, displacement: {{y: 0}}}}
{}
steps: {{end: 1, count: 1}}
)",
                                              dimension, shape, young, poisson,
                                              dimension == "3" ? "  - {set: across_z, displacement: {z: 0}}" : ""));
  const Strain found = mean_strain(deck, [&](const double* x) {
    return std::abs(x[0]) < 4 && std::abs(x[1]) < 4 && (dimension != "3" || std::abs(x[2]) < 4);
  });
  return -modulus * (found.xx + found.yy + (dimension == "3" ? found.zz : 0)) / 100;
}

TEST(SurfaceLoads, PressureAllRound) {
  const double bulk = young / (3 * (1 - 2 * poisson));
  const double plane_bulk = young / (2 * (1 + poisson) * (1 - 2 * poisson));
  const auto error = [](const std::string& name, const std::string& shape, const std::string& dimension, double k) {
    return error_of("pressure: " + name, compression(shape, dimension, k));
  };
  // Near the surface the force of a uniform stress is not zero: the smaller the body, the more (15^3: 0.043).
  EXPECT_LE(error("cube", "{box: {min: [-12.5, -12.5, -12.5], max: [12.5, 12.5, 12.5]}}", "3", bulk), 0.01);  // 0.0039
  EXPECT_LE(error("ball", "{sphere: {center: [0, 0, 0], radius: 14.5}}", "3", bulk), 0.03);                   // 0.0250
  EXPECT_LE(error("disc", "{sphere: {center: [0, 0, 0], radius: 15.5}}", "plane-strain", plane_bulk), 0.02);  // 0.0113
}

/// Two bonded plates of different spacing, and a disc loaded on its right and its left: -1 in every direction.
TEST(SurfaceLoads, PressureOnPiecesOfTheSurface) {
  const auto stress = [](const std::string& body, const std::string& loads, auto&& inside) {
    const Strain found = mean_strain(deck_of(fmt::format(R"(
dimension: plane-stress
body: {}
horizon: {{length: 3.015}}
deformation: small
materials: {{m: {{model: elastic, young_modulus: 1000, poisson_ratio: 0.3}}}}
sets:
  low: {{where: "abs(y) < 1 && x < 1.6"}}
  right: {{where: "abs(y) < 1 && x > 10"}}
boundary:
  - {{set: low, displacement: {{y: 0}}}}
  - {{set: low, displacement: {{x: 0}}}}
  - {{set: right, displacement: {{y: 0}}}}
{}
steps: {{end: 1, count: 1}}
)",
                                                         body, loads)),
                                     inside);
    return std::pair{1000 * (found.xx + 0.3 * found.yy) / 0.91, 1000 * (found.yy + 0.3 * found.xx) / 0.91};
  };
  const std::string plates =
      "[{name: a, shape: {box: {min: [0, 0], max: [6, 6]}}, spacing: 1, material: m}, "
      "{name: b, shape: {box: {min: [6, 0], max: [12, 6]}}, spacing: 0.5, material: m}]";
  for (const bool coarse : {true, false}) {
    const auto [xx, yy] =
        stress(plates, "  - {set: all, pressure: 1}", [&](const double* x) { return (x[0] < 6) == coarse; });
    EXPECT_LE(error_of("pressure: two plates, along", -xx), 0.1);
    EXPECT_LE(error_of("pressure: two plates, across", -yy), 0.1);
  }
  const std::string disc = "[{name: a, shape: {sphere: {center: [11, 0], radius: 10.7}}, spacing: 1, material: m}]";
  const auto [xx, yy] =
      stress(disc, "  - {set: all, pressure: 1, facing: [1, 0]}\n  - {set: all, pressure: 1, facing: [-1, 0]}",
             [](const double* x) { return std::hypot(x[0] - 11, x[1]) < 5; });
  EXPECT_LE(error_of("pressure: disc from right and left, along", -xx), 0.03);
  EXPECT_LE(error_of("pressure: disc from right and left, across", -yy), 0.03);
}

}  // namespace
}  // namespace perinox::test
