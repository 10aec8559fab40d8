/// Tests families, influence functions, quadratures and weighted volumes on lattices whose counts are known.
#include <cmath>

#include "support/bodies.hpp"
#include "support/measured.hpp"

namespace perinox::bonds {
namespace {

using namespace body::fixture;
using body::Body;
using ::testing::HasSubstr;
using ::testing::StartsWith;

const double kPi = std::acos(-1.0);

/// The particle in the middle of a lattice of odd edge.
LocalIndex middle(const Body& body) { return body.owned / 2; }

struct LatticeCase {
  double ratio;
  deck::Quadrature quadrature;
  int family;
  double moment_ratio;  ///< m over the continuum's; 0: not tested
};

/// Tests the neighbours of an inner particle of a cubic lattice, and m over its continuum value 4 pi d^5 / 5.
TEST(Families, CubicLatticeCounts) {
  const auto whole = deck::Quadrature::whole, partial = deck::Quadrature::partial_volume;
  const std::vector<LatticeCase> cases = {
      {2.015, whole, 32, 0},        {3.015, whole, 122, 1.131},   {3.015, partial, 178, 1.100},
      {4.015, whole, 256, 0.911},   {4.015, partial, 388, 1.048}, {5.015, whole, 514, 0.960},
      {5.015, partial, 738, 1.039},
  };
  for (const LatticeCase& one : cases) {
    deck::Deck deck = cube(13 * 0.1, 0.1);
    deck.horizon.ratio = one.ratio;
    deck.quadrature = one.quadrature;
    const auto [body, bonds] = build_bonds(deck);
    const LocalIndex i = middle(body);
    EXPECT_EQ(bonds.family_size(i), one.family) << one.ratio;
    const double ratio = bonds.weighted_volume[i] / bonds.continuum_weighted_volume;
    std::printf("horizon %.3f: %d bonds, m over continuum %.5f\n", one.ratio, bonds.family_size(i), ratio);
    if (one.moment_ratio > 0) {
      EXPECT_NEAR(ratio, one.moment_ratio, 6e-4) << one.ratio;  // measured: at most 4.5e-4, three digits being given
    }
  }
}

TEST(Families, SquareLatticeCounts) {
  for (const auto& [ratio, family] : {std::pair{1.015, 4}, {2.015, 12}, {3.015, 28}, {4.015, 48}}) {
    deck::Deck deck = square(11);
    deck.horizon.ratio = ratio;
    const auto [body, bonds] = build_bonds(deck);
    EXPECT_EQ(bonds.family_size(middle(body)), family);
  }
}

/// A horizon of exactly 3 spacings includes the neighbours at 3 spacings, at any scale.
TEST(Families, NeighboursAtExactlyTheHorizonAreIn) {
  for (const double spacing : {1.0, 0.1, 1e-3 / 3, 0.7e6}) {
    deck::Deck deck = cube(7 * spacing, spacing);
    deck.horizon.ratio = 3;
    const auto [body, bonds] = build_bonds(deck);
    EXPECT_EQ(bonds.family_size(middle(body)), 122) << spacing;
  }
}

/// With partial volumes, cells that only touch the horizon from outside (share 0 up to rounding) make no bond.
TEST(Families, CellsThatOnlyTouchTheHorizonAreOut) {
  for (const double spacing : {1.0, 0.1, 1e-3 / 3, 0.7e6}) {
    deck::Deck deck = cube(11 * spacing, spacing);
    deck.horizon.ratio = 3.5;
    deck.quadrature = deck::Quadrature::partial_volume;
    const auto [body, bonds] = build_bonds(deck);
    EXPECT_EQ(bonds.family_size(middle(body)), 250) << spacing;  // lattice points nearer than 4 spacings
  }
}

TEST(Families, AreSymmetricAndAscending) {
  deck::Deck deck = deck_of(deck::Sphere{{0, 0, 0}, 5});
  deck.quadrature = deck::Quadrature::partial_volume;
  deck.influence = deck::Influence::inverse;
  const auto [body, bonds] = build_bonds(deck);
  ASSERT_EQ(bonds.offset.size(), static_cast<std::size_t>(body.owned) + 1);
  for (LocalIndex i = 0; i < body.owned; ++i) {
    double moment = 0;
    for (auto k = bonds.offset[i]; k < bonds.offset[i + 1]; ++k) {
      const LocalIndex j = bonds.neighbor[k];
      if (k > bonds.offset[i]) {
        EXPECT_LT(bonds.neighbor[k - 1], j);
      }
      const auto back =
          std::lower_bound(bonds.neighbor.begin() + bonds.offset[j], bonds.neighbor.begin() + bonds.offset[j + 1], i) -
          bonds.neighbor.begin();
      ASSERT_EQ(bonds.neighbor[back], i);
      EXPECT_EQ(bonds.length[back], bonds.length[k]);  // to the last bit
      EXPECT_EQ(bonds.weight[back], bonds.weight[k]);
      EXPECT_EQ(bonds.influence[k], 1 / bonds.length[k]);
      moment += bonds.influence[k] * bonds.length[k] * bonds.length[k] * bonds.weight[k];
    }
    const double error = test::measured("m against its sum", std::abs(bonds.weighted_volume[i] / moment - 1));
    EXPECT_LE(error, 1e-14);  // measured: 0
    EXPECT_EQ(bonds.damage[i], 0);
  }
  EXPECT_EQ(bonds.cut, 0);
}

TEST(Quadrature, SharesOfANeighboursVolume) {
  const double horizon = 3, spacing = 0.5;
  struct Case {
    double length, whole, partial, taper;
  };
  for (const Case& one : std::vector<Case>{{1, 1, 1, 1},
                                           {2.75, 1, 1, 1},
                                           {2.875, 1, 0.75, 0.75},
                                           {3, 1, 0.5, 0.5},
                                           {3 * (1 + 1e-12), 1, 0.5, 0.5},
                                           {3.125, 0, 0.25, 0},
                                           {3.25, 0, 0, 0},
                                           {4, 0, 0, 0}}) {
    EXPECT_EQ(volume_share(deck::Quadrature::whole, one.length, horizon, spacing), one.whole);
    EXPECT_NEAR(volume_share(deck::Quadrature::partial_volume, one.length, horizon, spacing), one.partial, 1e-11);
    EXPECT_NEAR(volume_share(deck::Quadrature::taper_inside, one.length, horizon, spacing), one.taper, 1e-11);
  }
}

TEST(Influence, Values) {
  EXPECT_EQ(influence_value(deck::Influence::constant, 0.3, 2), 1);
  EXPECT_EQ(influence_value(deck::Influence::inverse, 0.25, 2), 4);
  EXPECT_EQ(influence_value(deck::Influence::polynomial, 1, 2), 0.5);
  EXPECT_EQ(influence_value(deck::Influence::polynomial, 2, 2), 0);
  EXPECT_EQ(influence_value(deck::Influence::polynomial, 2.5, 2), 0);
  EXPECT_NEAR(influence_value(deck::Influence::polynomial, 1e-9, 2), 1, 1e-15);
}

/// Compares the closed forms with the midpoint rule on 20000 shells. Measured: at most 2.1e-9 relative.
TEST(Influence, ContinuumWeightedVolumes) {
  const double horizon = 1.7;
  for (const auto kind : {deck::Influence::constant, deck::Influence::inverse, deck::Influence::polynomial}) {
    for (const int dimension : {2, 3}) {
      const int shells = 20000;
      double sum = 0;
      for (int k = 0; k < shells; ++k) {
        const double r = (k + 0.5) / shells * horizon;
        const double surface = dimension == 3 ? 4 * kPi * r * r : 2 * kPi * r;
        sum += influence_value(kind, r, horizon) * r * r * surface * horizon / shells;
      }
      const double ratio = continuum_weighted_volume(kind, horizon, dimension) / sum;
      EXPECT_NEAR(test::measured("continuum m against shells", std::abs(ratio - 1)), 0, 1e-8) << dimension;
    }
  }
}

/// Bonds at which the influence function vanishes carry nothing and are left out.
TEST(Influence, PolynomialFamiliesEndBeforeTheHorizon) {
  deck::Deck deck = cube(7);
  deck.horizon.ratio = 3;
  deck.influence = deck::Influence::polynomial;
  const auto [body, bonds] = build_bonds(deck);
  EXPECT_EQ(bonds.family_size(middle(body)), 92);  // 122 less the 30 at exactly 3 spacings
  for (const double value : bonds.influence) EXPECT_GT(value, 0);
}

TEST(Families, BodiesAreBondedUnlessAskedNotTo) {
  deck::Deck deck = deck_of(deck::Box{{0, 0, 0}, {4, 4, 4}});
  add_body(deck, "upper", deck::Box{{0, 0, 4}, {4, 4, 8}});
  const auto bonded = build_bonds(deck);
  deck::Deck tall = deck_of(deck::Box{{0, 0, 0}, {4, 4, 8}});
  EXPECT_EQ(bonded.bonds.count(), build_bonds(tall).bonds.count());
  deck.bond_bodies = false;
  const auto apart = build_bonds(deck);
  EXPECT_EQ(apart.bonds.count(), 2 * build_bonds(cube(4)).bonds.count());
  for (LocalIndex i = 0; i < apart.body.owned; ++i)
    for (auto k = apart.bonds.offset[i]; k < apart.bonds.offset[i + 1]; ++k)
      EXPECT_EQ(apart.body.part[i], apart.body.part[apart.bonds.neighbor[k]]);
  EXPECT_EQ(apart.bonds.damage[0], 0);  // a bond that is not asked for is not a broken one
}

/// With mixed spacings the share is that of a cell as wide as the mean of both, so it is the same from both ends.
TEST(Families, DifferentSpacingsShareTheirMean) {
  const body::fixture::TextFile file("pair.csv", "x,y,z,volume\n0,0,0,1\n3.2,0,0,8\n");
  deck::Deck deck = deck_of(deck::CloudFile{file.path()}, deck::Dimension::three, 2);
  deck.horizon.ratio.reset();
  deck.horizon.length = 3;
  deck.quadrature = deck::Quadrature::partial_volume;
  const auto [body, bonds] = build_bonds(deck);
  ASSERT_EQ(bonds.count(), 2);
  const double share = 0.5 - 0.2 / 1.5;
  EXPECT_NEAR(bonds.weight[0], 8 * share, 1e-14);
  EXPECT_NEAR(bonds.weight[1], share, 1e-14);
}

TEST(Families, EmptyOnesAreRefused) {
  EXPECT_EQ(refusal([] { build_bonds(cube(1)); }),
            "deck.yaml:4:5: particle 0 at (0.5, 0.5, 0.5) is the only one, so there is no bond; make the spacing "
            "smaller or add "
            "particles");
  deck::Deck far = cube(2);
  add_body(far, "speck", deck::Box{{20, 0, 0}, {21, 1, 1}});
  EXPECT_THAT(
      refusal([&] { build_bonds(far); }),
      StartsWith(
          "deck.yaml:4:5: particle 8 at (20.5, 0.5, 0.5) has no neighbour within the horizon 3.015; make the horizon"));
  deck::Deck small = cube(3);
  small.horizon.ratio = 0.9;
  EXPECT_THAT(refusal([&] { build_bonds(small); }),
              HasSubstr("the horizon 0.9 is shorter than the spacing 1 of the body block"));
  deck::Deck apart = cube(2);
  add_body(apart, "speck", deck::Box{{2, 0, 0}, {3, 1, 1}});
  apart.bond_bodies = false;
  EXPECT_THAT(refusal([&] { build_bonds(apart); }), HasSubstr("particle 8 at (2.5, 0.5, 0.5) has no neighbour of its "
                                                              "own body within the horizon"));
}

TEST(Reach, IsLongerForPartialVolumes) {
  deck::Deck deck = cube(3);
  EXPECT_DOUBLE_EQ(reach(deck, 3, 1), 3 * (1 + 1e-6));
  deck.quadrature = deck::Quadrature::partial_volume;
  EXPECT_DOUBLE_EQ(reach(deck, 3, 1), 3.5 * (1 + 1e-6));
  const Body body = body::build(cube(3), Communicator(), 2);
  EXPECT_THROW(build(deck, body, 3), std::logic_error);
}

}  // namespace
}  // namespace perinox::bonds
