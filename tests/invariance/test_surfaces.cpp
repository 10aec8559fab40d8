/// Tests volumes and surfaces: sums that no lattice and no direction may change.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <numeric>

#include "lot.hpp"
#include "support/measured.hpp"
#include "support/runs.hpp"
#include "workshop.hpp"

namespace perinox::invariance {
namespace {

double volume_of(const std::string& dimension, const std::string& shape) {
  const deck::Deck deck = test::deck_of(fmt::format(R"(
dimension: {}
body: [{{name: a, shape: {}, spacing: 1, material: m}}]
horizon: {{ratio: 2.015}}
materials: {{m: {{model: elastic, young_modulus: 1000, poisson_ratio: 0.3}}}}
boundary: []
)",
                                                       dimension, shape));
  const mechanics::Scene scene = mechanics::build_scene(deck, Communicator(MPI_COMM_SELF));
  return std::accumulate(scene.body().volume.begin(), scene.body().volume.begin() + scene.owned(), 0.0);
}

std::string box(const Vector3& min, const Vector3& max, bool solid) {
  const auto point = [&](const Vector3& x) {
    return solid ? fmt::format("[{}, {}, {}]", digits(x[0]), digits(x[1]), digits(x[2]))
                 : fmt::format("[{}, {}]", digits(x[0]), digits(x[1]));
  };
  return fmt::format("{{box: {{min: {}, max: {}}}}}", point(min), point(max));
}

/// A part is cut out of a block wherever it lies against the lattice, and put back by a union.
TEST(Surfaces, VolumesOfPlaneFacedShapesAdd) {
  Lot lot(3);
  for (int trial = 0; trial < 12; ++trial) {
    const bool solid = trial % 2 == 0;
    const std::string dimension = solid ? "3" : "plane-strain";
    const Vector3 size{8 + lot.between(-0.5, 0.5), 7 + lot.between(-0.5, 0.5), 6 + lot.between(-0.5, 0.5)};
    const double whole = size[0] * size[1] * (solid ? size[2] : 1);
    const std::string block = box({}, size, solid);
    EXPECT_LE(test::measured("volume of a block", std::abs(volume_of(dimension, block) / whole - 1)), 1e-12);
    Vector3 low{}, high{};
    double part = 1;
    for (std::size_t c = 0; c < (solid ? 3U : 2U); ++c) {
      low[c] = 1.5 + lot.between(0, 1);
      high[c] = low[c] + 2 + lot.between(0, 1);
      part *= high[c] - low[c];
    }
    const std::string rest = fmt::format("{{difference: [{}, {}]}}", block, box(low, high, solid));
    EXPECT_LE(
        test::measured("volume of a block without a part", std::abs(volume_of(dimension, rest) / (whole - part) - 1)),
        1e-12);
    const std::string again = fmt::format("{{union: [{}, {}]}}", rest, box(low, high, solid));
    EXPECT_LE(test::measured("volume of the block and the part", std::abs(volume_of(dimension, again) / whole - 1)),
              1e-12);
  }
}

struct Closed {
  std::string name, dimension, bodies;
};

std::vector<Closed> closed_surfaces() {
  const std::string two = "{name: b, shape: {box: {min: [6, 0], max: [12, 6]}}, spacing: 0.5, material: m}";
  return {
      {"two spacings that meet", "plane-stress",
       "{name: a, shape: {box: {min: [0, 0], max: [6, 6]}}, spacing: 1, material: m}, " + two},
      {"two spacings that meet in part", "plane-strain",
       "{name: a, shape: {box: {min: [0, 1.3], max: [6, 7.1]}}, spacing: 1, material: m}, " + two},
      {"ring", "plane-stress",
       "{name: a, shape: {difference: [{sphere: {center: [0.2, 0.1], radius: 7.3}}, {sphere: {center: [0.9, -0.4], "
       "radius: "
       "3.1}}]}, spacing: 1, material: m}"},
      {"ball", "3", "{name: a, shape: {sphere: {center: [0.2, 0.1, 0], radius: 4.3}}, spacing: 1, material: m}"},
      {"slanted cylinder", "3",
       "{name: a, shape: {cylinder: {start: [0, 0, 0], end: [4, 3, 6], radius: 3.1}}, spacing: 1, material: m}"},
      {"block with a cut", "3",
       "{name: a, shape: {difference: [{box: {min: [0, 0, 0], max: [7.3, 6.2, 5.6]}}, {box: {min: [3.1, 2.7, -1], max: "
       "[4.9, 9, 9]}}]}, spacing: 1, material: m}"},
      {"block and ball", "3",
       "{name: a, shape: {union: [{box: {min: [0, 0, 0], max: [6, 6, 4]}}, {sphere: {center: [3.2, 2.9, 4], radius: "
       "2.7}}]}, "
       "spacing: 1, material: m}"},
  };
}

/// Everything is held, so the reactions are the loads.
TEST(Surfaces, PressureOnAClosedSurfaceNetsZero) {
  const std::vector<Closed> all = closed_surfaces();
  for (std::size_t k = 0; k < all.size(); ++k) {
    const Closed& closed = all[k];
    const bool solid = closed.dimension == "3";
    const Answer answer =
        answer_of(fmt::format(R"(
dimension: {}
body: [{}]
horizon: {{length: 3.015}}
materials: {{m: {{model: elastic, young_modulus: 1000, poisson_ratio: 0.3}}}}
boundary:
  - {{set: all, displacement: {}}}
  - {{set: all, pressure: 1}}
steps: {{end: 1, count: 1}}
history: [{{name: x, reaction: all, component: x}}, {{name: y, reaction: all, component: y}}{}]
)",
                              closed.dimension, closed.bodies, solid ? "{x: 0, y: 0, z: 0}" : "{x: 0, y: 0}",
                              solid ? ", {name: z, reaction: all, component: z}" : ""),
                  ".", MPI_COMM_SELF);
    ASSERT_EQ(answer.refused + answer.stopped, "") << closed.name;
    // This is the surface of a square or cube of the same volume. The other surfaces have that much or more, except
    // round ones.
    const double volume = std::accumulate(answer.volume.begin(), answer.volume.end(), 0.0);
    const double loads = 2 * answer.dimension * std::pow(volume, 1 - 1.0 / answer.dimension);
    for (const double net : answer.rows.back().reactions)
      EXPECT_LE(test::measured("net pressure over all of it, " + closed.name, std::abs(net) / loads), 1e-12);  // 3e-13
  }
}

