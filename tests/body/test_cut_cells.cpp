/// Tests the parts of cells that a shape's surface leaves.
#include <gtest/gtest.h>

#include <random>

#include "body/cut_cells.hpp"
#include "support/measured.hpp"
#include "surface_sums.hpp"

namespace perinox::body::fixture {
namespace {

using deck::Point;
using test::measured;
const double pi = std::acos(-1.0);
constexpr auto plane = deck::Dimension::plane_strain;

double volume_error(const char* what, const deck::Deck& deck, double expected) {
  return measured(what, std::abs(volume_of(build_body(deck)) / expected - 1));
}

TEST(CutCells, AreNoneWhereCellsFillTheBox) {
  for (const double offset : {0.0, 1e6 / 3}) {
    const deck::Deck deck = cut(deck::Box{{offset, 0, 0}, {offset + 5, 4, 3}}, 0.5);
    EXPECT_TRUE(CutCells(deck.body[0], 3).none());
    for (const double volume : build_body(deck).volume) EXPECT_EQ(volume, 0.125);
  }
}

/// Boxes with sides of 8.5, 4.5 and 3.7 cells were once 2.4, 4.5 and 5.5 % too big.
TEST(CutCells, OfBoxesAreExact) {
  for (const double side : {8.5, 4.5, 3.7, 3.1, 10.4, 0.3})
    for (const double offset : {0.0, 1.0 / 3, 7777.7}) {
      const Point min{offset, -offset, 2 * offset};
      const deck::Deck bar = cut(deck::Box{min, {min[0] + 12, min[1] + side, min[2] + side}}, 1);
      EXPECT_LE(volume_error("cut cells: volume of a bar", bar, 12 * side * side), 1e-11);
      const deck::Deck strip = cut(deck::Box{min, {min[0] + 12.2, min[1] + side, 0}}, 1, plane);
      EXPECT_LE(volume_error("cut cells: area of a strip", strip, 12.2 * side), 1e-11);
    }
  const Body body = build_body(cut(deck::Box{{0, 0, 0}, {10.4, 4, 4}}, 1));
  EXPECT_NEAR(body.volume[0], 1.2, 1e-12);  // ten cells over a length of 10.4: the outermost stand for 1.2 of one
  EXPECT_EQ(body.volume[1], 1);
}

/// Half a cell is rounded up wherever the body is.
TEST(CutCells, AreAsManyWhereverTheBodyIs) {
  for (int k = 0; k < 200; ++k) {
    const double x = 0.1 * k + 1e4 / 7;
    EXPECT_EQ(build_body(cut(deck::Box{{x, 0, 0}, {x + 0.85, 0.4, 0}}, 0.1, plane)).total, 36) << x;
  }
}

/// The parts are moved against the lattice by any share of a cell.
TEST(CutCells, OfUnionsAndDifferencesOfBoxesAreExact) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> some(0, 1);
  for (int k = 0; k < 20; ++k) {
    const double x = some(random), y = some(random), z = some(random);
    const auto block = shape_of(union_of({box({0, 0, 0}, {9, 9, 9}), box({3, 3, 8}, {6 + x, 7, 12})}));
    const auto hole = box({2 + x, 2 + y, 2 + z}, {4.5 + x, 6.1 + y, 5.3 + z});
    const auto notch = box({x + 4, y - 1, 5}, {x + 5.5, y + 1.5, 8});
    EXPECT_LE(volume_error("cut cells: volume of blocks with holes", cut(difference({block, hole, notch}), 1),
                           729 + (3 + x) * 4 * 3 - 2.5 * 4.1 * 3.3 - 1.5 * (y + 1.5) * 3),
              1e-12);
  }
}

TEST(CutCells, OfBarsAskewInThePlaneAreExact) {
  for (const double x : {0.0, 0.21, 0.5, 0.77}) {
    const auto slot = shape_of(deck::Cylinder{{6 + x, 7, 0}, {12 + x, 13.7, 0}, 1.3});
    EXPECT_LE(
        volume_error("cut cells: area around an oblique slot",
                     cut(difference({box({0, 0, 0}, {20, 20, 0}), slot}), 1, plane), 400 - 2.6 * std::hypot(6, 6.7)),
        1e-12);
  }
}

TEST(CutCells, OfCurvedShapes) {
  constexpr double bound = 1e-6;
  for (const double x : {0.0, 0.13, 0.5}) {
    const Point at{x, 2 * x, -x};
    EXPECT_LE(volume_error("cut cells: volume of a ball", cut(deck::Sphere{at, 5}, 1), 500 * pi / 3), bound);
    EXPECT_LE(
        volume_error("cut cells: volume of a small ball", cut(deck::Sphere{at, 3.1}, 1), 4 * pi / 3 * std::pow(3.1, 3)),
        bound);
    for (const Point& axis : {Point{0, 0, 9}, Point{9, 0, 0}, Point{5, 4, 3}, Point{8, 8, 1e-7}}) {
      const deck::Cylinder bar{at, {at[0] + axis[0], at[1] + axis[1], at[2] + axis[2]}, 5};
      EXPECT_LE(volume_error("cut cells: volume of a cylinder", cut(bar, 1),
                             25 * pi * std::sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2])),
                bound);
    }
    EXPECT_LE(volume_error("cut cells: area of a disc", cut(deck::Sphere{at, 5}, 1, plane), 25 * pi), bound);
    EXPECT_LE(volume_error("cut cells: volume of a plate with a hole",
                           cut(deck::PlateWithHole{{0, 0, 0}, {20, 20, 3.3}, {10 + x, 9 - x, 0}, 5}, 1),
                           (400 - 25 * pi) * 3.3),
              bound);
  }
}

