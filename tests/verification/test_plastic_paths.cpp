/// Uniform strain paths of an elastic-plastic cube, every particle prescribed, against classical J2 plasticity with
/// isotropic hardening (radial return; Simo & Hughes, Computational Inelasticity, box 3.2).
#include <gtest/gtest.h>

#include "support/particles.hpp"
#include "support/verification.hpp"

namespace perinox::test {
namespace {

constexpr double bulk = 67.5e3;
constexpr double shear = 25.9e3;
constexpr double yield = 117.3;
constexpr double hardening = 800;  ///< in shear

using Tensor = std::array<double, 6>;  ///< xx, yy, zz and sqrt 2 times yz, xz, xy: products are sums

/// One point of classical J2, backward Euler.
class Classical {
 public:
  void go_to(const Tensor& strain) {
    const double trace = strain[0] + strain[1] + strain[2];
    Tensor trial{};
    double norm2 = 0;
    for (std::size_t c = 0; c < 6; ++c) {
      trial[c] = 2 * shear * (strain[c] - (c < 3 ? trace / 3 : 0) - plastic_[c]);
      norm2 += trial[c] * trial[c];
    }
    const double t = std::sqrt(norm2 / 2), flow = std::max(0.0, (t - tau_) / (shear + hardening));
    for (std::size_t c = 0; c < 6 && flow > 0; ++c) plastic_[c] += flow * trial[c] / (2 * t);
    dissipated_ += (tau_ + hardening * flow / 2) * flow;
    tau_ += hardening * flow;
    equivalent_ += flow / std::sqrt(3.0);
    const double remaining = t - shear * flow;
    stored_ = bulk * trace * trace / 2 + remaining * remaining / (2 * shear);
  }
  double stored() const { return stored_; }
  double dissipated() const { return dissipated_; }
  double equivalent() const { return equivalent_; }

 private:
  Tensor plastic_{};
  double tau_ = yield, stored_ = 0, dissipated_ = 0, equivalent_ = 0;
};

/// A strain as a deck and as this test have it: amplitude times formulas of t.
struct Path {
  std::string name;
  double end;
  std::string ux, uy, uz;
  std::function<Tensor(double)> strain;
};

constexpr double amplitude = 3 * yield / shear;  ///< three times the shear strain of first yield

double there_and_back(double t) { return t < 1 ? t : t < 3 ? 2 - t : t - 4; }

std::vector<Path> paths() {
  const std::string wave = "(t < 1 ? t : t < 3 ? 2 - t : t - 4)";
  const double root = std::sqrt(0.5);  // sqrt 2 times half the shear strain
  return {{"pure shear", 1, "a*t*y", "0", "0", [=](double t) { return Tensor{0, 0, 0, 0, 0, amplitude * t * root}; }},
          {"cyclic shear", 4, "a*" + wave + "*z", "0", "0",
           [=](double t) { return Tensor{0, 0, 0, 0, amplitude * there_and_back(t) * root, 0}; }},
          {"cyclic shear across the axes", 4, "a/2*" + wave + "*x", "-a/2*" + wave + "*y", "0",
           [=](double t) {
             const double s = amplitude / 2 * there_and_back(t);
             return Tensor{s, -s, 0, 0, 0, 0};
           }},
          {"uniaxial strain", 1, "a*t*x", "0", "0", [=](double t) { return Tensor{amplitude * t, 0, 0, 0, 0, 0}; }},
          {"shear, then a turn into tension", 2, "a*min(t,1)*y + a*max(t-1,0)*x", "-a/2*max(t-1,0)*y",
           "-a/2*max(t-1,0)*z", [=](double t) {
             const double s = amplitude * std::max(t - 1, 0.0);
             return Tensor{s, -s / 2, -s / 2, 0, 0, amplitude * std::min(t, 1.0) * root};
           }}};
}

/// Largest difference of the stored and dissipated energy over the path, over the largest of their sum; the equivalent
/// plastic strain at the end, at the worst particle.
double path_error(const Path& path, const std::string& quadrature) {
  Verification table("plastic paths", path.name, "J2, radial return");
  const int n = 8;
  const auto formula = [](std::string text) {
    for (std::size_t at = text.find('a'); at != std::string::npos; at = text.find('a', at + 1)) {
      if (at > 0 && std::isalpha(text[at - 1])) continue;  // of max
      if (at + 1 < text.size() && std::isalpha(text[at + 1])) continue;
      text.replace(at, 1, fmt::format("{:.17g}", amplitude));
    }
    return text;
  };
  const Solution solution = solve_to_end(fmt::format(
      R"yaml(
dimension: 3
body: [{{name: cube, shape: {{box: {{min: [0, 0, 0], max: [{0}, {0}, {0}]}}}}, spacing: 1, material: m}}]
horizon: {{length: 3.015}}
quadrature: {1}
deformation: small
materials:
  m:
    model: elastic-plastic
    bulk_modulus: {2}
    shear_modulus: {3}
    yield_stress: {{shear: {4}}}
    hardening_modulus: {{shear: {5}}}
boundary:
  - set: all
    displacement: {{x: "{6}", y: "{7}", z: "{8}"}}
steps: {{end: {9}, count: {10}}}
)yaml",
      n, quadrature, bulk, shear, yield, hardening, formula(path.ux), formula(path.uy), formula(path.uz), path.end,
      static_cast<int>(10 * path.end)));
  Classical point;
  double difference = 0, largest = 0;
  for (const Step& step : solution.steps) {
    point.go_to(path.strain(step.t));
    const double volume = n * n * n;
    difference = std::max({difference, std::abs(step.stored / volume - point.stored()),
                           std::abs(step.dissipated / volume - point.dissipated())});
    largest = std::max(largest, point.stored() + point.dissipated());
  }
  EXPECT_EQ(solution.steps.size(), 10 * path.end);
  EXPECT_GT(point.equivalent(), 1e-3);
  double strain = 0;
  for (const Particle& particle : solution.particles)
    strain = std::max(strain, std::abs(particle.equivalent_plastic_strain / point.equivalent() - 1));
  return table.row(quadrature, fmt::format("{0} x {0} x {0}", n), solution.particles.size(),
                   std::max(difference / largest, strain));
}

TEST(PlasticPaths, AreThoseOfClassicalPlasticity) {
  for (const Path& path : paths()) {
    EXPECT_LE(path_error(path, "position-aware"), 1e-10);  // 6e-15
    EXPECT_GT(path_error(path, "whole"), 0.1);             // of free surfaces and the lattice; 0.19 to 0.54
  }
}

}  // namespace
}  // namespace perinox::test
