/// Bars with free sides under tension: Young's modulus from the pull and the strain of the middle, where it is uniform,
/// and Poisson's ratio from the line through the lateral displacements there.
#include <gtest/gtest.h>

#include "support/particles.hpp"
#include "support/rotated_lattice.hpp"
#include "support/verification.hpp"

namespace perinox::test {
namespace {

constexpr double young = 68.9e3;
constexpr double poisson = 0.33;

struct Found {
  double young = 0, poisson = 0;  ///< relative errors
};

/// Bars of one kind of filling; all are four times as long as wide.
class Bars {
 public:
  /// degrees: of the lattice against the bar, about y. jitter: of every coordinate, over the spacing.
  explicit Bars(double degrees = 0, double jitter = 0)
      : degrees_(degrees),
        jitter_(jitter),
        young_("bars", "Young's modulus" + label(degrees, jitter), "input"),
        poisson_("bars", "Poisson's ratio" + label(degrees, jitter), "input") {}

  Found errors(const std::string& quadrature, int width) {
    const BarCloud cloud(width, 4 * width, degrees_, jitter_);
    const double half = width / 2.0, length = 4 * width;
    const bool lattice = degrees_ == 0 && jitter_ == 0;
    const std::string box = fmt::format("{{box: {{min: [{0}, {0}, 0], max: [{1}, {1}, {2}]}}}}", -half, half, length);
    const Solution solution = solve_to_end(fmt::format(
        R"yaml(
dimension: 3
body: [{{name: bar, shape: {}, spacing: 1, material: aluminium}}]
horizon: {{length: 3.015}}
quadrature: {}
deformation: small
materials: {{aluminium: {{model: elastic, young_modulus: {}, poisson_ratio: {}}}}}
sets: {{foot: {{where: "z < 3"}}, head: {{where: "z > {}"}}}}
boundary:
  - {{set: foot, displacement: {{x: 0, y: 0, z: 0}}}}
  - {{set: head, displacement: {{x: 0, y: 0, z: "1e-3*{}*t"}}}}
steps: {{end: 1, count: 1}}
solver: {{newton: {{tolerance: 1e-10}}}}
)yaml",
        lattice ? box : cloud.shape(), quadrature, young, poisson, length - 3, length));
    const auto middle = [&](const Particle& p) { return std::abs(p.x[2] - length / 2) < length / 6; };
    const auto head = [&](const Particle& p) { return p.x[2] > length - 3; };
    const auto all = [](const Particle&) { return true; };
    const double strain = slope(
        solution, middle, [](auto& p) { return p.x[2]; }, [](auto& p) { return p.u[2]; });
    const double across = slope(
        solution, middle, [](auto& p) { return p.x[0]; }, [](auto& p) { return p.u[0]; });
    const double pull = total(solution, head, [](auto& p) { return p.pull[2]; });
    const double section = total(solution, all, [](auto& p) { return p.volume; }) / length;
    const std::string resolution = fmt::format("{0} x {0} x {1} h", width, length);
    Found found;
    found.young = young_.converging(quadrature, resolution, solution.particles.size(),
                                    pull / section / strain / young - 1, width);
    found.poisson =
        poisson_.converging(quadrature, resolution, solution.particles.size(), -across / strain / poisson - 1, width);
    return found;
  }

 private:
  static std::string label(double degrees, double jitter) {
    if (jitter > 0) return fmt::format(", jittered by {} h", jitter);
    return degrees == 0 ? "" : fmt::format(", lattice turned by {} degrees", degrees);
  }

  double degrees_, jitter_;
  Verification young_, poisson_;
};

TEST(FreeSurfaces, Bar) {
  Bars bars;
  for (const int width : resolutions({8, 12}, {16, 24})) {
    const Found found = bars.errors("position-aware", width);
    EXPECT_LE(std::abs(found.young), 0.01);     // 0.0031, 0.0022
    EXPECT_LE(std::abs(found.poisson), 0.015);  // 0.0128, over the goal of 1 %, 0.0087
  }
  EXPECT_NEAR(bars.errors("whole", 8).young, 0.048, 0.005);
  EXPECT_NEAR(bars.errors("partial-volume", 8).young, 0.236, 0.005);  // docs/accuracy.md
  for (const int width : resolutions({12}, {16, 24})) bars.errors("whole", width);
}

TEST(FreeSurfaces, BarOfATurnedLattice) {
  // The sides are ragged: what counts as the section is the volume over the length. Measured: 22 degrees 0.0039 and
  // 0.0149, over the goal of 1 %, 45 degrees 0.0010 and 0.0091.
  for (const double degrees : {22.0, 45.0}) {  // 45: the bar lies along [110]
    Bars bars(degrees);
    for (const int width : resolutions({8, 12}, {16, 24}))
      EXPECT_LE(std::abs(bars.errors("position-aware", width).young), 0.018);
    EXPECT_GT(bars.errors("whole", 8).young, 0.1);  // 0.123, 0.272
    for (const int width : resolutions({}, {12, 16, 24})) bars.errors("whole", width);
  }
}

TEST(FreeSurfaces, JitteredBar) {
  Bars bars(0, 0.2);
  for (const int width : resolutions({8}, {12, 16, 24}))
    EXPECT_LE(std::abs(bars.errors("position-aware", width).young), 0.025);  // 0.0188, over the goal of 1 %
  EXPECT_GT(bars.errors("whole", 8).young, 0.05);                            // 0.115
  for (const int width : resolutions({}, {12, 16, 24})) bars.errors("whole", width);
}

}  // namespace
}  // namespace perinox::test
