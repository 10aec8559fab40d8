/// Removes bonds from either layout. each() and places() must show what is left, remove() must return what was removed,
/// and a bond that is not there cannot be removed.
#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "perinox/bonds/lattice_families.hpp"
#include "perinox/bonds/pair_families.hpp"
#include "support/bodies.hpp"

namespace perinox::bonds {
namespace {

using namespace body::fixture;
using Ends = std::pair<LocalIndex, LocalIndex>;

Ends sorted(LocalIndex i, LocalIndex j) { return {std::min(i, j), std::max(i, j)}; }

std::vector<FoundBond> family_of(const Bonds& bonds, LocalIndex i) {
  std::vector<FoundBond> family;
  for (auto b = bonds.offset[i]; b < bonds.offset[i + 1]; ++b)
    family.push_back({bonds.neighbor[b], bonds.length[b], bonds.weight[b], bonds.influence[b]});
  return family;
}

LatticeFamilies lattice_of(const Bonded& both) {
  LatticeFamilies lattice(both.body, *find_grid(both.body));
  for (LocalIndex i = 0; i < both.body.owned; ++i) lattice.receive(i, family_of(both.bonds, i), both.body);
  lattice.complete();
  return lattice;
}

PairFamilies pairs_of(const Bonded& both) {
  const std::vector<LocalIndex> order = curve_order(both.body);
  PairFamilies pairs(both.body, order);
  for (const LocalIndex i : order) pairs.receive(i, family_of(both.bonds, i), both.body);
  pairs.complete();
  return pairs;
}

std::set<Ends> bonds_in(const Bonds& bonds) {
  std::set<Ends> all;
  for (LocalIndex i = 0; i + 1 < static_cast<LocalIndex>(bonds.offset.size()); ++i)
    for (auto b = bonds.offset[i]; b < bonds.offset[i + 1]; ++b) all.insert(sorted(i, bonds.neighbor[b]));
  return all;
}

/// The set of all bonds. A bond that comes twice is a failure.
template <class Families>
std::set<Ends> each_of(const Families& families) {
  std::set<Ends> all;
  families.each([&](LocalIndex i, LocalIndex j, auto&&...) { EXPECT_TRUE(all.insert(sorted(i, j)).second); });
  return all;
}

std::set<Ends> places_of(const LatticeFamilies& families, const body::Body& body) {
  std::set<Ends> all;
  std::vector<LatticeFamilies::Place> places;
  for (LocalIndex i = 0; i < body.owned; ++i) {
    families.places(i, places);
    for (const auto& place : places) all.insert(sorted(i, place.neighbor));
  }
  return all;
}

std::set<Ends> places_of(const PairFamilies& families, const body::Body& body) {
  std::set<Ends> all;
  const auto every = families.places();
  for (LocalIndex i = 0; i < body.owned; ++i)
    for (const auto& place : every[i]) all.insert(sorted(i, place.neighbor));
  return all;
}

double length_of(const StencilOffset* removed) { return removed ? removed->length : 0; }
double length_of(const PairFamilies::Removed& removed) { return removed.length; }
double weight_of(const StencilOffset* removed) { return removed->influence * removed->share; }
double weight_of(const PairFamilies::Removed& removed) { return removed.weight; }

/// Removes every bond in random order, and checks what is left after a third, two thirds and all.
template <class Families>
void take_apart(Families families, const Bonded& both) {
  std::set<Ends> left = bonds_in(both.bonds);
  ASSERT_EQ(each_of(families), left);
  std::vector<Ends> order(left.begin(), left.end());
  std::mt19937 generator(3);
  std::shuffle(order.begin(), order.end(), generator);
  const std::size_t third = order.size() / 3;
  for (std::size_t k = 0; k < order.size(); ++k) {
    const auto [i, j] = order[k];
    const auto begin = both.bonds.neighbor.begin() + both.bonds.offset[i];
    const auto b =
        std::find(begin, both.bonds.neighbor.begin() + both.bonds.offset[i + 1], j) - both.bonds.neighbor.begin();
    const auto removed = k % 2 ? families.remove(i, j) : families.remove(j, i);  // either end first
    ASSERT_NEAR(length_of(removed), both.bonds.length[b], 1e-14 * both.bonds.length[b]);
    ASSERT_NEAR(weight_of(removed), both.bonds.influence[b] * both.bonds.weight[b] / both.body.volume[j], 1e-13);
    ASSERT_EQ(length_of(families.remove(i, j)), 0);
    left.erase(order[k]);
    if ((k + 1) % third != 0 && k + 1 != order.size()) continue;
    EXPECT_EQ(each_of(families), left);
    EXPECT_EQ(places_of(families, both.body), left);
  }
  EXPECT_TRUE(left.empty());
}

TEST(RemovedBonds, OfBothLayoutsInSpaceAndInThePlane) {
  for (const bool flat : {false, true})
    for (const auto quadrature : {deck::Quadrature::whole, deck::Quadrature::partial_volume})
      for (const auto influence : {deck::Influence::constant, deck::Influence::polynomial}) {
        deck::Deck deck = flat ? square(13) : deck_of(deck::Box{{0, 0, 0}, {9, 5, 4}});
        deck.horizon.ratio = flat ? 3.015 : 2.015;
        deck.quadrature = quadrature;
        deck.influence = influence;
        const Bonded both = build_bonds(deck);
        take_apart(lattice_of(both), both);
        take_apart(pairs_of(both), both);
      }
}

TEST(RemovedBonds, WhatWasNeverABondCannotBeRemoved) {
  const Bonded both = build_bonds(cube(9));
  LatticeFamilies lattice = lattice_of(both);
  PairFamilies pairs = pairs_of(both);
  EXPECT_EQ(lattice.remove(0, 8), nullptr);
  EXPECT_EQ(pairs.remove(0, 8).length, 0);
  EXPECT_EQ(each_of(lattice), bonds_in(both.bonds));
  EXPECT_EQ(each_of(pairs), bonds_in(both.bonds));
}

}  // namespace
}  // namespace perinox::bonds
