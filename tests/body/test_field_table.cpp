/// Tests displacement tables: how rows match particles, times, refusals.
#include <fmt/format.h>

#include "perinox/body/field_table.hpp"
#include "support/bodies.hpp"

namespace perinox::body {
namespace {

using namespace fixture;
using ::testing::StartsWith;

const deck::Location asked{"deck.yaml", 12, 9};

/// Rows of every particle of a 2 x 2 x 1 block at one time, with u = factor (1, 2, 3) (id + 1).
std::string rows(double factor, const std::string& time = "") {
  std::string text;
  for (int id = 3; id >= 0; --id) {
    text += fmt::format("{}{},{},0.5,{},{},{}\n", time, 0.5 + id % 2, 0.5 + id / 2, factor * (id + 1),
                        2 * factor * (id + 1), 3 * factor * (id + 1));
  }
  return text;
}

Body block() { return build_body(deck_of(deck::Box{{0, 0, 0}, {2, 2, 1}})); }

std::array<double, 3> value(const FieldTable& table, std::size_t k, double t) {
  std::array<double, 3> u{};
  table.evaluate(k, t, u.data());
  return u;
}

using Value = std::array<double, 3>;

TEST(FieldTable, WithoutTimesItHoldsAlways) {
  const TextFile file("field.csv", "x,y,z,ux,uy,uz\n" + rows(1));
  const Body body = block();
  const FieldTable table(file.path(), asked, body, body.sets.at("all"));
  EXPECT_EQ(value(table, 0, 0), (Value{0, 0, 0}));
  EXPECT_EQ(value(table, 0, 1e-9), (Value{1, 2, 3}));
  EXPECT_EQ(value(table, 3, 5), (Value{4, 8, 12}));
}

TEST(FieldTable, IsLinearBetweenTimesAndFromRestToTheFirst) {
  const TextFile file("field.csv", "t,x,y,z,ux,uy,uz\n" + rows(10, "4,") + rows(1, "2,") + rows(1, "2.0000000000001,"));
  const Body body = block();
  // Times that differ by rounding only are one time, so the last four rows repeat rows before them.
  EXPECT_THAT(refusal([&] { FieldTable(file.path(), asked, body, body.sets.at("all")); }),
              StartsWith(file.path() + ":10:1: particle 3 has its displacement at t = 2 on line 6 already"));

  const TextFile good("good.csv", "t,x,y,z,ux,uy,uz\n" + rows(10, "4,") + rows(1, "2,"));
  const FieldTable table(good.path(), asked, body, body.sets.at("all"));
  EXPECT_EQ(table.times(), (std::vector<double>{2, 4}));
  EXPECT_EQ(value(table, 0, 0), (Value{0, 0, 0}));
  EXPECT_EQ(value(table, 0, 1), (Value{0.5, 1, 1.5}));
  EXPECT_EQ(value(table, 0, 2), (Value{1, 2, 3}));
  EXPECT_EQ(value(table, 0, 3), (Value{5.5, 11, 16.5}));
  EXPECT_EQ(value(table, 0, 4), (Value{10, 20, 30}));
  EXPECT_EQ(value(table, 0, 99), (Value{10, 20, 30}));
}

TEST(FieldTable, AGivenTimeZeroIsTaken) {
  const TextFile file("field.csv", "t,x,y,z,ux,uy,uz\n" + rows(1, "0,") + rows(3, "1,"));
  const Body body = block();
  const FieldTable table(file.path(), asked, body, body.sets.at("all"));
  EXPECT_EQ(value(table, 0, 0), (Value{1, 2, 3}));
  EXPECT_EQ(value(table, 0, 0.5), (Value{2, 4, 6}));
}

TEST(FieldTable, RowsOfOtherParticlesOfTheBodyAreFine) {
  deck::Deck deck = deck_of(deck::Box{{0, 0, 0}, {2, 2, 1}});
  add_set(deck, "pair", deck::SetIds{{1, 2}});
  const Body body = build_body(deck);
  const TextFile file("field.csv", "x,y,z,ux,uy,uz\n" + rows(1));
  const FieldTable table(file.path(), asked, body, body.sets.at("pair"));
  EXPECT_EQ(value(table, 0, 1), (Value{2, 4, 6}));
  EXPECT_EQ(value(table, 1, 1), (Value{3, 6, 9}));
}

TEST(FieldTable, FlatBodiesTakeTwoComponents) {
  const Body body = build_body(square(1));
  const TextFile file("field.csv", "x,y,z,ux,uy,uz\n0.5000001,0.5,0,7,8,0\n");
  const FieldTable table(file.path(), asked, body, body.sets.at("all"));
  EXPECT_EQ(value(table, 0, 1), (Value{7, 8, 0}));
}

TEST(FieldTable, MalformedTablesAreRefused) {
  struct Case {
    std::string text;
    std::string sentence;
  };
  const std::string head = "x,y,z,ux,uy,uz\n", timed = "t,x,y,z,ux,uy,uz\n";
  const std::vector<Case> cases = {
      {"", ": the file is empty; a displacement table begins with the header x,y,z,ux,uy,uz"},
      {"x,y,z,ux,uy\n1,1,1,1,1\n", ":1:1: the column uz is missing"},
      {"time,x,y,z,ux,uy,uz\n", ":1:1: time is not a column of a displacement table"},
      {"x,y,z,u_x,uy,uz\n", ":1:7: u_x is not a column of a displacement table, did you mean ux?"},
      {head + rows(1) + "0.5,0.5,0.5,a,0,0\n", ":6:13: a is not a number (column ux)"},
      {head + rows(1) + "0.5,0.5,0.5,0,0\n", ":6:16: 5 values in this row"},
      {head + rows(1) + "7,0.5,0.5,0,0,0\n", ":6:1: no particle is at (7, 0.5, 0.5)"},
      {head + rows(1) + "0.50001,0.5,0.5,0,0,0\n", ":6:1: no particle is at (0.50001, 0.5, 0.5)"},
      {head + rows(1) + "0.5,0.5,0.5,0,0,0\n", ":6:1: particle 0 has its displacement on line 5 already"},
      {timed + rows(1, "1,") + rows(1, "-1,"), ":6:1: t must not be negative, but is -1"},
      {timed + rows(1, "1,") + rows(1, "nan,"), ":6:1: nan is not a finite number (column t)"},
  };
  const Body body = block();
  for (const Case& one : cases) {
    const TextFile file("bad.csv", one.text);
    EXPECT_THAT(refusal([&] { FieldTable(file.path(), asked, body, body.sets.at("all")); }),
                StartsWith(file.path() + one.sentence));
  }
}

TEST(FieldTable, TheFirstParticleWithoutARowIsNamed) {
  const Body body = block();
  const TextFile file("field.csv", "t,x,y,z,ux,uy,uz\n" + rows(1, "1,") + "2,0.5,0.5,0.5,0,0,0\n");
  EXPECT_EQ(
      refusal([&] { FieldTable(file.path(), asked, body, body.sets.at("all")); }),
      "deck.yaml:12:9: " + file.path() +
          " has no row for particle 1 at (1.5, 0.5, 0.5) at t = 2; add one, or impose the table on a smaller set");
  EXPECT_THAT(refusal([&] { FieldTable("/nowhere.csv", asked, body, body.sets.at("all")); }),
              StartsWith("deck.yaml:12:9: cannot read /nowhere.csv as a displacement table: No such file"));
}

TEST(FieldTable, FlatTablesHaveNoThirdComponent) {
  const Body body = build_body(square(1));
  for (const char* row : {"0.5,0.5,1,7,8,0\n", "0.5,0.5,0,7,8,1\n"}) {
    const TextFile file("bad.csv", std::string("x,y,z,ux,uy,uz\n") + row);
    EXPECT_THAT(refusal([&] { FieldTable(file.path(), asked, body, body.sets.at("all")); }),
                ::testing::HasSubstr("z must be 0 in 2-D, but is 1"));
  }
}

}  // namespace
}  // namespace perinox::body