/// Under a linear field the mean movement is that of the middle, whatever the spacings of the parts.
TEST(Surfaces, TheMeanMovementIsByVolume) {
  for (const double finer : {1.0, 0.5, 0.25}) {
    const Answer answer = answer_of(fmt::format(R"(
dimension: plane-stress
body:
  - {{name: a, shape: {{box: {{min: [0, 0], max: [6, 6]}}}}, spacing: 1, material: m}}
  - {{name: b, shape: {{box: {{min: [6, 0], max: [12, 6]}}}}, spacing: {}, material: m}}
horizon: {{length: 3.015}}
materials: {{m: {{model: elastic, young_modulus: 1000, poisson_ratio: 0.3}}}}
boundary: [{{set: all, displacement: {{x: "0.01*x*t", y: 0}}}}]
steps: {{end: 1, count: 1}}
history: [{{name: mean, displacement: all, component: x}}]
)",
                                                finer),
                                    ".", MPI_COMM_SELF);
    ASSERT_EQ(answer.refused + answer.stopped, "");
    const double mean = answer.rows.back().movements.front();
    EXPECT_LE(test::measured("mean of 0.01 x over 0 to 12, less 0.06", std::abs(mean - 0.06)), 1e-15);
  }
}

}  // namespace
}  // namespace perinox::invariance
