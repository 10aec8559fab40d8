/// The resolved deck must read back to the same deck.
#include <cmath>

#include "deck/fixture.hpp"

namespace perinox::deck {
namespace {

/// Expects the same kind, keys in the same order and the same scalars. Places and origin do not count.
void expect_same(const Value& a, const Value& b, const std::string& path) {
  ASSERT_EQ(a.kind(), b.kind()) << path;
  if (a.kind() == Value::Kind::scalar) {
    EXPECT_EQ(a.text(), b.text()) << path;
  }
  ASSERT_EQ(a.items().size(), b.items().size()) << path;
  for (std::size_t i = 0; i < a.items().size(); ++i) {
    expect_same(a.items()[i], b.items()[i], path + "." + std::to_string(i));
  }
  ASSERT_EQ(a.entries().size(), b.entries().size()) << path;
  for (std::size_t i = 0; i < a.entries().size(); ++i) {
    ASSERT_EQ(a.entries()[i].first, b.entries()[i].first) << path;
    expect_same(a.entries()[i].second, b.entries()[i].second, path + "." + a.entries()[i].first);
  }
}

class Resolved : public ::testing::TestWithParam<std::string> {};

TEST_P(Resolved, ReadsBackToTheSameDeck) {
  const Deck deck = read_text(GetParam(), "deck.yaml", fixture::schema());
  const std::string text = write_resolved(deck);
  SCOPED_TRACE(text);
  const Deck again = read_text(text, "results/deck.resolved.yaml", fixture::schema());
  expect_same(deck.resolved, again.resolved, "deck");
  EXPECT_EQ(deck.title, again.title);
  EXPECT_EQ(write_resolved(again), text);
}

const std::string long_ids = [] {
  std::string ids = "0";
  for (int i = 1; i < 200; ++i) ids += ", " + std::to_string(i);
  return ids;
}();

std::vector<std::string> decks() {
  using fixture::changed;
  const std::string base = fixture::base_deck;
  return {base,
          fixture::flat_deck,
          changed(base, "title: base", "title: \"a: b # c \\\"quoted\\\" \\\\ back\\tslash \\u00e9 {[&*!|>'%@`\""),
          changed(base, "title: base", "title: 'null'"),
          changed(base, "title: base", "title: '~'"),
          changed(base, "title: base", "title: 2024"),
          changed(base, "title: base", "title: '- dash'"),
          changed(base, "title: base", "title: |\n  two\n  lines"),
          changed(base, "title: base", "title: 'yes'"),
          changed(base, "title: base", "title: '0x1f'"),
          changed(base, "title: base\n", ""),
          changed(base, "bulk_modulus: 160e3", "bulk_modulus: 0.1000000000000000055511151231257827"),
          changed(base, "bulk_modulus: 160e3", "bulk_modulus: 4.9406564584124654e-324"),
          changed(base, "bulk_modulus: 160e3", "bulk_modulus: 1.7976931348623157e308"),
          changed(base, "bulk_modulus: 160e3", "density: 2.71e-9"),
          changed(base, "\"0.3*t\"", "\"t < 0.5 ? 0.1*t : 0.05 + (x > 1 && y < 2)\""),
          changed(base, "\"0.3*t\"", "-1e-3"),
          changed(base, "{where: \"z > 6.5\"}", "{ids: [" + long_ids + "]}"),
          changed(base, "{box: {min: [0, 0, 0], max: [4, 4, 8]}}",
                  "{difference: [{union: [{sphere: {center: [0, 0, 0], radius: 2}}, {box: {min: [0, 0, 0], max: [1, 1, "
                  "1]}}]}, {cylinder: {start: [0, 0, 0], end: [0, 0, 1], radius: 0.3}}]}"),
          changed(base, "horizon:", "cracks: [{disc: {center: [1, 1, 1], normal: [0, 0, 1], radius: 1}}]\nhorizon:")};
}

INSTANTIATE_TEST_SUITE_P(Deck, Resolved, ::testing::ValuesIn(decks()));

TEST(ResolvedDeck, NamesEveryDefault) {
  const std::string text = write_resolved(read_text(fixture::base_deck, "deck.yaml", fixture::schema()));
  for (const char* line : {"bond_bodies: true", "form: consistent", "update_tolerance: 1.0e-06", "max_cuts: 8",
                           "preconditioner: automatic", "yield_scaling: discrete", "dilatation: true", "cracks: []"}) {
    EXPECT_THAT(text, ::testing::HasSubstr(line));
  }
}

TEST(ResolvedDeck, NumbersAreExact) {
  for (const double value : {0.1, 1.0 / 3.0, 2.0 / 3.0 * 1e-7, 6.02214076e23, std::nextafter(1.0, 2.0), 5e-324}) {
    Deck deck = read_text(fixture::base_deck, "deck.yaml", fixture::schema(),
                          {"materials.steel.young_modulus=" + Expression(value).text()});
    EXPECT_EQ(deck.materials[0].parameters.at("young_modulus").number(), value);
    const Deck again = read_text(write_resolved(deck), "deck.yaml", fixture::schema());
    EXPECT_EQ(again.materials[0].parameters.at("young_modulus").number(), value);
  }
}

}  // namespace
}  // namespace perinox::deck
