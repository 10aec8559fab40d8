/// A lattice body swept by its stencil and the same body swept pair by pair answer alike, for every material, state,
/// influence function and quadrature, with pre-cracks, in every dimension; and both like the stored tangent, which is
/// written bond by bond.
#include <gtest/gtest.h>

#include "support/load_states.hpp"
#include "support/measured.hpp"

namespace perinox::test {
namespace {

struct Answers {
  Vector force, product, blocks;
  mechanics::Trial trial;
};

Answers answers_of(const mechanics::Scene& scene, const LoadState& state, mechanics::Tangent& tangent) {
  std::vector<Vector> fields = fields_of(scene, state);
  const Vector here = fields.back();
  fields.pop_back();
  const mechanics::Committed committed = committed_after(scene, fields);
  Answers answers;
  Answer answer = internal_force(scene, committed, here);
  answers.force = std::move(answer.force);
  answers.trial = std::move(answer.trial);
  tangent.linearise(committed, here.data(), deck::TangentForm::consistent);
  answers.product = times(tangent, random_field(scene, 1, 71));
  answers.blocks.resize(scene.owned_unknowns() * static_cast<std::size_t>(scene.dimension()));
  tangent.diagonal_blocks(answers.blocks.data());
  return answers;
}

/// blocks: of a fitted family, what its rank-one terms put into its neighbours' blocks is an approximation.
void expect_alike(const Answers& a, const Answers& b, double blocks = 1e-12) {
  EXPECT_LE(measured("layouts: force", relative_difference(a.force, b.force)), 1e-12);
  EXPECT_LE(measured("layouts: product", relative_difference(a.product, b.product)), 1e-12);
  EXPECT_LE(measured("layouts: diagonal blocks", relative_difference(a.blocks, b.blocks)), blocks);
  EXPECT_EQ(a.trial.yielding, b.trial.yielding);
}

/// blocks: the bound on the diagonal blocks of the stored tangent.
void expect_alike_in_all_states(const MaterialRow& row, const mechanics::Scene& lattice, const mechanics::Scene& pairs,
                                double blocks) {
  for (const LoadState& state : load_states()) {
    if (state.needs_plasticity && row.surface.empty()) continue;
    SCOPED_TRACE(row.name + " " + state.name);
    mechanics::MatrixFreeTangent on_lattice(lattice), on_pairs(pairs);
    mechanics::StoredTangent stored(lattice);
    const Answers first = answers_of(lattice, state, on_lattice);
    expect_alike(first, answers_of(pairs, state, on_pairs));
    expect_alike(first, answers_of(lattice, state, stored), blocks);
  }
}

class Layouts : public ::testing::TestWithParam<std::tuple<int, bool, bool>> {};

TEST_P(Layouts, AnswerAlike) {
  const auto& [row_number, cracked, small] = GetParam();
  const MaterialRow row = material_table()[static_cast<std::size_t>(row_number)];
  const bool flat = row.dimension == 2;
  for (deck::Influence influence : {deck::Influence::constant, deck::Influence::inverse, deck::Influence::polynomial})
    for (deck::Quadrature quadrature :
         {deck::Quadrature::whole, deck::Quadrature::partial_volume, deck::Quadrature::position_aware}) {
      deck::Deck deck = flat ? lattice_deck(deck::Dimension::plane_strain, {11, 9, 1}, 0.4, 3.015)
                             : lattice_deck(deck::Dimension::three, {9, 5, 6}, 0.4, 2.2);
      deck.influence = influence;
      deck.quadrature = quadrature;
      deck.small_strain = small;
      deck::Crack crack;
      crack.form = deck::CrackRectangle{{1.2, -1, 1.2}, {9, 0, 0}, {0, 9, 0}};
      if (flat) crack.form = deck::CrackSegment{{1.2, 1.6, 0}, {9, 1.6, 0}};
      if (cracked) deck.cracks.push_back(crack);
      const mechanics::Scene lattice = make_scene(deck, materials_of(row.make()));
      const mechanics::Scene pairs = make_scene(deck, materials_of(row.make()), mechanics::Layout::pairs);
      ASSERT_NE(lattice.lattice(), nullptr);
      ASSERT_NE(pairs.pairs(), nullptr);
      ASSERT_EQ(lattice.bonds().neighbor, pairs.bonds().neighbor);
      ASSERT_EQ(lattice.families().cut > 0, cracked);
      const bool fitted = !lattice.families().moments.empty();
      EXPECT_EQ(fitted, quadrature == deck::Quadrature::position_aware && lattice.materials()[0]->takes_fit());
      expect_alike_in_all_states(row, lattice, pairs, fitted ? 0.9 : 1e-12);  // 0.69: families of 7 to 32 bonds
    }
}

/// Particles of a ball or a disc have parts of their cells at its surface: the one thing that differs in a lattice.
TEST_P(Layouts, AnswerAlikeWhereCellsAreCut) {
  const auto& [row_number, cracked, small] = GetParam();
  const MaterialRow row = material_table()[static_cast<std::size_t>(row_number)];
  const bool flat = row.dimension == 2;
  deck::Deck deck = empty_deck(flat ? deck::Dimension::plane_strain : deck::Dimension::three, flat ? 1.206 : 0.88);
  deck.quadrature = deck::Quadrature::position_aware;
  deck.small_strain = small;
  add_box(deck, {}, {}, 0.4, 0);
  deck.body[0].shape.form = deck::Sphere{{0, 0, 0}, flat ? 2.1 : 1.3};
  deck.body[0].cut_cells = true;
  deck::Crack crack;
  crack.form = deck::CrackRectangle{{0.3, -2, 0.3}, {9, 0, 0}, {0, 9, 0}};
  if (flat) crack.form = deck::CrackSegment{{0.3, 0.2, 0}, {9, 0.2, 0}};
  if (cracked) deck.cracks.push_back(crack);
  const mechanics::Scene lattice = make_scene(deck, materials_of(row.make()));
  const mechanics::Scene pairs = make_scene(deck, materials_of(row.make()), mechanics::Layout::pairs);
  ASSERT_NE(lattice.lattice(), nullptr);
  const auto [least, most] = std::minmax_element(lattice.body().volume.begin(), lattice.body().volume.end());
  ASSERT_GT(*most, 1.1 * *least);
  expect_alike_in_all_states(row, lattice, pairs, 0.95);
}

/// A tangent that says it is still the last one answers as one made here for the first time; elastic ones of bonds that
/// keep their direction say so, all others do not.
TEST(Layouts, ATangentIsKeptWhereNothingOfItHasChanged) {
  for (const MaterialRow& row : material_table())
    for (const bool small : {true, false})
      for (const deck::Quadrature quadrature : {deck::Quadrature::whole, deck::Quadrature::position_aware}) {
        const mechanics::Scene scene = small_scene(row, deck::Influence::inverse, quadrature, small);
        for (const LoadState& state : load_states()) {
          if (state.needs_plasticity && row.surface.empty()) continue;
          SCOPED_TRACE(row.name + " " + state.name + (small ? " small strain" : ""));
          mechanics::MatrixFreeTangent kept(scene), fresh(scene);
          const mechanics::Committed start(scene);
          const Vector rest(scene.owned_unknowns(), 0.0);
          EXPECT_TRUE(kept.linearise(start, rest.data(), deck::TangentForm::consistent));
          std::vector<Vector> fields = fields_of(scene, state);
          const Vector here = fields.back();
          fields.pop_back();
          const mechanics::Committed committed = committed_after(scene, fields);
          const bool changed = kept.linearise(committed, here.data(), deck::TangentForm::consistent);
          fresh.linearise(committed, here.data(), deck::TangentForm::consistent);
          const Vector direction = random_field(scene, 1, 71);
          EXPECT_EQ(times(kept, direction), times(fresh, direction));
          if (row.surface.empty()) {
            EXPECT_EQ(changed, !small);
          }
          if (changed) {
            EXPECT_EQ(kept.linearise(start, rest.data(), deck::TangentForm::consistent), true);
          }
        }
      }
}

INSTANTIATE_TEST_SUITE_P(Materials, Layouts,
                         ::testing::Combine(::testing::Range(0, static_cast<int>(material_table().size())),
                                            ::testing::Bool(), ::testing::Bool()));

}  // namespace
}  // namespace perinox::test
