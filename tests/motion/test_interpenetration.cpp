/// Faces that no bond joins and that pass into each other: what is seen, and what is not mistaken for it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "perinox/motion/interpenetration.hpp"
#include "support/runs.hpp"

namespace perinox::test {
namespace {

using Point = std::array<double, 3>;
using Motion = std::function<Point(const Point&)>;  ///< place as deformed

/// A scene that has open faces, and the motions that are tried on it.
struct Faces {
  explicit Faces(const std::string& yaml)
      : deck(deck_of(yaml)), scene(mechanics::build_scene(deck, Communicator(MPI_COMM_SELF))), watch(scene) {}
  motion::Overlap after(const Motion& motion) {
    const int d = scene.dimension();
    std::vector<double> displacement(scene.local_unknowns());
    for (LocalIndex i = 0; i < scene.local(); ++i) {
      const Point x = scene.body().position3(i), y = motion(x);
      for (int c = 0; c < d; ++c) displacement[static_cast<std::size_t>(i) * d + c] = y[c] - x[c];
    }
    return watch.measure(displacement, {});
  }
  deck::Deck deck;
  mechanics::Scene scene;
  motion::Interpenetration watch;
};

constexpr const char* rest = R"(
horizon: {length: 3.015}
materials: {m: {model: elastic, young_modulus: 1000, poisson_ratio: 0.3}}
boundary: [{set: all, displacement: {x: 0}}]
steps: {end: 1, count: 1}
)";

/// Bodies that meet, or a crack, at y = 10.
struct Case {
  const char* name;
  std::string yaml;
  double spacing;
};

std::vector<Case> cases() {
  const std::string whole = "body: [{name: a, shape: {box: {min: [0, 0], max: [20, 20]}}, spacing: 1, material: m}]\n";
  const std::string halves =
      "bond_bodies: false\nbody:\n"
      "  - {name: a, shape: {box: {min: [0, 0], max: [20, 10]}}, spacing: 1, material: m}\n"
      "  - {name: b, shape: {box: {min: [0, 10], max: [20, 20]}}, spacing: 1, material: m}\n";
  const std::string solid =
      "body: [{name: a, shape: {box: {min: [0, 4, 0], max: [10, 16, 10]}}, spacing: 1, material: m}]\n";
  return {
      {"crack through a plate",
       "dimension: plane-stress\n" + whole + "cracks: [{segment: {start: [-1, 10], end: [21, 10]}}]\n" + rest, 1},
      {"crack that ends in a plate",
       "dimension: plane-stress\n" + whole + "cracks: [{segment: {start: [-1, 10], end: [14, 10]}}]\n" + rest, 1},
      {"two bodies", "dimension: plane-stress\n" + halves + rest, 1},
      {"crack through a block",
       "dimension: 3\n" + solid +
           "cracks: [{rectangle: {corner: [-1, 10, -1], edge1: [12, 0, 0], edge2: [0, 0, 12]}}]\n" + rest,
       1},
  };
}

Point turn(const Point& y, double angle) {
  return {std::cos(angle) * y[0] - std::sin(angle) * y[1] + 3, std::sin(angle) * y[0] + std::cos(angle) * y[1] - 5,
          y[2]};
}

TEST(Interpenetration, DepthIsThatByWhichTheFacesHaveMovedIntoEachOther) {
  for (const Case& c : cases()) {
    if (std::string(c.name) == "crack that ends in a plate") continue;
    Faces faces(c.yaml);
    for (const double depth : {0.2, 0.7, 1.0, 1.77, 2.5})
      for (const double slide : {0.0, 0.5, 1.25})
        for (const double angle : {0.0, 0.6, 2.0}) {
          const auto motion = [&](const Point& x) {
            const bool upper = x[1] > 10;
            return turn({x[0] + (upper ? slide : 0), x[1] - (upper ? depth : 0), x[2]}, angle);
          };
          const motion::Overlap found = faces.after(motion);
          EXPECT_NEAR(found.depth, depth, 1e-12) << c.name << ", slide " << slide << ", turned by " << angle;
          EXPECT_NEAR(found.spacings, depth / c.spacing, 1e-12);
          EXPECT_NEAR(found.place[1], 10, 1.01) << c.name;
        }
  }
}

TEST(Interpenetration, StrainTurningSlidingAndOpeningAreNoOverlap) {
  constexpr double slides[] = {-9.3, -0.5, 0.0, 1.25, 3.0};
  for (const Case& c : cases()) {
    Faces faces(c.yaml);
    const bool ends = std::string(c.name) == "crack that ends in a plate";
    std::size_t tried = 0;  // every slide meets every other value of the five, but not all combinations of them
    for (const double angle : {0.0, 0.6, 2.0})
      for (const double along : {-0.3, 0.0, 0.4})
        for (const double across : {-0.3, 0.0, 0.4})
          for (const double shear : {-0.5, 0.0, 0.5})
            for (const double gap : {0.0, 0.3, 5.0}) {
              const double slide = ends ? 0 : slides[tried++ % 5];
              if (ends && gap != 0) continue;
              const auto motion = [&](const Point& x) {
                const bool upper = x[1] > 10;
                const Point y{x[0] * (1 + along) + shear * x[1] + (upper ? slide : 0),
                              x[1] * (1 + across) + (upper ? gap : 0), x[2]};
                return turn(y, angle);
              };
              EXPECT_EQ(faces.after(motion).depth, 0)
                  << c.name << ": turned by " << angle << ", strain " << along << " and " << across << ", shear "
                  << shear << ", slide " << slide << ", gap " << gap;
            }
  }
}

/// A crack that opens as one does, and one that slides: K fields about the tip at (10, 10).
TEST(Interpenetration, CrackTipsThatOpenOrSlideAreNoOverlap) {
  Faces faces(cases()[1].yaml);
  for (const double size : {0.05, 0.3, 0.6})
    for (const bool opens : {true, false}) {
      const auto motion = [&](const Point& x) {
        const double rx = x[0] - 14, ry = x[1] - 10, r = std::hypot(rx, ry), a = std::atan2(ry, rx);
        const double k = 2.08, f = size * std::sqrt(r);  // k: plane stress, nu = 0.3
        const double c = std::cos(a / 2), s = std::sin(a / 2);
        if (opens) return Point{x[0] + f * c * (k - 1 + 2 * s * s) / 2, x[1] + f * s * (k + 1 - 2 * c * c) / 2, x[2]};
        return Point{x[0] + f * s * (k + 1 + 2 * c * c) / 2, x[1] - f * c * (k - 1 - 2 * s * s) / 2, x[2]};
      };
      EXPECT_EQ(faces.after(motion).depth, 0) << size << (opens ? ", opens" : ", slides");
    }
}

TEST(Interpenetration, ABodyDrivenThroughAnotherFromAfarIsSeen) {
  Faces faces(
      "dimension: plane-stress\nbond_bodies: false\nbody:\n"
      "  - {name: a, shape: {box: {min: [0, 0], max: [20, 10]}}, spacing: 1, material: m}\n"
      "  - {name: b, shape: {box: {min: [6.3, 20], max: [12.3, 26]}}, spacing: 1, material: m}\n" +
      std::string(rest));
  const auto down = [](double by) {
    return [by](const Point& x) { return Point{x[0], x[1] - (x[1] > 15 ? by : 0), x[2]}; };
  };
  for (const double by : {0.0, 5.0, 9.9, 10.0}) EXPECT_EQ(faces.after(down(by)).depth, 0) << by;
  for (const double depth : {1.0, 1.9, 3.0})
    EXPECT_NEAR(faces.after(down(10 + depth)).depth, depth, 0.01);  // 3.5e-3: at corners normals lean
}

/// Every particle of a body two or four wide is at an edge, where its family leans aside.
TEST(Interpenetration, BodiesOfAnyWidth) {
  for (const bool solid : {false, true})
    for (const int width : {1, 2, 3, 4, 5, 6})
      for (const int depth_of_it : {1, 2, 4}) {
        if (!solid && depth_of_it > 1) continue;
        if (std::min(width, depth_of_it) == 1 && (solid || width == 1)) continue;  // one particle thick: no normal
        const std::string aside = solid ? fmt::format(", {}]", depth_of_it) : "]", origin = solid ? ", 0]" : "]";
        Faces faces(fmt::format(R"(
dimension: {}
bond_bodies: false
body:
  - {{name: a, shape: {{box: {{min: [0, 4{}, max: [{}, 10{}}}}}, spacing: 1, material: m}}
  - {{name: b, shape: {{box: {{min: [0, 10{}, max: [{}, 16{}}}}}, spacing: 1, material: m}}
)",
                                solid ? "3" : "plane-stress", origin, width, aside, origin, width, aside) +
                    std::string(rest));
        for (const double depth : {0.0, 0.3, 0.8, 1.3, 1.8}) {
          const auto down = [&](const Point& x) { return Point{x[0], x[1] - (x[1] > 10 ? depth : 0), x[2]}; };
          EXPECT_NEAR(faces.after(down).depth, depth, 0.1 * depth)
              << width << " by " << depth_of_it << ", solid " << solid;
        }
      }
}

TEST(Interpenetration, StripsOneParticleThick) {
  Faces faces(
      "dimension: plane-stress\nbond_bodies: false\nbody:\n"
      "  - {name: a, shape: {box: {min: [0, 0], max: [20, 1]}}, spacing: 1, material: m}\n"
      "  - {name: b, shape: {box: {min: [0, 1], max: [20, 2]}}, spacing: 1, material: m}\n" +
      std::string(rest));
  const auto moved = [](double slide, double gap) {
    return [=](const Point& x) {
      const bool upper = x[1] > 1;
      return turn({x[0] + (upper ? slide : 0), x[1] + (upper ? gap : 0), x[2]}, 0.4);
    };
  };
  EXPECT_EQ(faces.after(moved(0, 0)).depth, 0);
  EXPECT_EQ(faces.after(moved(0.5, 0)).depth, 0);
  EXPECT_EQ(faces.after(moved(0.5, 2)).depth, 0);
  EXPECT_NEAR(faces.after(moved(0, -0.6)).depth, 0.6, 1e-12);
}

/// The case of the issue: a plate with a crack, pressed across it.
std::string pressed_plate(const std::string& crack) {
  return "dimension: plane-stress\n"
         "body: [{name: plate, shape: {box: {min: [0, 0], max: [40, 40]}}, spacing: 1, material: m}]\n"
         "horizon: {ratio: 3.015}\n"
         "materials: {m: {model: elastic, young_modulus: 1000, poisson_ratio: 0.3}}\n" +
         crack + R"(
sets:
  lo: {where: "y < 3"}
  hi: {where: "y > 37"}
  above: {where: "y > 20 && y < 21 && x > 19 && x < 21"}
  below: {where: "y > 19 && y < 20 && x > 19 && x < 21"}
boundary: [{set: lo, displacement: {x: 0, y: 0}}, {set: hi, displacement: {x: 0, y: "-2*t"}}]
steps: {end: 1, count: 5}
history:
  - {name: F, reaction: hi, component: y}
  - {name: above, displacement: above, component: y}
  - {name: below, displacement: below, component: y}
)";
}

TEST(Interpenetration, APressedPlateWithACrackSaysHowDeepItsFacesGo) {
  const deck::Deck deck = deck_of(pressed_plate("cracks: [{segment: {start: [10, 20], end: [30, 20]}}]"));
  mechanics::Scene scene = mechanics::build_scene(deck, Communicator(MPI_COMM_SELF));
  stepping::LoadStepper stepper(deck, scene);
  Recorder records;
  stepper.run(records);
  const RunResult whole = run_deck(deck_of(pressed_plate("")));
  const StepRecord& last = records.steps.back();
  const double share = last.history[0] / whole.records.steps.back().history[0];
  const double nearer = last.history[2] - last.history[1];
  ASSERT_TRUE(last.overlap);
  std::printf("pressed plate: faces overlap by %.3f, their middle has come nearer by %.3f, %.2f of the load\n",
              *last.overlap, nearer, share);
  EXPECT_NEAR(*last.overlap, nearer, 0.1);
  EXPECT_GT(*last.overlap, 1.5);
  EXPECT_FALSE(whole.records.steps.back().overlap);
  for (std::size_t k = 1; k < records.steps.size(); ++k)
    EXPECT_GT(*records.steps[k].overlap, *records.steps[k - 1].overlap);
  ASSERT_EQ(stepper.validity()->at_end().size(), 1u);
  EXPECT_THAT(stepper.validity()->at_end()[0], ::testing::HasSubstr("faces that no bond joins overlap by"));
}

TEST(Interpenetration, AnExplicitRunWithoutContactSaysItToo) {
  const std::string yaml = R"(
dimension: plane-strain
bond_bodies: false
body:
  - {name: low, shape: {box: {min: [0, 0], max: [8, 8]}}, spacing: 1, material: m}
  - {name: high, shape: {box: {min: [0, 8.5], max: [8, 16.5]}}, spacing: 1, material: m}
horizon: {length: 3.015}
materials: {m: {model: elastic, young_modulus: 1000, poisson_ratio: 0.3, density: 1}}
initial_velocity: [{set: high, velocity: {y: -1}}]
dynamics: explicit
steps: {end: 2, count: 4}
)";
  const deck::Deck deck = deck_of(yaml);
  mechanics::Scene scene = mechanics::build_scene(deck, Communicator(MPI_COMM_SELF));
  stepping::TimeStepper stepper(deck, scene);
  Recorder records;
  stepper.run(records);
  ASSERT_EQ(records.steps.size(), 4u);
  for (std::size_t k = 0; k < 4; ++k) {
    ASSERT_TRUE(records.steps[k].overlap);
    EXPECT_NEAR(*records.steps[k].overlap, 0.5 * static_cast<double>(k), 1e-9);  // nothing stops the upper one
  }
  EXPECT_EQ(stepper.validity()->at_end().size(), 1u);
  EXPECT_FALSE(deck_of(yaml, {"explicit.contact={}"}).may_overlap());
}

}  // namespace
}  // namespace perinox::test
