/// Lengths that cannot belong together are refused at the key that is wrong, and others are not.
#include "body/lengths.hpp"
#include "support/bodies.hpp"

namespace perinox::body {
namespace {

using namespace fixture;

std::string refusal_of(const deck::Deck& deck, double reach) {
  return refusal([&] { refuse_unfit_lengths(deck, reach, reach); });
}

deck::Deck placed_deck(const deck::Box& box, double spacing) {
  deck::Deck deck = deck_of(box, deck::Dimension::three, spacing);
  deck.body[0].spacing_location = {"deck.yaml", 6, 14};
  deck.horizon.location = {"deck.yaml", 8, 10};
  return deck;
}

TEST(Lengths, ASpacingLargerThanTheBodyIsRefusedAtTheSpacing) {
  const std::string sentence = refusal_of(placed_deck({{0, 0, 0}, {3, 3, 4}}, 50), 150);
  EXPECT_EQ(
      sentence,
      "deck.yaml:6:14: the spacing 50 is larger than the whole body block, whose longest side is 4; make it a tenth "
      "of that or less, or check that both are in the same unit");
  // The horizon is not to blame if the spacing is wrong.
  EXPECT_EQ(refusal_of(placed_deck({{0, 0, 0}, {3, 3, 4}}, 50), 3), sentence);
}

TEST(Lengths, AHorizonShorterThanTheSpacingIsRefusedAtTheHorizon) {
  EXPECT_EQ(
      refusal_of(placed_deck({{0, 0, 0}, {3, 3, 4}}, 1), 0.5),
      "deck.yaml:8:10: the horizon 0.5 is shorter than the spacing 1 of the body block, so that its particles have no "
      "neighbours; a horizon of 3 spacings is usual: make it 3, or the spacing smaller");
}

/// These lengths fit: one particle in its own cell, far from the origin where the cell's length has lost digits; a thin
/// layer; a horizon of one spacing.
TEST(Lengths, OthersFit) {
  const std::string none = "nothing was refused";
  EXPECT_EQ(refusal_of(placed_deck({{500000.5, 4600000.5, 0}, {500000.6, 4600000.6, 0.1}}, 0.1), 0.3), none);
  EXPECT_EQ(refusal_of(placed_deck({{0, 0, 0}, {5, 5, 0.01}}, 1), 3), none);
  EXPECT_EQ(refusal_of(placed_deck({{0, 0, 0}, {3, 3, 4}}, 0.1), 0.1), none);
}

}  // namespace
}  // namespace perinox::body
