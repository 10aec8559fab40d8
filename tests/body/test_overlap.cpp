/// Bodies that overlap are refused, or the later one wins. Bodies that only touch are left alone.
#include <cmath>

#include "perinox/body/overlap.hpp"
#include "perinox/deck/read.hpp"
#include "perinox/materials/material.hpp"
#include "support/bodies.hpp"
#include "support/measured.hpp"

namespace perinox::body {
namespace {

using namespace fixture;
using ::testing::HasSubstr;
using ::testing::StartsWith;

deck::Deck two_boxes(double from, deck::Dimension dimension = deck::Dimension::three) {
  deck::Deck deck = deck_of(deck::Box{{0, 0, 0}, {10, 10, 5}}, dimension);
  add_body(deck, "second", deck::Box{{from, 2, 1}, {from + 8, 7, 4}});
  return deck;
}

TEST(Overlap, IsRefusedWithItsPlaceAndSize) {
  EXPECT_THAT(
      refusal([] { build_body(two_boxes(4)); }),
      StartsWith(
          "deck.yaml:4:5: the body second overlaps the body block by about 90, for example at (7, 2.25, 1.25), where"));
  EXPECT_THAT(refusal([] { build_body(two_boxes(9.9)); }), HasSubstr("by about 1.5, for example at"));
  EXPECT_THAT(refusal([] { build_body(two_boxes(4, deck::Dimension::plane_stress)); }), HasSubstr("by about 30,"));
  EXPECT_EQ(refusal([] { build_body(two_boxes(10)); }), "nothing was refused");
  EXPECT_EQ(refusal([] { build_body(two_boxes(10 - 1e-9)); }), "nothing was refused");  // rounded coordinates
  EXPECT_EQ(refusal([] { build_body(two_boxes(12)); }), "nothing was refused");
}

TEST(Overlap, OfWhatFitsIntoAHoleIsNone) {
  for (const double radius : {3.0, 3e3}) {
    deck::Deck deck =
        deck_of(deck::PlateWithHole{{-2 * radius, -2 * radius, 0}, {2 * radius, 2 * radius, 0}, {}, radius},
                deck::Dimension::plane_stress, radius / 20);
    add_body(deck, "plug", deck::Sphere{{}, radius}, radius / 20);
    EXPECT_TRUE(find_overlaps(deck).empty()) << radius;
    std::get<deck::Sphere>(deck.body[1].shape.form).radius *= 1.01;
    ASSERT_EQ(find_overlaps(deck).size(), 1u) << radius;
    const double ring = std::acos(-1.0) * radius * radius * (1.01 * 1.01 - 1);
    EXPECT_NEAR(find_overlaps(deck)[0].volume / ring, 1, 0.05);  // 0.01
  }
}

TEST(Overlap, OfACloud) {
  const TextFile file("overlap.csv", "x,y,z,volume\n-1.5,5,2,1\n-0.5,5,2,1\n0.5,5,2,1\n");
  deck::Deck deck = deck_of(deck::Box{{0, 0, 0}, {10, 10, 5}});
  add_body(deck, "cloud", deck::CloudFile{file.path()}, 0);
  EXPECT_THAT(refusal([&] { build_body(deck); }),
              StartsWith("deck.yaml:4:5: particle 502 of the body cloud at (0.5, 5, 2) lies inside the body block"));
  std::swap(deck.body[0], deck.body[1]);
  EXPECT_THAT(refusal([&] { build_body(deck); }), HasSubstr("particle 2 of the body cloud at (0.5, 5, 2)"));
  deck.overlap = deck::Overlap::later_wins;
  EXPECT_EQ(build_body(deck).total, 502);
  const TextFile on_the_face("overlap.csv", "x,y,z,volume\n-1.5,5,2,1\n-0.5,5,2,1\n0,5,2,1\n");
  deck.overlap = deck::Overlap::refuse;
  EXPECT_EQ(build_body(deck).total, 503);
}

/// Volumes add up to what the shapes cover together, and the order says which body has the common part.
TEST(Overlap, TheLaterBodyWins) {
  const auto volumes = [](const std::string& first, const std::string& second) {
    const deck::Deck deck = deck::read_text(R"(
dimension: 3
overlap: later-wins
body:
  - {name: a, shape: )" + first + R"(, spacing: 1, material: m}
  - {name: b, shape: )" + second + R"(, spacing: 1, material: m}
horizon: {ratio: 3.015}
materials: {m: {model: elastic, young_modulus: 1000, poisson_ratio: 0.3}}
)",
                                            "deck.yaml", materials::full_schema(), {});
    const Body body = build_body(deck);
    std::array<double, 2> sums{};
    for (LocalIndex i = 0; i < body.owned; ++i) sums[static_cast<std::size_t>(body.part[i])] += body.volume[i];
    return sums;
  };
  const std::string block = "{box: {min: [0, 0, 0], max: [10, 10, 5]}}",
                    other = "{box: {min: [4, 2, 1], max: [12, 7, 4]}}";
  const auto [a, b] = volumes(block, other);
  EXPECT_NEAR(a, 500 - 90, 1e-9);
  EXPECT_NEAR(b, 120, 1e-9);
  const auto [c, d] = volumes(other, block);
  EXPECT_NEAR(c, 120 - 90, 1e-9);
  EXPECT_NEAR(d, 500, 1e-9);
  EXPECT_THAT(
      refusal([&] { volumes("{box: {min: [4, 2, 1], max: [8, 7, 4]}}", block); }),
      HasSubstr("the body a has no particles: none of the 4 x 5 x 3 centres of its lattice is inside its shape, "
                "without what later bodies take of it (overlap: later-wins)"));
}

}  // namespace
}  // namespace perinox::body
