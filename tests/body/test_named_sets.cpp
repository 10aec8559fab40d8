/// Tests named sets of particles.
#include <fmt/format.h>

#include "support/bodies.hpp"

namespace perinox::body {
namespace {

using namespace fixture;
using ::testing::ElementsAre;
using ::testing::StartsWith;
using Members = std::vector<LocalIndex>;

TEST(Sets, EveryParticleAndEveryBodyIsASet) {
  deck::Deck deck = cube(2);
  add_body(deck, "lid", deck::Box{{0, 0, 2}, {2, 1, 3}});
  const Body body = build_body(deck);
  EXPECT_EQ(body.sets.size(), 3U);
  EXPECT_THAT(body.sets.at("all"), ElementsAre(0, 1, 2, 3, 4, 5, 6, 7, 8, 9));
  EXPECT_THAT(body.sets.at("block"), ElementsAre(0, 1, 2, 3, 4, 5, 6, 7));
  EXPECT_THAT(body.sets.at("lid"), ElementsAre(8, 9));
}

TEST(Sets, ByCondition) {
  deck::Deck deck = cube(3);
  add_set(deck, "corner", deck::SetWhere{deck::Expression("x < 1 && y < 1 && z < 2", {"deck.yaml", 20, 3})});
  EXPECT_THAT(build_body(deck).sets.at("corner"), ElementsAre(0, 9));
  // A comparison that comes first keeps the rest from being evaluated where it has no value.
  add_set(deck, "half", deck::SetWhere{deck::Expression("x > 2 && sqrt(x - 2) < 9", {"deck.yaml", 20, 3})});
  EXPECT_EQ(build_body(deck).sets.at("half").size(), 9U);
}

/// A box's face through particle centres includes them, on all sides, even where 0.1 + 0.2 is not 0.3.
TEST(Sets, BoxIncludesItsSurface) {
  deck::Deck deck = cube(0.4, 0.1);
  add_set(deck, "inner", deck::SetBox{{0.15, 0.15, 0.15}, {0.1 + 0.15, 0.25, 0.25}});
  add_set(deck, "below", deck::SetBox{{0.15, 0.15, 0.15}, {0.25, 0.25, 0.25 - 1e-7}});
  const Body body = build_body(deck);
  EXPECT_EQ(body.sets.at("inner").size(), 8U);
  EXPECT_EQ(body.sets.at("below").size(), 4U);
}

/// With h = 0.1 rounding once took three rows for y <= 0.35 and four for y >= 0.65.
TEST(Sets, ConditionsTakeWholeRowsAtTheirBounds) {
  for (const double offset : {0.0, 0.7, 4600000.5}) {
    deck::Deck deck = deck_of(deck::Box{{0, offset, 0}, {1, offset + 1, 0}}, deck::Dimension::plane_strain, 0.1);
    const std::string low = fmt::format("{:.17g}", offset + 0.35), high = fmt::format("{:.17g}", offset + 0.65);
    const auto add = [&](const std::string& name, const std::string& condition) {
      add_set(deck, name, deck::SetWhere{deck::Expression(condition, {"deck.yaml", 20, 3})});
    };
    add("most_low", "y <= " + low);
    add("least_high", high + " <= y");
    add("below", "y < " + low);
    add("above", "y > " + high);
    add("on", "(y == " + low + ") || (x < 2 ? y == " + high + " : 0)");
    add("off", "y != " + low + " && y != " + high);
    add("squares", "(y - " + low + ")^2 <= 0.09 && max(x, 2*(x >= 0.55)) < 1");
    const Body body = build_body(deck);
    const auto rows = [&](const char* name) { return static_cast<double>(body.sets.at(name).size()) / 10; };
    EXPECT_EQ(rows("most_low"), 4) << offset;
    EXPECT_EQ(rows("least_high"), 4) << offset;
    EXPECT_EQ(rows("below"), 3) << offset;
    EXPECT_EQ(rows("above"), 3) << offset;
    EXPECT_EQ(rows("on"), 2) << offset;
    EXPECT_EQ(rows("off"), 8) << offset;
    EXPECT_EQ(rows("squares"), 3.5) << offset;  // seven rows of five
  }
}

TEST(Sets, FlatBoxIgnoresThirdCoordinate) {
  deck::Deck deck = square(2);
  add_set(deck, "left", deck::SetBox{{0, 0, 7}, {1, 2, 7}});
  EXPECT_THAT(build_body(deck).sets.at("left"), ElementsAre(0, 2));
}

TEST(Sets, ByIdsInAnyOrderOnceEach) {
  deck::Deck deck = cube(2);
  add_set(deck, "some", deck::SetIds{{7, 0, 3, 0}});
  add_set(deck, "whole", deck::SetBody{"block"});
  const Body body = build_body(deck);
  EXPECT_THAT(body.sets.at("some"), ElementsAre(0, 3, 7));
  EXPECT_EQ(body.sets.at("whole"), body.sets.at("block"));
}

TEST(Sets, Refusals) {
  struct Case {
    const char* name;
    decltype(deck::Set::form) form;
    const char* sentence;
  };
  const std::vector<Case> cases = {
      {"far", deck::SetBox{{5, 5, 5}, {6, 6, 6}},
       "deck.yaml:20:3: the set far is empty: none of the 8 particles is in it; widen its condition"},
      {"none", deck::SetIds{{}}, "deck.yaml:20:3: the set none is empty"},
      {"high", deck::SetIds{{0, 8}},
       "deck.yaml:20:3: the set high names particle 8, but the particles are numbered from 0 to 7"},
      {"low", deck::SetIds{{-1}}, "deck.yaml:20:3: the set low names particle -1, but the particles are numbered"},
      {"huge", deck::SetIds{{9223372036854775807LL}},
       "deck.yaml:20:3: the set huge names particle 9223372036854775807"},
      {"root", deck::SetWhere{deck::Expression("sqrt(x - 1) < 9", {"deck.yaml", 20, 3})},
       "deck.yaml:20:3: the condition of the set root is not a number at the particle at (0.5, 0.5, 0.5)"},
      {"log", deck::SetWhere{deck::Expression("ln(x - 1) != 0", {"deck.yaml", 20, 3})},
       "deck.yaml:20:3: the condition of the set log is not a number at the particle at (0.5, 0.5, 0.5)"},
      {"other", deck::SetBody{"blok"}, "deck.yaml:20:3: the set other names the body blok, which the deck does not"},
      {"all", deck::SetIds{{1}}, "deck.yaml:20:3: the name all is taken"},
      {"block", deck::SetIds{{1}}, "deck.yaml:20:3: the name block is taken"},
  };
  for (const Case& one : cases) {
    deck::Deck deck = cube(2);
    add_set(deck, one.name, one.form);
    EXPECT_THAT(refusal([&] { build_body(deck); }), StartsWith(one.sentence));
  }
}

}  // namespace
}  // namespace perinox::body
