/// Two and three bodies of two materials and unequal spacings, bonded to each other: symmetry, balance and the
/// derivative hold across materials, where a bond has an elastic family at one end and a flowing one at the other.
#include <gtest/gtest.h>

#include <set>

#include "support/load_states.hpp"
#include "support/measured.hpp"

namespace perinox::test {
namespace {

Materials elastic_and_plastic() {
  return materials_of(std::make_unique<materials::Elastic>(3 * bulk, 2 * shear, true),
                      std::make_unique<materials::ElasticPlastic>(materials::ElasticPlastic::Parameters{
                          bulk, shear, yield_shear, hardening_shear, false, true}));
}

/// Side by side along x, the second with a finer lattice.
deck::Deck two_bodies() {
  deck::Deck deck = empty_deck(deck::Dimension::three, 0.9, 2);
  add_box(deck, {0, 0, 0}, {1.2, 1.2, 1.2}, 0.4, 0);
  add_box(deck, {1.2, 0, 0}, {2.4, 1.2, 1.2}, 0.3, 1);
  return deck;
}

/// A third one on top of both, of the first one's material.
deck::Deck three_bodies() {
  deck::Deck deck = two_bodies();
  add_box(deck, {0, 0, 1.2}, {2.4, 1.2, 1.9}, 0.35, 0);
  return deck;
}

deck::Deck two_plates() {
  deck::Deck deck = empty_deck(deck::Dimension::plane_strain, 0.9, 2);
  add_box(deck, {0, 0, 0}, {2.0, 1.2, 0}, 0.4, 0);
  add_box(deck, {0, 1.2, 0}, {2.0, 2.4, 0}, 0.25, 1);
  return deck;
}

void expect_sound(deck::Deck deck, const std::function<Materials()>& materials, bool flows) {
  for (deck::Quadrature quadrature :
       {deck::Quadrature::whole, deck::Quadrature::partial_volume, deck::Quadrature::taper_inside})
    for (deck::Influence influence :
         {deck::Influence::constant, deck::Influence::inverse, deck::Influence::polynomial}) {
      SCOPED_TRACE(std::string(name_of(quadrature)) + " " + name_of(influence));
      deck.quadrature = quadrature;
      deck.influence = influence;
      const mechanics::Scene scene = make_scene(deck, materials());
      // Bonds do cross the interface, both ways.
      std::set<std::pair<int, int>> pairs;
      for (LocalIndex i = 0; i < scene.owned(); ++i)
        for (std::int64_t b = scene.bonds().offset[i]; b < scene.bonds().offset[i + 1]; ++b)
          pairs.emplace(scene.body().material[i], scene.body().material[scene.bonds().neighbor[b]]);
      ASSERT_EQ(pairs.size(), 4u);

      for (const LoadState::Stop& stop : {LoadState::Stop{0.1}, LoadState::Stop{4.0, 25}}) {
        const Vector first = field_of(scene, {3.0}), field = field_of(scene, stop);
        const mechanics::Committed committed = committed_after(scene, {first});
        const Answer answer = internal_force(scene, committed, field);
        if (flows) {
          EXPECT_GT(answer.trial.yielding, 0);
          EXPECT_LT(answer.trial.yielding, scene.owned());
        }
        Vector resultant(3, 0.0);
        double size = 0;
        for (std::size_t u = 0; u < answer.force.size(); ++u) {
          resultant[u % scene.dimension()] += answer.force[u];
          size += std::abs(answer.force[u]);
        }
        EXPECT_LE(measured("several bodies: total force", largest_magnitude(resultant) / size), 1e-14);  // 7.3e-17

        mechanics::MatrixFreeTangent tangent(scene);
        tangent.linearise(committed, field.data(), deck::TangentForm::consistent);
        EXPECT_LE(measured("several bodies: asymmetry",
                           asymmetry(tangent, random_field(scene, 1, 41), random_field(scene, 1, 42))),
                  1e-14);  // 1.6e-16
        EXPECT_LE(measured("several bodies: tangent against central differences",
                           tangent_error(scene, committed, field, random_field(scene, 1, 43), tangent)),
                  1e-8);  // 2.8e-10
      }
    }
}

TEST(SeveralBodies, TwoOfTwoMaterials) { expect_sound(two_bodies(), elastic_and_plastic, true); }

TEST(SeveralBodies, ThreeOfTwoMaterials) { expect_sound(three_bodies(), elastic_and_plastic, true); }

TEST(SeveralBodies, TwoPlates) {
  expect_sound(
      two_plates(),
      [] {
        return materials_of(std::make_unique<materials::Elastic>(3 * bulk, 2 * shear, true),
                            std::make_unique<materials::Elastic>(bulk, shear, true));
      },
      false);
}

TEST(SeveralBodies, HistoryBelongsToThePlasticParticlesOnly) {
  const mechanics::Scene scene = make_scene(two_bodies(), elastic_and_plastic());
  for (LocalIndex i = 0; i < scene.owned(); ++i) {
    const bool plastic = scene.body().material[i] == 1;
    EXPECT_EQ(scene.point_history()[i + 1] - scene.point_history()[i], plastic ? 2 : 0);
  }
}

}  // namespace
}  // namespace perinox::test
