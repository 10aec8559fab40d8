/// Tests bonds that leave the material: slits, notches and gaps between bodies, with the shapes that the deck has.
#include <cmath>
#include <set>
#include <utility>

#include "perinox/body/shape.hpp"
#include "support/bodies.hpp"

namespace perinox::bonds {
namespace {

using namespace body::fixture;
using deck::Point;
using ::testing::StartsWith;

deck::Shape box(const Point& min, const Point& max) { return shape_of(deck::Box{min, max}); }

using Pairs = std::set<std::pair<GlobalId, GlobalId>>;
Pairs pairs_of(const Bonded& both) {
  Pairs pairs;
  for (LocalIndex i = 0; i < both.body.owned; ++i)
    for (auto k = both.bonds.offset[i]; k < both.bonds.offset[i + 1]; ++k)
      pairs.insert({both.body.id[i], both.body.id[both.bonds.neighbor[k]]});
  return pairs;
}
Pairs pairs_of(const deck::Deck& deck) { return pairs_of(build_bonds(deck)); }

/// Length of the bond outside of the shapes, by so many points on it.
double outside(const deck::Deck& deck, const body::Body& body, LocalIndex i, LocalIndex j, int points) {
  const Point a = body.position3(i), b = body.position3(j);
  int out = 0;
  for (int k = 0; k < points; ++k) {
    const double s = (k + 0.5) / points;
    const Point x{a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1]), a[2] + s * (b[2] - a[2])};
    bool in = false;
    for (const deck::BodyPart& part : deck.body) in = in || body::contains(part.shape, x, body.dimension);
    out += in ? 0 : 1;
  }
  return out * std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]) / points;
}

/// Every bond that was made stays within 0.3 spacings of the material, and every other one does not, except for ties.
void expect_the_rule(const deck::Deck& deck, const char* name) {
  deck::Deck all = deck;
  all.across_gaps = deck::AcrossGaps::keep;
  const Bonded made = build_bonds(deck), kept = build_bonds(all);
  const Pairs pairs = pairs_of(made);
  long long missing = 0;
  for (LocalIndex i = 0; i < kept.body.owned; ++i)
    for (auto k = kept.bonds.offset[i]; k < kept.bonds.offset[i + 1]; ++k) {
      const LocalIndex j = kept.bonds.neighbor[k];
      const bool is_made = pairs.count({kept.body.id[i], kept.body.id[j]}) > 0;
      missing += is_made ? 0 : 1;
      if (i > j) continue;
      // 200 points are right to 0.02 or so; where that could decide, more are taken.
      double length = outside(deck, kept.body, i, j, 200);
      if (std::abs(length - 0.3) < 0.06) length = outside(deck, kept.body, i, j, 4000);
      if (std::abs(length - 0.3) < 2e-3) continue;
      EXPECT_EQ(is_made, length < 0.3) << name << ": " << i << " " << j << " outside by " << length;
    }
  EXPECT_EQ(made.bonds.across_gaps, missing) << name;
  EXPECT_EQ(kept.bonds.across_gaps, 0) << name;
  EXPECT_GT(missing, 0) << name;
  for (const double damage : made.bonds.damage) EXPECT_EQ(damage, 0) << name;  // it is a surface
}

TEST(Gaps, BondsThatLeaveTheMaterialAreNotMade) {
  const auto flat = deck::Dimension::plane_stress;
  expect_the_rule(deck_of(deck::Difference{{box({0, 0, 0}, {16, 16, 0}), box({-1, 7, 0}, {8, 9, 0})}}, flat), "slit");
  expect_the_rule(deck_of(deck::Difference{{box({0, 0, 0}, {16, 16, 0}), box({-1, 7.8, 0}, {8, 8.2, 0})}}, flat),
                  "slit between rows, narrower than a spacing");
  expect_the_rule(deck_of(deck::PlateWithHole{{0, 0, 0}, {14, 14, 0}, {7, 7, 0}, 3.45}, flat), "hole");
  expect_the_rule(
      deck_of(deck::Difference{{box({0, 0, 0}, {9, 6, 6}), shape_of(deck::Cylinder{{4, 3, -1}, {5, 3, 7}, 1.3})}}),
      "slanting hole");
  expect_the_rule(deck_of(deck::Union{{box({0, 0, 0}, {8, 4, 0}), box({0, 4, 0}, {4, 10, 0})}}, flat), "L of a union");
}