/// The shapes are two balls, a ball with a bore, two cylinders that cross at right angles (Steinmetz), and a tube in
/// the plane.
TEST(CutCells, OfCurvedShapesTogether) {
  const double cap = pi * 2 * 2 * (3 * 5 - 2) / 3;  // of a ball of radius 5, 2 high
  for (const double x : {0.0, 0.3}) {
    const auto ball = [&](double at, double radius) { return shape_of(deck::Sphere{{at + x, x, 0.1}, radius}); };
    EXPECT_LE(volume_error("cut cells: volume of two balls", cut(union_of({ball(0, 5), ball(6, 5)}), 1),
                           2 * 500 * pi / 3 - 2 * cap),
              1e-6);
    const auto bore = shape_of(deck::Cylinder{{x, x, -7}, {x, x, 7}, 3});
    EXPECT_LE(volume_error("cut cells: volume of a ball with a bore", cut(difference({ball(0, 5), bore}), 1),
                           4 * pi / 3 * 64),
              1e-6);
    const auto one = shape_of(deck::Cylinder{{x, x, -8}, {x, x, 8}, 4});
    const auto two = shape_of(deck::Cylinder{{x - 8, x, 0}, {x + 8, x, 0}, 4});
    EXPECT_LE(volume_error("cut cells: volume of crossed cylinders", cut(union_of({one, two}), 1),
                           2 * 16 * pi * 16 - 16.0 / 3 * 64),
              1e-4);
    EXPECT_LE(volume_error("cut cells: area of a tube", cut(difference({ball(0, 6), ball(0.5, 3.2)}), 1, plane),
                           (36 - 3.2 * 3.2) * pi),
              1e-6);
  }
}

TEST(CutCells, LeaveTheParticlesWhereTheyAre) {
  const deck::Deck deck = cut(deck::Sphere{{0.03, 0.01, -0.02}, 1}, 0.17);
  deck::Deck whole = deck;
  whole.body[0].cut_cells = false;
  const Body body = build_body(deck), same = build_body(whole);
  EXPECT_EQ(body.id, same.id);
  EXPECT_EQ(body.reference, same.reference);
}

}  // namespace
}  // namespace perinox::body::fixture
