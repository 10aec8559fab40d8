/// Tests loads on the surfaces of shapes: on closed surfaces they cancel, and projected areas are exact.
#include <gtest/gtest.h>

#include <random>

#include "perinox/core/error.hpp"
#include "support/measured.hpp"
#include "surface_sums.hpp"

namespace perinox::body::fixture {
namespace {

using deck::Point;
using test::measured;
const double pi = std::acos(-1.0);
constexpr auto plane = deck::Dimension::plane_stress;

Point unit(const Point& a) {
  const double size = std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
  return {a[0] / size, a[1] / size, a[2] / size};
}
void add_cut_body(deck::Deck& deck, const std::string& name, decltype(deck::Shape::form) form, double spacing) {
  add_body(deck, name, std::move(form), spacing);
  deck.body.back().cut_cells = true;
}
/// Checks a closed surface: the resultant of a pressure on it, and its work on a uniform strain. spans: no part of the
/// body is one particle thick, where no particles could carry the moments.
void expect_closed(const char* what, const deck::Deck& deck, bool spans = true) {
  const Body body = build_body(deck);
  const SurfaceSums sums = sums_of(deck, body);
  const std::string name = what;
  EXPECT_LE(measured(name + ": resultant over area", sums.resultant() / sums.size), 1e-12);
  if (!spans) return;
  EXPECT_LE(measured(name + ": moments against volume", moment_error(sums, volume_of(body), body.dimension)), 1e-6);
}

TEST(SurfaceLoads, OnABall) {
  for (const double x : {0.0, 0.23}) {
    const deck::Deck deck = cut(deck::Sphere{{x, -x, 2 * x}, 5}, 1);
    const Body body = build_body(deck);
    const SurfaceSums sums = sums_of(deck, body);
    EXPECT_LE(measured("ball: area", std::abs(sums.size / (100 * pi) - 1)), 1e-10);
    expect_closed("ball", deck);
    for (const Point& direction : {Point{1, 1, 1}, Point{0, 0, 1}, Point{-0.3, 0.2, 0.9}}) {
      const Point facing = unit(direction), away{-facing[0], -facing[1], -facing[2]};
      const SurfaceSums front = sums_of(deck, body, "all", facing), back = sums_of(deck, body, "all", away);
      EXPECT_LE(measured("ball: area seen from one side", std::abs(front.size / (25 * pi) - 1)), 1e-10);
      for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_LE(measured("ball: vector of area of a half", std::abs(front.area[c] / (25 * pi) - facing[c])), 1e-10);
        for (std::size_t k = 0; k < 3; ++k)
          EXPECT_LE(measured("ball: two halves and the whole",
                             std::abs(front.moment[c][k] + back.moment[c][k] - sums.moment[c][k])),
                    1e-9);
      }
    }
  }
}

/// When the disc was loaded from both sides along x, the stress across was once 0.
TEST(SurfaceLoads, OnBothHalvesOfADisc) {
  const deck::Deck deck = cut(deck::Sphere{{0.1, 0.2, 0}, 5}, 0.5, plane);
  const Body body = build_body(deck);
  const SurfaceSums right = sums_of(deck, body, "all", Point{1, 0, 0}),
                    left = sums_of(deck, body, "all", Point{-1, 0, 0});
  EXPECT_NEAR(right.size, 10, 1e-11);
  EXPECT_NEAR(right.area[0], 10, 1e-11);
  EXPECT_NEAR(right.area[1], 0, 1e-11);
  for (std::size_t c = 0; c < 2; ++c)
    for (std::size_t k = 0; k < 2; ++k)
      EXPECT_LE(measured("disc: stress of a pressure on both halves",
                         std::abs((right.moment[c][k] + left.moment[c][k]) / (25 * pi) - (c == k ? 1 : 0))),
                1e-11);
}

/// The end of an oblique cylinder once had four times its area.
TEST(SurfaceLoads, OnTheEndOfAnObliqueCylinder) {
  const Point axis = unit({3, 2, 6});
  const deck::Deck deck = cut(deck::Cylinder{{0, 0, 0}, {9, 6, 18}, 4}, 1);
  const Body body = build_body(deck);
  const SurfaceSums end = sums_of(deck, body, "all", axis);
  EXPECT_LE(measured("oblique cylinder: end", std::abs(end.size / (16 * pi) - 1)), 1e-10);
  EXPECT_LE(measured("oblique cylinder: all", std::abs(sums_of(deck, body).size / (32 * pi + 8 * pi * 21) - 1)), 1e-9);
  expect_closed("oblique cylinder", deck);
}

TEST(SurfaceLoads, OfBoxesThatTouchAtAnotherSpacing) {
  // Two plates that touch at different spacings: their interface carries nothing.
  for (const double h : {0.5, 1.0 / 3, 0.7, 1.0})
    for (const bool cells : {true, false}) {
      deck::Deck deck = cut(deck::Box{{0, 0, 0}, {6, 6, 0}}, 1, plane);
      add_cut_body(deck, "fine", deck::Box{{6, 1, 0}, {12, 6, 0}}, h);
      deck.body[0].cut_cells = deck.body[1].cut_cells = cells;
      if (!cells && h == 0.7) continue;
      const Body body = build_body(deck);
      const SurfaceSums sums = sums_of(deck, body);
      EXPECT_LE(measured("two plates: resultant", sums.resultant()), 1e-12);
      EXPECT_NEAR(sums.size, 2 * 12 + 2 * 6, 1e-12);
      EXPECT_LE(measured("two plates: moments against volume", moment_error(sums, 66, 2)), 1e-12);
      deck.bond_bodies = false;
      EXPECT_NEAR(sums_of(deck, body).size, 24 + 22, 1e-12);  // their own surfaces
    }
}

TEST(SurfaceLoads, OfAPinInAHole) {
  for (const double h : {0.5, 0.31}) {
    deck::Deck deck = cut(deck::PlateWithHole{{0, 0, 0}, {8, 8, 0}, {4, 4, 0}, 2.2}, 0.5, plane);
    add_cut_body(deck, "pin", deck::Sphere{{4, 4, 0}, 2.2}, h);
    const Body body = build_body(deck);
    EXPECT_LE(measured("pin in a hole: rim", std::abs(sums_of(deck, body).size / 32 - 1)), 1e-12);
    EXPECT_THROW(sums_of(deck, body, "pin"), InputError);
    deck.bond_bodies = false;
    EXPECT_LE(measured("pin in a hole: its own", std::abs(sums_of(deck, body, "pin").size / (4.4 * pi) - 1)), 1e-12);
    expect_closed("pin in a hole", deck);
  }
}

/// Pressure into gaps of 0.1 to 0.49 h once vanished.
TEST(SurfaceLoads, IntoNarrowGaps) {
  for (const double gap : {1e-6, 0.1, 0.3, 0.49, 0.6})
    for (const bool bonded : {true, false}) {
      deck::Deck deck = cut(deck::Box{{0, 0, 0}, {6, 4, 4}}, 1);
      add_cut_body(deck, "other", deck::Box{{6 + gap, 0, 0}, {12 + gap, 4, 4}}, 1);
      deck.bond_bodies = bonded;
      add_set(deck, "face", deck::SetWhere{deck::Expression("x > 5 && x < 6", {"deck.yaml", 20, 3})});
      const Body body = build_body(deck);
      EXPECT_NEAR(sums_of(deck, body).size, 2 * (2 * 16 + 4 * 24), 1e-9) << gap;
      const SurfaceSums face = sums_of(deck, body, "face", Point{1, 0, 0});
      EXPECT_NEAR(face.size, 16, 1e-9) << gap;
      EXPECT_NEAR(face.area[0], 16, 1e-9) << gap;
    }
}

/// Loads one lip of a slit half a cell wide. The other lip carries nothing of it.
TEST(SurfaceLoads, IntoASlit) {
  deck::Deck deck = cut(difference({box({0, 0, 0}, {12, 12, 0}), box({-1, 5.75, 0}, {6, 6.25, 0})}), 1, plane);
  add_set(deck, "lip", deck::SetWhere{deck::Expression("y > 5 && y < 6 && x < 6", {"deck.yaml", 20, 3})});
  const Body body = build_body(deck);
  EXPECT_NEAR(sums_of(deck, body, "lip", Point{0, 1, 0}).size, 6, 1e-12);
  for (const FaceShare& face : exposed_faces(deck, body, body.sets.at("lip"), {}, Point{0, 1, 0}))
    EXPECT_TRUE(body.position3(face.particle)[1] < 6 || body.position3(face.particle)[0] > 6);
}

TEST(SurfaceLoads, SayWhyThereAreNone) {
  deck::Deck deck = cut(deck::Box{{0, 0, 0}, {6, 4, 0}}, 1, plane);
  add_cut_body(deck, "right", deck::Box{{6, -2, 0}, {12, 6, 0}}, 0.5);
  add_set(deck, "middle", deck::SetWhere{deck::Expression("x > 5 && x < 6 && y > 1 && y < 3", {"deck.yaml", 20, 3})});
  const Body body = build_body(deck);
  EXPECT_EQ(
      refusal([&] { sums_of(deck, body, "middle"); }),
      "deck.yaml:3:5: all of the set's surface touches another body and is bonded to it; choose a set with a free "
      "surface, or bond_bodies: false");
  EXPECT_EQ(refusal([&] {
              sums_of(deck, body, "right", Point{0, 0, 1});
            }),
            "deck.yaml:3:5: no exposed face of the set looks the way facing says; turn it round or change the set");
}

/// With boundary_cells: whole a surface is made of steps, which stand for the true surface behind them.
TEST(SurfaceLoads, OnSteps) {
  deck::Deck deck = cut(deck::Sphere{{0, 0, 0}, 10.3}, 1);
  deck.body[0].cut_cells = false;
  const Body body = build_body(deck);
  const double seen = pi * 10.3 * 10.3;
  EXPECT_LE(measured("steps: resultant", sums_of(deck, body).resultant()), 1e-10);
  EXPECT_LE(measured("steps: area of a ball", std::abs(sums_of(deck, body).size / (4 * seen) - 1)), 0.05);
  EXPECT_LE(
      measured("steps: ball seen from a corner", std::abs(sums_of(deck, body, "all", unit({1, 1, 1})).size / seen - 1)),
      0.05);
}

/// Boxes, balls and cylinders in random places, whose surfaces meet and coincide.
TEST(SurfaceLoads, OnAnyClosedSurfaceNetNothing) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> some(0, 1);
  for (int k = 0; k < 12; ++k) {
    const double x = some(random), y = some(random), z = some(random);
    const auto block = shape_of(union_of({box({0, 0, 0}, {8, 7, 6}), box({3, 2, 4}, {6 + x, 7, 9.5 + y})}));
    std::vector<deck::Shape> parts{block, box({2 + x, 0, z}, {4.5, 3.1 + y, 2 + z})};
    if (k % 3 == 1) parts.push_back(shape_of(deck::Sphere{{4 + x, 3 + y, 6}, 2.2}));
    if (k % 3 == 2) parts.push_back(shape_of(deck::Cylinder{{-1, 5 + y - 1, 2}, {9, 5, 3 + z}, 1.1}));
    const deck::Deck deck = cut(difference(parts), 0.9 + 0.2 * z);
    expect_closed(k % 3 == 0   ? "planes"
                  : k % 3 == 1 ? "planes and a ball"
                               : "planes and an oblique cylinder",
                  deck, false);
    const Body body = build_body(deck);
    const Point facing = unit({x - 0.5, y - 0.5, z - 0.4}), back{-facing[0], -facing[1], -facing[2]};
    const double front = sums_of(deck, body, "all", facing).size;
    EXPECT_LE(
        measured("any surface: seen from both sides", std::abs(front / sums_of(deck, body, "all", back).size - 1)),
        1e-9);
  }
}

}  // namespace
}  // namespace perinox::body::fixture