TEST(Gaps, BodiesThatDoNotTouchAreNotBonded) {
  const auto apart = [](double gap) {
    deck::Deck deck = deck_of(deck::Box{{0, 0, 0}, {5, 5, 5}});
    add_body(deck, "right", deck::Box{{5 + gap, 0, 0}, {10 + gap, 5, 5}});
    return deck;
  };
  deck::Deck separate = apart(2);
  separate.bond_bodies = false;
  EXPECT_EQ(pairs_of(apart(2)), pairs_of(separate));
  EXPECT_EQ(pairs_of(apart(0.5)), pairs_of(separate));
  EXPECT_EQ(build_bonds(apart(0)).bonds.across_gaps, 0);
  EXPECT_EQ(build_bonds(apart(0)).bonds.count(), build_bonds(deck_of(deck::Box{{0, 0, 0}, {10, 5, 5}})).bonds.count());
  // A gap thinner than 0.3 spacings is a seam of rounded coordinates, so straight bonds stay.
  const Pairs near = pairs_of(apart(0.25));
  EXPECT_GT(near.size(), pairs_of(separate).size());
}

/// The gap between two bodies that are not bonded is not filled by a third one's material, but by its own.
TEST(Gaps, WhoseShapeCounts) {
  deck::Deck deck = deck_of(deck::Difference{{box({0, 0, 0}, {12, 9, 0}), box({5, 3, 0}, {7, 10, 0})}},
                            deck::Dimension::plane_stress);
  const long long across = build_bonds(deck).bonds.across_gaps;
  EXPECT_GT(across, 0);
  add_body(deck, "filler", deck::Box{{5, 3, 0}, {7, 9, 0}});
  EXPECT_EQ(build_bonds(deck).bonds.across_gaps, 0);
  EXPECT_EQ(build_bonds(deck).bonds.count(),
            build_bonds(deck_of(deck::Box{{0, 0, 0}, {12, 9, 0}}, deck::Dimension::plane_stress)).bonds.count());
  deck.bond_bodies = false;
  EXPECT_EQ(build_bonds(deck).bonds.across_gaps, across);
}

/// A cloud's shape is what its outline says. Without an outline nothing is known about its gaps.
TEST(Gaps, OfACloudByItsOutline) {
  const auto slit = deck::Difference{{box({0, 0, 0}, {10, 10, 0}), box({-1, 4, 0}, {5, 6, 0})}};
  const Bonded lattice = build_bonds(deck_of(slit, deck::Dimension::plane_stress));
  std::string rows = "x,y,z,volume\n";
  for (LocalIndex i = 0; i < lattice.body.owned; ++i)
    rows += std::to_string(lattice.body.position(i)[0]) + "," + std::to_string(lattice.body.position(i)[1]) + ",0,1\n";
  const TextFile file("gap_cloud.csv", rows);
  deck::Deck cloud = deck_of(deck::CloudFile{file.path()}, deck::Dimension::plane_stress);
  EXPECT_EQ(build_bonds(cloud).bonds.count(), lattice.bonds.count() + lattice.bonds.across_gaps);
  cloud.body[0].outline = shape_of(slit);
  EXPECT_EQ(pairs_of(cloud), pairs_of(lattice));
  EXPECT_EQ(build_bonds(cloud).bonds.across_gaps, lattice.bonds.across_gaps);
}

TEST(Gaps, AnOutlineHoldsAllPointsOfItsCloud) {
  const TextFile file("outline.csv", "x,y,z,volume\n0.5,0.5,0,1\n1.5,0.5,0,1\n2.5,0.5,0,1\n");
  deck::Deck cloud = deck_of(deck::CloudFile{file.path()}, deck::Dimension::plane_stress);
  const auto with = [&](double end) {
    cloud.body[0].outline = box({0, 0, 0}, {end, 1, 0});
    return cloud;
  };
  EXPECT_EQ(build_bonds(with(2.49)).bonds.across_gaps, 0);  // within 0.01 horizons a point lies on its outline
  EXPECT_THAT(refusal([&] { build_bonds(with(2.4)); }),
              ::testing::HasSubstr("particle 2 of the body block at (2.5, 0.5, 0) lies outside of the body's outline"));
}

/// A body that is moved by any part of a cell, is far from the origin or is mirrored has the same bonds.
TEST(Gaps, DoNotDependOnWhereTheBodyLies) {
  const auto plate = [](double x, double y) {
    return deck_of(
        deck::Difference{{box({x, y, 0}, {x + 12, y + 12, 0}), shape_of(deck::Sphere{{x + 6.2, y + 5.1, 0}, 2.3}),
                          box({x - 1, y + 2.4, 0}, {x + 7, y + 3.6, 0})}},
        deck::Dimension::plane_stress);
  };
  const Pairs at_origin = pairs_of(plate(0, 0));
  EXPECT_EQ(pairs_of(plate(0.37, -12.91)), at_origin);
  EXPECT_EQ(pairs_of(plate(1e6 + 0.1, 3e6 - 0.7)), at_origin);
}

}  // namespace
}  // namespace perinox::bonds
