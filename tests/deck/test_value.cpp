#include <stdexcept>

#include "deck/fixture.hpp"
#include "perinox/deck/value.hpp"

namespace perinox::deck {
namespace {

const Location where{"deck.yaml", 2, 5};

TEST(Value, ScalarsKeepTextPlaceAndOrigin) {
  const Value value = Value::scalar("2.5e-3", where, true);
  EXPECT_EQ(value.kind(), Value::Kind::scalar);
  EXPECT_EQ(value.number(), 2.5e-3);
  EXPECT_EQ(value.text(), "2.5e-3");
  EXPECT_EQ(value.location().text(), "deck.yaml:2:5");
  EXPECT_TRUE(value.given());
  EXPECT_FALSE(Value::scalar("1", where, false).given());
  EXPECT_EQ(Value::scalar("-7", where, true).integer(), -7);
  EXPECT_TRUE(Value::scalar("true", where, true).boolean());
  EXPECT_FALSE(Value::scalar("false", where, true).boolean());
}

TEST(Value, MapsTellAbsentFromUnknownKeys) {
  const Value map = Value::map({{"a", Value::scalar("1", where, true)}, {"b", Value()}}, where, true);
  EXPECT_TRUE(map.has("a"));
  EXPECT_FALSE(map.has("b"));
  EXPECT_EQ(map.at("a").integer(), 1);
  EXPECT_EQ(map.at("b").kind(), Value::Kind::none);
  EXPECT_EQ(map.entries().size(), 1u);
  EXPECT_EQ(map.absent_keys(), std::vector<std::string>{"b"});
  EXPECT_THROW(map.at("c"), std::logic_error);
}

TEST(Value, MisuseIsAFaultOfTheProgram) {
  EXPECT_THROW(Value().text(), std::logic_error);
  EXPECT_THROW(Value::scalar("abc", where, true).number(), std::logic_error);
  EXPECT_THROW(Value::scalar("1.5", where, true).integer(), std::logic_error);
  EXPECT_THROW(Value::scalar("yes", where, true).boolean(), std::logic_error);
  EXPECT_THROW(Value::list({}, where, true).text(), std::logic_error);
}

TEST(Value, Lists) {
  const Value list = Value::list({Value::scalar("1", where, true), Value::scalar("2", where, true)}, where, false);
  ASSERT_EQ(list.items().size(), 2u);
  EXPECT_EQ(list.items()[1].integer(), 2);
  EXPECT_TRUE(list.entries().empty());
}

TEST(Location, TextNamesWhatIsKnown) {
  EXPECT_EQ((Location{"deck.yaml", 14, 7}.text()), "deck.yaml:14:7");
  EXPECT_EQ((Location{"deck.yaml", 0, 0}.text()), "deck.yaml");
}

TEST(Nearest, FindsTypingMistakes) {
  const std::vector<std::string> words{"yield_stress", "bulk_modulus", "shear_modulus", "matrix-free"};
  EXPECT_EQ(nearest("yield_stess", words), "yield_stress");
  EXPECT_EQ(nearest("yeild_stress", words), "yield_stress");
  EXPECT_EQ(nearest("Bulk-Modulus", words), "bulk_modulus");
  EXPECT_EQ(nearest("matrix_free", words), "matrix-free");
  EXPECT_EQ(nearest("bulk", words), "bulk_modulus");
  EXPECT_EQ(nearest("temperature", words), "");
  EXPECT_EQ(nearest("", words), "");
  EXPECT_EQ(nearest("a", {}), "");
  EXPECT_EQ(nearest("a", {"b"}), "");
}

}  // namespace
}  // namespace perinox::deck
