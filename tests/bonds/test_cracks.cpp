/// Tests pre-cracks: which bonds they cut, the damage they leave, and the rule for particles in the crack's plane.
#include <cmath>
#include <random>

#include "perinox/body/crack_surface.hpp"
#include "support/bodies.hpp"
#include "support/measured.hpp"

namespace perinox::bonds {
namespace {

using namespace body::fixture;
using body::CrackSurface;
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
  // m of the remaining bonds is that of a free surface at that place.
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
  // Particle 0 has bonds of length 1 (kept) and 2 (cut), so 4 of 5 parts of omega xi^2 are cut.
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

/// A point on the surface would be on neither side. Bonds of points in its plane beyond it are whole.
TEST(Cracks, APointOnTheSurfaceIsOnNeitherSide) {
  const CrackSurface disc(crack_of(deck::CrackDisc{{0, 0, 0}, {0, 0, 2}, 1}), 1e-9);
  EXPECT_TRUE(disc.holds({0, 0, 0}));
  EXPECT_TRUE(disc.holds({0, 0, 1e-12}));  // up to rounding
  EXPECT_TRUE(disc.holds({0.6, 0.8, 0}));  // on the edge
  EXPECT_FALSE(disc.holds({0, 0, 1e-6}));
  EXPECT_FALSE(disc.holds({0.6, 0.81, 0}));
  EXPECT_FALSE(disc.cuts({0.6, 0.81, 0}, {0, 0, 1}));
  EXPECT_FALSE(disc.cuts({0.6, 0.81, 0}, {0, 0, -1}));
  EXPECT_FALSE(disc.cuts({-2, 0, 0}, {2, 0, 0}));  // along the plane, across the disc
  for (const double side : {1.0, -1.0}) {          // from either end of the segment
    const CrackSurface segment(crack_of(deck::CrackSegment{{0.5 - side / 2, 0, 0}, {0.5 + side / 2, 0, 0}}), 1e-9);
    EXPECT_TRUE(segment.holds({0.5, 0, 0}));
    EXPECT_TRUE(segment.holds({1, 0, 0}));
    EXPECT_FALSE(segment.holds({1.1, 0, 0}));
    EXPECT_FALSE(segment.cuts({1.1, 0, 0}, {0.5, -1, 0}));
    EXPECT_FALSE(segment.cuts({1.1, 0, 0}, {0.5, 1, 0}));
    EXPECT_TRUE(segment.cuts({0.5, -1, 0}, {0.5, 1, 0}));
  }
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

/// Both directions of a bond agree, also near edges and in the plane.
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

/// Number of directed bonds of a 12 by 12 lattice of spacing 1 that cross the segment (off, 0)-(6 + off, 6), from the
/// signs of cross products.
long long crossing_a_diagonal(double off) {
  const auto above = [&](double x, double y) { return y - (x - off) > 0; };
  long long count = 0;
  for (int i = 0; i < 144; ++i)
    for (int j = 0; j < 144; ++j) {
      const double ax = i % 12 + 0.5, ay = i / 12 + 0.5, bx = j % 12 + 0.5, by = j / 12 + 0.5;
      if (i == j || std::hypot(bx - ax, by - ay) > 3.015 || above(ax, ay) == above(bx, by)) continue;
      // The ends of the segment lie on different sides of the bond's line, or on it.
      const double start = (bx - ax) * (0 - ay) - (by - ay) * (off - ax);
      const double end = (bx - ax) * (6 - ay) - (by - ay) * (6 + off - ax);
      if (start * end <= 0) ++count;
    }
  return count;
}

/// A crack through particle centres would take one side or the other by rounding. It is refused wherever it lies and
/// however it is written; a quarter of a spacing off it is not.
TEST(Cracks, ThroughCentresAreRefused) {
  const double far_x = 500000.5, far_y = 4600000.5;
  const long long crossing = crossing_a_diagonal(0.25);
  EXPECT_GT(crossing, 100);
  for (const double spacing : {1.0, 0.1, 1e-12, 1e-3 / 3})
    for (const bool far : {false, true})
      for (const bool swapped : {false, true}) {
        if (far && spacing != 0.1 && spacing != 1) continue;
        const double x = far ? far_x : 0, y = far ? far_y : 0, edge = 12 * spacing;
        const auto cracked = [&](double off) {
          deck::Deck deck =
              deck_of(deck::Box{{x, y, 0}, {x + edge, y + edge, 0}}, deck::Dimension::plane_stress, spacing);
          deck::CrackSegment segment{{x + off, y, 0}, {x + edge / 2 + off, y + edge / 2, 0}};
          if (swapped) std::swap(segment.start, segment.end);
          add_crack(deck, segment);
          return deck;
        };
        EXPECT_THAT(refusal([&] { build_bonds(cracked(0)); }),
                    StartsWith("deck.yaml:30:5: this crack runs through the centre of particle 0 at ("))
            << spacing << far << swapped;
        EXPECT_EQ(build_bonds(cracked(0.25 * spacing)).bonds.cut, crossing) << spacing << far << swapped;
      }
  EXPECT_THAT(refusal([] {
                deck::Deck deck = cube(7);
                add_crack(deck, deck::CrackRectangle{{-1, -1, 3.5}, {8, 0, 0}, {0, 8, 0}});
                build_bonds(deck);
              }),
              StartsWith("deck.yaml:30:5: this crack runs through the centre of particle 147 at (0.5, 0.5, 3.5) and of "
                         "48 more, which would be on neither side of it; move the crack by a part of the spacing, for "
                         "example by 0.25 along its normal (0, 0, 1)"));
}

/// Two cracks that meet part a plate, from whichever ends they are written.
TEST(Cracks, TwoThatMeetPartThePlate) {
  deck::Deck whole = square(13);
  add_crack(whole, deck::CrackSegment{{-1, 6, 0}, {14, 6, 0}});
  const auto parted = build_bonds(whole);
  deck::Deck two = square(13);
  add_crack(two, deck::CrackSegment{{-1, 6, 0}, {6.3, 6, 0}});
  add_crack(two, deck::CrackSegment{{14, 6, 0}, {6.3, 6, 0}});
  const auto both = build_bonds(two);
  EXPECT_EQ(both.bonds.neighbor, parted.bonds.neighbor);
  deck::Deck through = square(13);
  add_crack(through, deck::CrackSegment{{-1, 6.5, 0}, {6, 6.5, 0}});
  add_crack(through, deck::CrackSegment{{13, 6.5, 0}, {6, 6.5, 0}});
  EXPECT_THAT(refusal([&] { build_bonds(through); }),
              StartsWith("deck.yaml:30:5: this crack runs through the centre of particle 78 at (0.5, 6.5, 0)"));
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
