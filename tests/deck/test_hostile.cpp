/// Decks made to do harm are refused: aliases that multiply, devices that never end, control characters in a message.
#include "deck/fixture.hpp"

namespace perinox::deck {
namespace {

using fixture::base_deck, fixture::changed, fixture::message_of;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(Hostile, AliasesThatStandForMillionsAreRefused) {
  std::string yaml = "a0: &a0 [x, x, x, x, x, x, x, x, x, x]\n";
  for (int k = 1; k < 9; ++k) {
    const std::string before = "*a" + std::to_string(k - 1);
    yaml += "a" + std::to_string(k) + ": &a" + std::to_string(k) + " [";
    for (int n = 0; n < 10; ++n) yaml += (n > 0 ? ", " : "") + before;
    yaml += "]\n";
  }
  EXPECT_THAT(message_of(yaml), HasSubstr("stand for more than 10000 values"));
}

TEST(Hostile, AFewAliasesAreFine) {
  const std::string yaml = changed(base_deck, "  - {set: foot, displacement: {x: 0, y: 0, z: 0}}",
                                   "  - {set: foot, displacement: &held {x: 0, y: 0, z: 0}}");
  EXPECT_EQ(message_of(changed(yaml, "    displacement: {z: \"0.3*t\"}", "    displacement: *held")), "");
}

TEST(Hostile, MessagesAreOneLineAndEnd) {
  const std::string message = message_of("\"a\\nb\\e[31m\": 1\n");
  EXPECT_THAT(message, HasSubstr("a\\nb?[31m is not a key of a deck"));
  EXPECT_THAT(message, Not(HasSubstr("\n")));
  EXPECT_LT(message_of(std::string(100000, 'k') + ": 1\n").size(), 2100U);
}

TEST(Hostile, DevicesAreNoInputFiles) {
  EXPECT_THAT(message_of(changed(base_deck, "{box: {min: [0, 0, 0], max: [4, 4, 8]}}", "{file: /dev/zero}")),
              HasSubstr("/dev/zero (file) is neither a file nor a link to one"));
  EXPECT_THAT(([] {
                try {
                  read("/dev/zero", fixture::schema());
                } catch (const InputError& error) {
                  return std::string(error.what());
                }
                return std::string();
              }()),
              HasSubstr("longer than 64 MB"));
}

}  // namespace
}  // namespace perinox::deck
