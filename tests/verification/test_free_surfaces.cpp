/// Bars with free sides under tension: Young's modulus from the pull and the strain of the middle, where it is uniform.
#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <random>

#include "support/measured.hpp"
#include "support/runs.hpp"

namespace perinox::testing {
namespace {

constexpr double young = 68.9e3;
constexpr int length = 32;

/// A bar of width x width x length spacings; jitter: of every particle that has a whole spacing around it.
std::string shape_of(int width, double jitter, const std::string& file) {
  if (jitter == 0) return fmt::format("{{box: {{min: [0, 0, 0], max: [{0}, {0}, {1}]}}}}", width, length);
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> step(-jitter, jitter);
  std::ofstream out(file);
  out.precision(17);
  out << "x,y,z,volume\n";
  for (int z = 0; z < length; ++z)
    for (int y = 0; y < width; ++y)
      for (int x = 0; x < width; ++x) {
        out << x + 0.5 + step(generator) << ',' << y + 0.5 + step(generator) << ',';
        out << z + 0.5 + step(generator) << ",1\n";
      }
  return "{file: " + file + "}";
}

double young_modulus(const std::string& quadrature, int width, double jitter = 0) {
  const std::string file = ::testing::TempDir() + "free_bar.csv";
  const std::string yaml = fmt::format(R"(
dimension: 3
body: [{{name: bar, shape: {}, spacing: 1, material: aluminium}}]
horizon: {{length: 3.015}}
quadrature: {}
deformation: small
materials: {{aluminium: {{model: elastic, young_modulus: {}, poisson_ratio: 0.33}}}}
sets: {{foot: {{where: "z < 3"}}, head: {{where: "z > {}"}}}}
boundary:
  - {{set: foot, displacement: {{x: 0, y: 0, z: 0}}}}
  - {{set: head, displacement: {{x: 0, y: 0, z: "0.032*t"}}}}
steps: {{end: 1, count: 1}}
solver: {{newton: {{tolerance: 1e-10}}}}
)",
                                       shape_of(width, jitter, file), quadrature, young, length - 3);
  const deck::Deck deck = deck_of(yaml);
  const RunResult run = run_deck(deck);
  EXPECT_EQ(run.stopped, "");
  const mechanics::Scene scene = mechanics::build_scene(deck, Communicator(MPI_COMM_SELF));
  // A line through the axial displacement of the middle third.
  double n = 0, z1 = 0, u1 = 0, z2 = 0, zu = 0, pull = 0;
  for (LocalIndex i = 0; i < scene.owned(); ++i) {
    const double z = scene.body().position(i)[2], u = run.displacement.at(scene.body().id[i])[2];
    if (z > length - 3) pull -= run.force.at(scene.body().id[i])[2];
    if (z < length / 3.0 || z > 2 * length / 3.0) continue;
    n += 1, z1 += z, u1 += u, z2 += z * z, zu += z * u;
  }
  const double strain = (n * zu - z1 * u1) / (n * z2 - z1 * z1);
  if (jitter > 0) std::remove(file.c_str());
  return pull / (width * width) / strain;
}

double error_of(const std::string& quadrature, int width, double jitter = 0) {
  const double error = young_modulus(quadrature, width, jitter) / young - 1;
  return test::measured(fmt::format("free bar: E, {} {}{}", quadrature, width, jitter > 0 ? " jittered" : ""), error);
}

TEST(FreeSurfaces, YoungsModulusOfABar) {
  EXPECT_LE(std::abs(error_of("position-aware", 8)), 0.01);        // -0.0031
  EXPECT_LE(std::abs(error_of("position-aware", 12)), 0.01);       // -0.0043
  EXPECT_LE(std::abs(error_of("position-aware", 8, 0.2)), 0.025);  // -0.0178
}

TEST(FreeSurfaces, IsWrongWithoutTheFit) {  // what the page on accuracy says of the other quadratures
  EXPECT_NEAR(error_of("whole", 8), 0.048, 0.005);
  EXPECT_NEAR(error_of("partial-volume", 8), 0.236, 0.005);
  EXPECT_GT(error_of("whole", 8, 0.2), 0.05);
}

}  // namespace
}  // namespace perinox::testing
