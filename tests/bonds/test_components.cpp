#include <set>

#include "perinox/bonds/components.hpp"
#include "support/bodies.hpp"

namespace perinox::bonds {
namespace {

using namespace body::fixture;

Components components_of(const deck::Deck& deck) {
  const auto [body, bonds] = build_bonds(deck, Communicator(MPI_COMM_SELF));
  return connected_components(body, bond_graph(bonds));
}

TEST(Components, ABodyIsOnePiece) {
  const Components cube_pieces = components_of(cube(6));
  EXPECT_EQ(cube_pieces.count(), 1);
  EXPECT_EQ(cube_pieces.first, std::vector<GlobalId>{0});
  EXPECT_EQ(cube_pieces.particles, std::vector<long long>{216});
  EXPECT_EQ(std::set<int>(cube_pieces.of.begin(), cube_pieces.of.end()), std::set<int>{0});
}

TEST(Components, ACrackAcrossTheBodyMakesTwo) {
  deck::Deck deck = cube(6);
  add_crack(deck, deck::CrackRectangle{{-1, -1, 2}, {9, 0, 0}, {0, 9, 0}});
  const Components pieces = components_of(deck);
  EXPECT_EQ(pieces.first, (std::vector<GlobalId>{0, 72}));
  EXPECT_EQ(pieces.particles, (std::vector<long long>{72, 144}));
  for (std::size_t i = 0; i < pieces.of.size(); ++i) EXPECT_EQ(pieces.of[i], i < 72 ? 0 : 1);
}

TEST(Components, ACrackThatEndsInTheBodyMakesNone) {
  deck::Deck deck = cube(6);
  add_crack(deck, deck::CrackRectangle{{-1, -1, 2}, {6, 0, 0}, {0, 9, 0}});
  EXPECT_EQ(components_of(deck).count(), 1);
}

TEST(Components, BodiesWithoutBondsBetweenThemAreApart) {
  deck::Deck deck = deck_of(deck::Box{{0, 0, 0}, {4, 4, 4}});
  add_body(deck, "lid", deck::Box{{0, 0, 4}, {4, 4, 6}});
  EXPECT_EQ(components_of(deck).count(), 1);
  deck.bond_bodies = false;
  EXPECT_EQ(components_of(deck).particles, (std::vector<long long>{64, 32}));
}

/// A graph needs no stored bonds. This one has the pairs 0-1, 2-3, ... in descending order of discovery.
TEST(Components, TakeAnyGraph) {
  body::Body body = build_body(cube(4), Communicator(MPI_COMM_SELF));
  const Components pairs =
      connected_components(body, [](LocalIndex i, std::vector<LocalIndex>& neighbors) { neighbors.assign(1, i ^ 1); });
  EXPECT_EQ(pairs.count(), 32);
  for (LocalIndex i = 0; i < 64; ++i) EXPECT_EQ(pairs.of[i], i / 2);
  const Components chain = connected_components(body, [](LocalIndex i, std::vector<LocalIndex>& neighbors) {
    neighbors.clear();
    if (i > 0) neighbors.push_back(63 - (63 - i + 1) % 64);
    if (i < 63) neighbors.push_back(i + 1);
  });
  EXPECT_EQ(chain.count(), 1);
}

}  // namespace
}  // namespace perinox::bonds
