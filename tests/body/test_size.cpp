/// Scenes that cannot be computed are refused before anything is allocated for them, with the estimate.
#include "body/size.hpp"
#include "support/bodies.hpp"

namespace perinox::body {
namespace {

using ::testing::HasSubstr;

deck::Deck block(double edge, double spacing) {
  deck::Deck deck;
  deck::BodyPart part;
  part.location = {"deck.yaml", 3, 5};
  part.name = "block";
  part.spacing = spacing;
  part.shape.location = {"deck.yaml", 4, 12};
  part.shape.form = deck::Box{{0, 0, 0}, {edge, edge, edge}};
  deck.body.push_back(part);
  deck.horizon.location = {"deck.yaml", 6, 10};
  return deck;
}

template <class Work>
std::string sentence_of(Work&& work) {
  try {
    work();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Size, FewParticlesAreCountedAndManyEstimated) {
  EXPECT_EQ(about_particles(block(10, 1).body[0], 3), 1000);
  deck::Deck ball = block(1, 0.01);
  ball.body[0].shape.form = deck::Sphere{{0, 0, 0}, 1};
  // The exact number is 4 pi/3 1e6 centres; measured: 0.9986 of them.
  EXPECT_NEAR(about_particles(ball.body[0], 3) / 4.18879e6, 1, 0.02);
}

TEST(Size, ParticlesBeyondTheMemoryAreRefused) {
  const deck::Deck deck = block(1000, 1);
  EXPECT_EQ(sentence_of([&] { refuse_too_large(deck, 3, 1, 1e12); }), "");
  EXPECT_EQ(sentence_of([&] { refuse_too_large(deck, 3, 1, 0); }), "");  // not known
  EXPECT_THAT(sentence_of([&] { refuse_too_large(deck, 3, 1, 64e9); }),
              HasSubstr("deck.yaml:4:12: the bodies up to block would have about 1e+09 particles, which take 250 GB"));
}

TEST(Size, HorizonsOfAMillionSpacingsAreRefused) {
  const deck::Deck deck = block(4, 1);
  EXPECT_EQ(sentence_of([&] { refuse_too_large(deck, 100, 1, 0); }), "");
  EXPECT_THAT(sentence_of([&] { refuse_too_large(deck, 1e6, 1, 0); }),
              HasSubstr("deck.yaml:6:10: the horizon reaches 1e+06 spacings of 1 far"));
}

TEST(Size, BondsBeyondTheMemoryAreRefusedUnlessOneLatticeHoldsThem) {
  deck::Deck deck = block(100, 1);
  EXPECT_EQ(sentence_of([&] { refuse_too_many_bonds(deck, 50, 1e6, 1, 1e9); }), "");
  deck.body[0].shape.form = deck::CloudFile{"cloud.csv"};
  EXPECT_EQ(sentence_of([&] { refuse_too_many_bonds(deck, 3, 1e6, 1, 4e9); }), "");
  EXPECT_THAT(sentence_of([&] { refuse_too_many_bonds(deck, 50, 1e6, 1, 4e9); }), HasSubstr("more than the 4 GB"));
}

TEST(Size, LengthsThatDoublePrecisionCannotCubeAreRefused) {
  for (const double spacing : {1e-300, 1e-51, 1e51, 1e300})
    EXPECT_THAT(sentence_of([&] {
                  refuse_odd_length(spacing, {"deck.yaml", 3, 5}, "the body block");
                }),
                HasSubstr("deck.yaml:3:5: the spacing"));
  EXPECT_EQ(sentence_of([&] { refuse_odd_length(1e-9, {}, "the body block"); }), "");
}

}  // namespace
}  // namespace perinox::body
