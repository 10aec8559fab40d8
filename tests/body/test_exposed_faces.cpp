/// Tests the faces of the surface of a lattice body, and the loads they carry.
#include <gtest/gtest.h>

#include <numeric>

#include "perinox/body/exposed_faces.hpp"
#include "perinox/core/error.hpp"
#include "support/bodies.hpp"

namespace perinox::body::fixture {
namespace {

struct Resultant {
  deck::Point area{}, moment{};  ///< of the vectors of area; sum of area times (position - centre) along the normal
  std::size_t shares = 0;
};

deck::Deck block(double x, double y, double z, double spacing, deck::Dimension dimension = deck::Dimension::three) {
  return deck_of(deck::Box{{0, 0, 0}, {x, y, z}}, dimension, spacing);
}

Resultant resultant(const Body& body, const std::vector<FaceShare>& faces) {
  Resultant sum;
  for (const FaceShare& face : faces) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      sum.area[axis] += face.area[axis];
      sum.moment[axis] += std::abs(face.area[axis]) * (body.position3(face.particle)[axis] - face.center[axis]) *
                          (face.size < 0 ? -1 : 1);
    }
    ++sum.shares;
  }
  return sum;
}

std::vector<FaceShare> faces_of(const deck::Deck& deck, const Body& body) {
  return exposed_faces(deck, body, body.sets.at("all"), {"deck.yaml", 3, 5});
}

TEST(ExposedFaces, OfABoxCloseAndLeaveNoMoment) {
  const deck::Deck deck = block(2.5, 2, 1.5, 0.5);
  const Body body = build_body(deck);
  const auto faces = faces_of(deck, body);
  const Resultant sum = resultant(body, faces);
  EXPECT_EQ(sum.shares, 3U * 2 * (5 * 4 + 4 * 3 + 3 * 5));
  double area = 0;
  for (const FaceShare& face : faces) area += face.size;
  EXPECT_NEAR(area, 0.25 * 2 * (5 * 4 + 4 * 3 + 3 * 5), 1e-12);
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_NEAR(sum.area[c], 0, 1e-12);
    EXPECT_NEAR(sum.moment[c], 0, 1e-12);  // the load lies in the surface, not in the first layer
  }
}

TEST(ExposedFaces, ThinPlatesShareTheLoadByWhatTheyHave) {
  const deck::Deck two = block(6, 2, 0, 1, deck::Dimension::plane_stress);
  const Body body = build_body(two);
  const Resultant sum = resultant(body, faces_of(two, body));
  for (std::size_t c = 0; c < 2; ++c) EXPECT_NEAR(sum.moment[c], 0, 1e-12);
  const deck::Deck one = block(6, 1, 0, 1, deck::Dimension::plane_stress);
  for (const FaceShare& face : faces_of(one, build_body(one))) EXPECT_TRUE(face.area[0] != 0 || face.size == 1);
}

TEST(ExposedFaces, ACloudHasNoneThatAreKnown) {
  const TextFile file("three.csv", "x,y,z,volume\n0,0,0,1\n1,0,0,1\n2,0,0,1\n");
  const deck::Deck deck = deck_of(deck::CloudFile{file.path()}, deck::Dimension::three, 0);
  const Body body = build_body(deck);
  EXPECT_EQ(
      refusal([&] { faces_of(deck, body); }),
      "deck.yaml:3:5: the set holds particles of the point cloud block, whose surface is not known; use force, or "
      "give the body a shape and a spacing");
}

TEST(ExposedFaces, OnlyAtTheSurface) {
  const deck::Deck deck = block(5, 5, 5, 1);
  const Body body = build_body(deck);
  EXPECT_THROW(exposed_faces(deck, body, {62}, {"deck.yaml", 3, 5}), InputError);  // the middle
  EXPECT_EQ(exposed_faces(deck, body, {0}, {"deck.yaml", 3, 5}).size(), 9U);       // a corner, three deep
}

}  // namespace
}  // namespace perinox::body::fixture
