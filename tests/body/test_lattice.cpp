/// Tests shapes and the lattices in them: where particles are, how many, what is refused.
#include <cmath>
#include <limits>
#include <set>

#include "body/lattice.hpp"
#include "perinox/body/shape.hpp"
#include "support/bodies.hpp"

namespace perinox::body {
namespace {

using namespace fixture;
using deck::Point;
using ::testing::HasSubstr;
using ::testing::StartsWith;

const double kPi = std::acos(-1.0);

Body body_of(const deck::Deck& deck) { return build_body(deck); }

TEST(Lattice, BoxIsCellCentresInLexicographicOrder) {
  const Body body = body_of(deck_of(deck::Box{{1, 2, 3}, {4, 4, 4}}));
  ASSERT_EQ(body.owned, 3 * 2 * 1);
  const std::vector<Point> expected = {{1.5, 2.5, 3.5}, {2.5, 2.5, 3.5}, {3.5, 2.5, 3.5},
                                       {1.5, 3.5, 3.5}, {2.5, 3.5, 3.5}, {3.5, 3.5, 3.5}};
  for (int i = 0; i < body.owned; ++i) {
    EXPECT_EQ(body.id[i], i);
    EXPECT_EQ(body.position3(i), expected[i]);
    EXPECT_EQ(body.volume[i], 1.0);
  }
  EXPECT_EQ(body.ghosts, 0);
  EXPECT_EQ(body.total, 6);
}

TEST(Lattice, LengthThatIsNoMultipleOfTheSpacingIsCentred) {
  const Body body = body_of(deck_of(deck::Box{{0, 0, 0}, {10, 3, 3}}, deck::Dimension::three, 3));
  ASSERT_EQ(body.owned, 3);  // round(10 / 3), once across
  EXPECT_DOUBLE_EQ(body.position(0)[0], 2);
  EXPECT_DOUBLE_EQ(body.position(1)[0], 5);
  EXPECT_DOUBLE_EQ(body.position(2)[0], 8);
  EXPECT_DOUBLE_EQ(body.volume[0], 27);
}

/// Decimal spacings are not exact in binary, but no layer may be lost or gained. Edge over spacing is whole here.
TEST(Lattice, BoxKeepsEveryCell) {
  for (const double spacing : {0.1, 0.3, 0.7, 1e-3 / 3, 1e7 / 3, 0.123456789}) {
    for (const int cells : {1, 2, 7, 20}) {
      const double far = 1000 * spacing;  // away from the origin
      const Body body =
          body_of(deck_of(deck::Box{{far, -far, 0}, {far + cells * spacing, -far + cells * spacing, cells * spacing}},
                          deck::Dimension::three, spacing));
      EXPECT_EQ(body.total, cells * cells * cells) << spacing << " " << cells;
    }
  }
}

TEST(Lattice, ThinnerThanTheSpacingIsOneLayer) {
  EXPECT_EQ(body_of(deck_of(deck::Box{{0, 0, 0}, {5, 5, 0.01}})).total, 25);
}

TEST(Lattice, FlatBodiesIgnoreThirdCoordinateAndHaveAreas) {
  const Body body = body_of(square(4, 0.5));
  EXPECT_EQ(body.dimension, 2);
  EXPECT_EQ(body.total, 64);
  EXPECT_EQ(body.reference.size(), 128U);
  EXPECT_EQ(body.volume[7], 0.25);
  EXPECT_EQ(body.position3(63), (Point{3.75, 3.75, 0}));
}

/// Compares the volume of the particles with the exact one. Measured relative errors stand beside the tolerance.
TEST(Lattice, VolumesOfShapes) {
  struct Case {
    const char* name;
    deck::Deck deck;
    double exact, tolerance;
  };
  const deck::Point origin{0, 0, 0};
  const auto flat = deck::Dimension::plane_stress;
  const auto solid = deck::Dimension::three;
  const auto ball = shape_of(deck::Sphere{origin, 10});
  const auto block = shape_of(deck::Box{{-10, -10, -10}, {10, 10, 10}});
  const std::vector<Case> cases = {
      {"ball", deck_of(deck::Sphere{origin, 10}), 4.0 / 3 * kPi * 1000, 2e-2},                   // 8.4e-3
      {"disc", deck_of(deck::Sphere{origin, 10}, flat, 0.5), kPi * 100, 2e-2},                   // 5.9e-3
      {"cylinder", deck_of(deck::Cylinder{{0, 0, 0}, {0, 0, 30}, 5}), kPi * 25 * 30, 4e-2},      // 1.9e-2
      {"skew cylinder", deck_of(deck::Cylinder{origin, {20, 20, 10}, 8}), kPi * 64 * 30, 4e-2},  // 1.6e-2
      {"plate", deck_of(deck::PlateWithHole{{0, 0, 0}, {20, 20, 4}, {10, 10, 0}, 5}), 4 * (400 - kPi * 25),
       2e-2},  // 4.5e-3
      {"flat plate", deck_of(deck::PlateWithHole{{0, 0, 0}, {20, 10, 0}, {10, 5, 0}, 3}, flat, 0.25), 200 - kPi * 9,
       5e-3},                                                                                           // 1.6e-3
      {"cube less ball", deck_of(deck::Difference{{block, ball}}), 8000 - 4.0 / 3 * kPi * 1000, 2e-2},  // 9.2e-3
      {"ball and cube", deck_of(deck::Union{{block, ball}}), 8000, 1e-12},                              // 0
      {"two balls", deck_of(deck::Union{{ball, shape_of(deck::Sphere{{30, 0, 0}, 10})}}, solid),
       2 * 4.0 / 3 * kPi * 1000, 2e-2},  // 8.4e-3
  };
  for (const Case& one : cases) {
    const Body body = body_of(one.deck);
    double volume = 0;
    for (const double v : body.volume) volume += v;
    std::printf("%s: relative error of volume %.1e\n", one.name, volume / one.exact - 1);
    EXPECT_NEAR(volume / one.exact, 1, one.tolerance) << one.name;
  }
}

/// Centres on the very surface count alike on all sides, however coordinates are rounded.
TEST(Lattice, SymmetricShapesHaveSymmetricParticles) {
  const Body body = body_of(deck_of(deck::Sphere{{0.1, 0.1, 0}, 2.5}, deck::Dimension::plane_strain, 0.1));
  std::set<std::pair<long, long>> cells;
  const auto cell = [](double x) { return std::lround((x - 0.1) / 0.05); };
  for (int i = 0; i < body.owned; ++i) cells.insert({cell(body.position(i)[0]), cell(body.position(i)[1])});
  for (const auto& [x, y] : cells) {
    EXPECT_TRUE(cells.count({-x, y}) && cells.count({x, -y}) && cells.count({y, x})) << x << " " << y;
  }
}

TEST(Shape, SurfaceBelongsToTheShapeButNotToWhatItIsTakenFrom) {
  const deck::Shape block = shape_of(deck::Box{{0, 0, 0}, {1, 1, 1}});
  const deck::Shape hole = shape_of(deck::Sphere{{0, 0, 0}, 0.5});
  const deck::Shape rest = shape_of(deck::Difference{{block, hole}});
  EXPECT_TRUE(contains(block, {1, 1, 1}, 3));
  EXPECT_TRUE(contains(hole, {0.5, 0, 0}, 3));
  EXPECT_FALSE(contains(rest, {0.5, 0, 0}, 3));
  EXPECT_TRUE(contains(rest, {0.5 + 1e-6, 0, 0}, 3));
  EXPECT_FALSE(contains(block, {1 + 1e-6, 1, 1}, 3));
  EXPECT_TRUE(contains(block, {0.5, 0.5, 99}, 2));  // 2-D ignores z
}

TEST(Shape, BoundsOfATiltedCylinderTouchIt) {
  const Bounds box = bounds(shape_of(deck::Cylinder{{0, 0, 0}, {3, 4, 0}, 1}));
  EXPECT_NEAR(box.min[0], -0.8, 1e-15);
  EXPECT_NEAR(box.max[0], 3.8, 1e-15);
  EXPECT_NEAR(box.min[1], -0.6, 1e-15);
  EXPECT_NEAR(box.max[1], 4.6, 1e-15);
  EXPECT_NEAR(box.max[2], 1.0, 1e-15);
}

TEST(Lattice, Refusals) {
  struct Case {
    deck::Deck deck;
    const char* sentence;
  };
  const deck::Shape block = shape_of(deck::Box{{0, 0, 0}, {1, 1, 1}});
  const deck::Shape larger = shape_of(deck::Box{{-1, -1, -1}, {2, 2, 2}});
  deck::Deck other_material = cube(2);
  other_material.body[0].material = "ruber";
  deck::Deck two = cube(1200);
  add_body(two, "second", deck::Box{{0, 0, 0}, {1300, 1300, 1300}});
  const std::vector<Case> cases = {
      {cube(1e6), "deck.yaml:5:12: the body block would have about 1e+18 particles at spacing 1, more than 2e+09"},
      {cube(1e300), "deck.yaml:5:12: the body block would have about"},
      {deck_of(deck::Box{{0, 0, 0}, {1, -1, 1}}), "deck.yaml:5:12: the shape of the body block has no extent along y"},
      {cube(1, 0), "deck.yaml:4:5: the body block needs a spacing greater than 0"},
      {cube(1, std::numeric_limits<double>::quiet_NaN()), "deck.yaml:4:5: the body block needs a spacing"},
      {deck_of(deck::Difference{{block, larger}}, deck::Dimension::three, 0.5),
       "deck.yaml:5:12: the body block has no particles: none of the 2 x 2 x 2 centres"},
      {other_material, "deck.yaml:4:5: the body block is made of ruber, which is not one of the materials"},
      {empty_deck(), "deck.yaml: the deck has no body"},
  };
  for (const Case& one : cases) {
    EXPECT_THAT(refusal([&] { build(one.deck, Communicator(), 3.0); }), StartsWith(one.sentence));
  }
}

TEST(Body, SeveralBodiesAreNumberedOneAfterAnother) {
  deck::Deck deck = cube(2);
  add_body(deck, "lid", deck::Box{{0, 0, 2}, {2, 2, 3}}, 0.5);
  deck.materials.push_back({{}, "steel", "elastic", {}});
  deck.body[1].material = "steel";
  const Body body = body_of(deck);
  ASSERT_EQ(body.total, 8 + 32);
  for (int i = 0; i < body.owned; ++i) {
    EXPECT_EQ(body.id[i], i);
    EXPECT_EQ(body.part[i], i < 8 ? 0 : 1);
    EXPECT_EQ(body.material[i], i < 8 ? 0 : 1);
  }
  EXPECT_EQ(largest_spacing(deck, Communicator()), 1);
  EXPECT_DOUBLE_EQ(horizon_length(deck, Communicator()), 3.015);
}

TEST(Body, CoincidentParticlesAreNamedWithTheirPlace) {
  const TextFile one("one.csv", "x,y,z,volume\n0,0,0,1\n2.5,2.5,2.5,1\n"),
      two("two.csv", "x,y,z,volume\n2.5,2.5,2.5,1\n");
  deck::Deck deck = empty_deck();
  add_body(deck, "first", deck::CloudFile{one.path()});
  add_body(deck, "copy", deck::CloudFile{two.path()});
  EXPECT_EQ(refusal([&] { build_body(deck); }),
            "deck.yaml:4:5: particles 1 and 2 are in the same place (2.5, 2.5, 2.5); take one of them out, or move "
            "the bodies apart "
            "so that they do not overlap");
}

TEST(Body, ManyParticlesInOnePlaceAreRefusedQuickly) {
  std::string text = "x,y,z,volume\n";
  for (int k = 0; k < 100000; ++k) text += "1,2,3,1\n";
  const TextFile file("heap.csv", text);
  const deck::Deck deck = deck_of(deck::CloudFile{file.path()}, deck::Dimension::three, 0);
  EXPECT_THAT(refusal([&] { build_body(deck); }), HasSubstr("are in the same place (1, 2, 3)"));
}

TEST(Horizon, MustBePositive) {
  deck::Deck deck = cube(3);
  deck.horizon.ratio.reset();
  deck.horizon.location = {"deck.yaml", 9, 3};
  EXPECT_THAT(refusal([&] { horizon_length(deck, Communicator()); }), StartsWith("deck.yaml:9:3: the horizon must be"));
  deck.horizon.length = 0.25;
  EXPECT_EQ(horizon_length(deck, Communicator()), 0.25);
}

}  // namespace
}  // namespace perinox::body
