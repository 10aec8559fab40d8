/// Parts of cells that a shape's surface leaves, and the loads on that surface.
#include <gtest/gtest.h>

#include <cmath>

#include "perinox/body/cut_cells.hpp"
#include "perinox/body/exposed_faces.hpp"
#include "support/bodies.hpp"
#include "support/measured.hpp"

namespace perinox::body::fixture {
namespace {

using test::measured;
const double pi = std::acos(-1.0);

deck::Deck cut(decltype(deck::Shape::form) form, double spacing, deck::Dimension dimension = deck::Dimension::three) {
  deck::Deck deck = deck_of(std::move(form), dimension, spacing);
  deck.body[0].cut_cells = true;
  return deck;
}

double volume_of(const Body& body) {
  double sum = 0;
  for (const double volume : body.volume) sum += volume;
  return sum;
}

/// What a pressure of one and a traction of one on all of the surface come to.
struct Loads {
  double size = 0;           ///< area of the surface
  double resultant = 0;      ///< largest component of the vector of area
  double moment[3][3] = {};  ///< sum of x (x) vector of area; of a closed surface volume times the unit tensor
};

Loads loads_of(const deck::Deck& deck, const Body& body) {
  Loads loads;
  double area[3] = {};
  for (const FaceShare& face : exposed_faces(deck, body, body.sets.at("all"), {"deck.yaml", 3, 5})) {
    loads.size += face.size;
    const deck::Point x = body.position3(face.particle);
    area[face.axis] += face.side * face.area;
    for (std::size_t c = 0; c < 3; ++c) loads.moment[c][face.axis] += face.side * face.area * x[c];
  }
  for (const double component : area) loads.resultant = std::max(loads.resultant, std::abs(component));
  return loads;
}

TEST(CutCells, HaveTheVolumeOfABall) {
  // A sphere's surface is sampled, ten points along a cell.
  for (const double spacing : {0.31, 0.17}) {
    const deck::Deck deck = cut(deck::Sphere{{0.03, 0.01, -0.02}, 1}, spacing);
    const Body body = build_body(deck);
    EXPECT_LE(measured("cut cells: volume of a ball", std::abs(volume_of(body) / (4 * pi / 3) - 1)), 3e-3);  // 1.4e-3
    deck::Deck whole = deck;
    whole.body[0].cut_cells = false;
    const Body same = build_body(whole);
    EXPECT_EQ(body.id, same.id);  // the same particles in the same places
    EXPECT_EQ(body.reference, same.reference);
  }
}

TEST(CutCells, CarryLoadsOnTheTrueSurface) {
  const deck::Deck deck = cut(deck::Sphere{{0, 0, 0}, 1}, 0.17);
  const Body body = build_body(deck);
  const Loads loads = loads_of(deck, body);
  EXPECT_LE(measured("cut cells: area of a ball", std::abs(loads.size / (4 * pi) - 1)), 0.02);
  EXPECT_LE(measured("cut cells: resultant of a pressure on a ball", loads.resultant), 1e-3);
  for (int c = 0; c < 3; ++c)
    for (int k = 0; k < 3; ++k)
      EXPECT_NEAR(measured("cut cells: moment of a pressure on a ball, over its volume",
                           std::abs(loads.moment[c][k] / (4 * pi / 3) - (c == k ? 1 : 0))),
                  0, 0.01);  // 6.0e-3
}

TEST(CutCells, OfATubeInThePlane) {
  deck::Difference tube;
  tube.parts = {shape_of(deck::Sphere{{0, 0, 0}, 2}), shape_of(deck::Sphere{{0, 0, 0}, 1})};
  const deck::Deck deck = cut(tube, 0.16, deck::Dimension::plane_strain);
  const Body body = build_body(deck);
  EXPECT_LE(measured("cut cells: area of a tube", std::abs(volume_of(body) / (3 * pi) - 1)), 1e-3);
  const Loads loads = loads_of(deck, body);
  EXPECT_LE(measured("cut cells: length of a tube's surface", std::abs(loads.size / (6 * pi) - 1)), 0.01);
  EXPECT_NEAR(measured("cut cells: moment of a pressure on a tube", loads.moment[0][0] / (3 * pi)), 1, 5e-3);
}

TEST(CutCells, AreNoneWhereCellsFillTheBox) {
  const deck::Deck deck = cut(deck::Box{{0, 0, 0}, {5, 4, 3}}, 0.5);
  EXPECT_TRUE(CutCells(deck.body[0], 3).none());
  for (const double volume : build_body(deck).volume) EXPECT_EQ(volume, 0.125);
}

TEST(CutCells, OfABoxThatIsNoWholeNumberOfThem) {
  // Ten cells over a length of 10.4: the outermost stand for 1.2 of one.
  const deck::Deck deck = cut(deck::Box{{0, 0, 0}, {10.4, 4, 4}}, 1);
  const Body body = build_body(deck);
  EXPECT_LE(measured("cut cells: volume of a box", std::abs(volume_of(body) / (10.4 * 16) - 1)), 1e-12);
  EXPECT_NEAR(body.volume[0], 1.2, 1e-12);
  EXPECT_EQ(body.volume[1], 1);
  const Loads loads = loads_of(deck, body);
  EXPECT_LE(measured("cut cells: area of a box", std::abs(loads.size / (2 * 16 + 4 * 4 * 10.4) - 1)),
            2e-3);  // 1.3e-3: what is left of the outermost cells' sides is sampled
  EXPECT_LE(measured("cut cells: moment of a pressure on a box", std::abs(loads.moment[0][0] / (10.4 * 16) - 1)),
            1e-12);
}

TEST(CutCells, HaveNoSurfaceAgainstAnotherBody) {
  // A pin in a hole: what is left is the plate's rim.
  deck::Deck deck = cut(deck::PlateWithHole{{0, 0, 0}, {8, 8, 0}, {4, 4, 0}, 2.2}, 0.5, deck::Dimension::plane_stress);
  add_body(deck, "pin", deck::Sphere{{4, 4, 0}, 2.2}, 0.5);
  deck.body[1].cut_cells = true;
  const Body body = build_body(deck);
  EXPECT_LE(measured("cut cells: rim of a plate with a pin", std::abs(loads_of(deck, body).size / 32 - 1)), 1e-12);
}

}  // namespace
}  // namespace perinox::body::fixture
