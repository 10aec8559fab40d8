/// Pre-cracks: which bonds they cut, the damage they leave, the rule for particles in the crack's plane.
#include <cmath>
#include <random>

#include "perinox/bonds/crack_surface.hpp"
#include "support/bodies.hpp"
#include "support/measured.hpp"

namespace perinox::bonds {
namespace {

using namespace body::fixture;
using deck::Point;
using ::testing::StartsWith;

deck::Crack crack_of(decltype(deck::Crack::form) form) { return {{"deck.yaml", 30, 5}, std::move(form)}; }

TEST(Cracks, AWholePlaneHalvesTheBody) {
  deck::Deck deck = cube(6);
  add_crack(deck, deck::CrackRectangle{{3, 0, 0}, {0, 6, 0}, {0, 0, 6}});
  const auto [body, bonds] = build_bonds(deck);
  deck::Deck half = deck_of(deck::Box{{0, 0, 0}, {3, 6, 6}});
  const auto alone = build_bonds(half);
  EXPECT_EQ(bonds.count(), 2 * alone.bonds.count());
  EXPECT_EQ(bonds.cut, build_bonds(cube(6)).bonds.count() - bonds.count());
  // m of what remains is that of a free surface there.
  EXPECT_DOUBLE_EQ(bonds.weighted_volume[0], alone.bonds.weighted_volume[0]);
  const double uncut = build_bonds(cube(6)).bonds.weighted_volume[0];
  const double error = std::abs(bonds.damage[0] - (1 - bonds.weighted_volume[0] / uncut));
  EXPECT_LE(test::measured("damage against weighted volumes", error), 1e-14);  // measured: 5.6e-17
}

TEST(Cracks, DamageIsTheShareOfTheWeightedVolume) {
  const body::fixture::TextFile file("row.csv", "x,y,z,volume\n0,0,0,1\n1,0,0,1\n2,0,0,1\n");
  deck::Deck deck = deck_of(deck::CloudFile{file.path()}, deck::Dimension::three, 1);
  add_crack(deck, deck::CrackDisc{{1.5, 0, 0}, {1, 0, 0}, 0.1});
  deck.horizon.ratio = 2.5;
  deck.quadrature = deck::Quadrature::whole;
  EXPECT_THAT(
      refusal([&] { build_bonds(deck); }),
      StartsWith("deck.yaml:4:5: particle 2 at (2, 0, 0) has lost all its bonds to pre-cracks; move the cracks"));
  const body::fixture::TextFile longer("row.csv", "x,y,z,volume\n0,0,0,1\n1,0,0,1\n2,0,0,1\n3,0,0,1\n");
  const auto [body, bonds] = build_bonds(deck);
  // Particle 0: bonds of length 1 (kept) and 2 (cut): 4 of 5 parts of omega xi^2.
  EXPECT_DOUBLE_EQ(bonds.damage[0], 0.8);
  EXPECT_DOUBLE_EQ(bonds.weighted_volume[0], 1);
  EXPECT_DOUBLE_EQ(bonds.damage[1], 5.0 / 6);
  EXPECT_EQ(bonds.cut, 6);
}

/// A segment in 2-D, a rectangle that stands on it and one that leans across it cut the same bonds.
TEST(Cracks, FlatBodiesAreCutWhereTheSurfaceMeetsTheirPlane) {
  std::vector<std::vector<LocalIndex>> found;
  const std::vector<decltype(deck::Crack::form)> forms = {
      deck::CrackSegment{{0, 5, 0}, {4.2, 5, 0}}, deck::CrackRectangle{{0, 5, -1}, {4.2, 0, 0}, {0, 0, 2}},
      deck::CrackRectangle{{-1, 5, -1}, {4.2, 0, 0}, {2, 0, 2}}, deck::CrackDisc{{2.1, 5, 0}, {0, 1, 0}, 2.1}};
  for (const auto& form : forms) {
    deck::Deck deck = square(10);
    add_crack(deck, form);
    const auto both = build_bonds(deck);
    EXPECT_GT(both.bonds.cut, 0);
    found.push_back(both.bonds.neighbor);
  }
  for (const auto& neighbors : found) EXPECT_EQ(neighbors, found[0]);
}

/// The stated rule: a particle in the plane belongs to the side of the normal.
TEST(Cracks, AParticleInThePlaneBelongsToTheNormalsSide) {
  const CrackSurface disc(crack_of(deck::CrackDisc{{0, 0, 0}, {0, 0, 2}, 1}), 1e-9);
  EXPECT_FALSE(disc.cuts({0, 0, 0}, {0, 0, 1}));
  EXPECT_TRUE(disc.cuts({0, 0, 0}, {0, 0, -1}));
  EXPECT_TRUE(disc.cuts({0, 0, -1}, {0, 0, 0}));
  EXPECT_FALSE(disc.cuts({0, 0, 0}, {0.5, 0, 0}));     // within the plane
  EXPECT_FALSE(disc.cuts({0, 0, -1e-12}, {0, 0, 1}));  // in the plane up to rounding
  EXPECT_TRUE(disc.cuts({0, 0, -1e-12}, {0, 0, -1}));
  const CrackSurface rectangle(crack_of(deck::CrackRectangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), 1e-9);
  EXPECT_FALSE(rectangle.cuts({0.5, 0.5, 0}, {0.5, 0.5, 1}));
  EXPECT_TRUE(rectangle.cuts({0.5, 0.5, 0}, {0.5, 0.5, -1}));
  // A segment going along x: its right-hand side is -y.
  const CrackSurface segment(crack_of(deck::CrackSegment{{0, 0, 0}, {1, 0, 0}}), 1e-9);
  EXPECT_FALSE(segment.cuts({0.5, 0, 0}, {0.5, -1, 0}));
  EXPECT_TRUE(segment.cuts({0.5, 0, 0}, {0.5, 1, 0}));
}

TEST(Cracks, TheEdgeCutsAndBeyondItNothing) {
  const CrackSurface rectangle(crack_of(deck::CrackRectangle{{0, 0, 0}, {2, 0, 0}, {1, 1, 0}}), 1e-9);
  EXPECT_TRUE(rectangle.cuts({0, 0, -1}, {0, 0, 1}));           // corner
  EXPECT_TRUE(rectangle.cuts({3, 1, -1}, {3, 1, 1}));           // the opposite one
  EXPECT_FALSE(rectangle.cuts({0.4, 0.5, -1}, {0.4, 0.5, 1}));  // in the box around it, not in it
  EXPECT_FALSE(rectangle.cuts({2, -1e-6, -1}, {2, -1e-6, 1}));
  EXPECT_FALSE(rectangle.cuts({1, 0.5, 1}, {1, 0.5, 2}));  // does not reach the plane
  const CrackSurface disc(crack_of(deck::CrackDisc{{0, 0, 0}, {0, 0, 1}, 1}), 1e-9);
  EXPECT_TRUE(disc.cuts({0.6, 0.8, -1}, {0.6, 0.8, 1}));
  EXPECT_FALSE(disc.cuts({0.6, 0.801, -1}, {0.6, 0.801, 1}));
}

/// Both directions of a bond agree, near edges and in the plane too.
TEST(Cracks, BothDirectionsAgree) {
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> place(-1, 1);
  std::uniform_int_distribution<int> lattice(-4, 4);
  const CrackSurface rectangle(crack_of(deck::CrackRectangle{{-0.5, -0.5, 0}, {0.7, 0.1, 0.3}, {0.1, 0.9, -0.1}}),
                               1e-9);
  const CrackSurface disc(crack_of(deck::CrackDisc{{0, 0, 0}, {1, 1, 0}, 0.5}), 1e-9);
  int cut = 0;
  for (int k = 0; k < 20000; ++k) {
    Point a, b;
    for (std::size_t c = 0; c < 3; ++c) {
      a[c] = k % 2 ? place(generator) : 0.25 * lattice(generator);
      b[c] = k % 2 ? place(generator) : 0.25 * lattice(generator);
    }
    for (const CrackSurface& surface : {rectangle, disc}) {
      EXPECT_EQ(surface.cuts(a, b), surface.cuts(b, a));
      cut += surface.cuts(a, b);
    }
  }
  EXPECT_GT(cut, 1000);
}

/// A crack through a layer of particle centres: the whole layer goes with one side, none of its bonds hangs loose.
TEST(Cracks, ThroughALayerOfCentresLeavesAWholeLayer) {
  for (const double spacing : {1.0, 0.1, 1e-3 / 3}) {
    deck::Deck deck = cube(7 * spacing, spacing);
    const double far = 8 * spacing;
    add_crack(deck, deck::CrackRectangle{{-spacing, -spacing, 3.5 * spacing}, {far, 0, 0}, {0, far, 0}});
    const auto cracked = build_bonds(deck);
    deck::Deck lower =
        deck_of(deck::Box{{0, 0, 0}, {7 * spacing, 7 * spacing, 3 * spacing}}, deck::Dimension::three, spacing);
    deck::Deck upper =
        deck_of(deck::Box{{0, 0, 0}, {7 * spacing, 7 * spacing, 4 * spacing}}, deck::Dimension::three, spacing);
    EXPECT_EQ(cracked.bonds.count(), build_bonds(lower).bonds.count() + build_bonds(upper).bonds.count()) << spacing;
  }
}

TEST(Cracks, Refusals) {
  struct Case {
    decltype(deck::Crack::form) form;
    const char* sentence;
  };
  const std::vector<Case> cases = {
      {deck::CrackDisc{{50, 0, 0}, {0, 0, 1}, 1}, "deck.yaml:30:5: this crack cuts no bond; move it into the body"},
      {deck::CrackDisc{{0, 0, 0}, {0, 0, 0}, 1}, "deck.yaml:30:5: the disc needs a normal that is not zero"},
      {deck::CrackRectangle{{0, 0, 0}, {1, 2, 3}, {2, 4, 6}},
       "deck.yaml:30:5: the two edges of the rectangle must be two different directions"},
      {deck::CrackSegment{{1, 1, 0}, {1, 1, 0}}, "deck.yaml:30:5: start and end of the segment are the same point"},
  };
  for (const Case& one : cases) {
    deck::Deck deck = cube(4);
    add_crack(deck, one.form);
    EXPECT_THAT(refusal([&] { build_bonds(deck); }), StartsWith(one.sentence));
  }
}

}  // namespace
}  // namespace perinox::bonds
