/// Families that pre-cracks have cut, and bodies that form no bonds with each other: derivative, symmetry and balance
/// hold for what is left, flowing or not, because the weighted volume is that of what is left.
#include <gtest/gtest.h>

#include "perinox/mechanics/tangent_check.hpp"
#include "support/load_states.hpp"
#include "support/measured.hpp"

namespace perinox::test {
namespace {

void expect_sound(const deck::Deck& deck, Materials materials, bool flows) {
  const mechanics::Scene scene = make_scene(deck, std::move(materials));
  const Vector first = field_of(scene, {3.0}), field = field_of(scene, LoadState::Stop{4.0, 25});
  const mechanics::Committed committed = committed_after(scene, {first});
  const mechanics::TangentCheck check =
      mechanics::check_tangent(scene, committed, field, deck::TangentForm::consistent, true);
  EXPECT_EQ(check.yielding > 0, flows);
  EXPECT_LE(measured("cut families: tangent against central differences", check.direction), 1e-8);  // 4.0e-10
  EXPECT_LE(measured("cut families: asymmetry", check.symmetry), 1e-14);                            // 5.1e-17
  EXPECT_LE(measured("cut families: assembled against matrix-free", check.assembled), 1e-13);       // 7.4e-16
}

Materials plastic() {
  return materials_of(std::make_unique<materials::ElasticPlastic>(
      materials::ElasticPlastic::Parameters{bulk, shear, yield_shear, hardening_shear, false, true}));
}

TEST(CutFamilies, RectangleThroughHalfABlockThatFlows) {
  deck::Deck deck = lattice_deck(deck::Dimension::three, {6, 6, 6}, 0.4, 3.015);
  deck.cracks.push_back({{}, deck::CrackRectangle{{-1, -1, 1.2}, {2.2, 0, 0}, {0, 4, 0}}});
  const mechanics::Scene scene = make_scene(deck, plastic());
  EXPECT_GT(scene.bonds().cut, 0);
  for (const deck::Quadrature quadrature : {deck::Quadrature::whole, deck::Quadrature::partial_volume}) {
    deck.quadrature = quadrature;
    expect_sound(deck, plastic(), true);
  }
}

TEST(CutFamilies, SegmentInAPlateInPlaneStress) {
  deck::Deck deck = lattice_deck(deck::Dimension::plane_stress, {10, 10, 1}, 0.4, 3.015);
  deck.cracks.push_back({{}, deck::CrackSegment{{-1, 2.0, 0}, {2.0, 2.0, 0}}});
  expect_sound(deck, materials_of(std::make_unique<materials::Elastic>(bulk, shear, true)), false);
}

TEST(CutFamilies, BodiesThatDoNotBond) {
  deck::Deck deck = empty_deck(deck::Dimension::three, 0.9, 1);
  add_box(deck, {0, 0, 0}, {1.2, 1.2, 1.2}, 0.4, 0);
  add_box(deck, {1.2, 0, 0}, {2.4, 1.2, 1.2}, 0.4, 0);
  deck.bond_bodies = false;
  const mechanics::Scene scene = make_scene(deck, plastic());
  for (LocalIndex i = 0; i < scene.owned(); ++i)
    for (std::int64_t b = scene.bonds().offset[i]; b < scene.bonds().offset[i + 1]; ++b)
      ASSERT_EQ(scene.body().part[i], scene.body().part[scene.bonds().neighbor[b]]);
  expect_sound(deck, plastic(), true);
}

}  // namespace
}  // namespace perinox::test
