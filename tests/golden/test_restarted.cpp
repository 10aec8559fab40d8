/// Breaks decks of inputs/ off after every step and goes on from their own checkpoints each time. Rows and end must be
/// the same to the last bit. The normal run takes a sample; scripts/restarts.sh takes all of them.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "perinox/deck/restart.hpp"
#include "support/breaking_decks.hpp"
#include "support/restarts.hpp"

namespace perinox::test {
namespace {

void expect_same_in_pieces(const deck::Deck& deck) {
  const RunResult whole = run_deck(deck);
  int pieces = 0;
  const RunResult parts = run_in_pieces(deck, pieces);
  ASSERT_EQ(parts.stopped, whole.stopped);
  ASSERT_EQ(parts.records.steps.size(), whole.records.steps.size());
  EXPECT_GE(pieces, static_cast<int>(whole.records.steps.size()));
  for (std::size_t k = 0; k < whole.records.steps.size(); ++k)
    ASSERT_EQ(numbers_of(parts.records.steps[k]), numbers_of(whole.records.steps[k])) << "step " << k + 1;
  EXPECT_TRUE(parts.displacement == whole.displacement);
  EXPECT_TRUE(parts.force == whole.force);
  std::printf("%d runs of a step each\n", pieces);
}

/// Names of the decks. They are all decks if PERINOX_RESTARTS is set.
std::vector<std::string> restarted() {
  if (!std::getenv("PERINOX_RESTARTS")) return {"pulled_bar", "snapping_bar", "ringing_bar", "single_bond"};
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(PERINOX_SOURCE_DIR "/inputs"))
    if (entry.path().extension() == ".yaml") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

class Restarted : public ::testing::TestWithParam<std::string> {};

TEST_P(Restarted, AfterEveryStep) {
  const deck::Deck deck = deck::read(PERINOX_SOURCE_DIR "/inputs/" + GetParam() + ".yaml", materials::full_schema());
  if (!deck::not_in_checkpoints(deck).empty()) GTEST_SKIP() << "its state is not in checkpoints";
  expect_same_in_pieces(deck);
}

INSTANTIATE_TEST_SUITE_P(Inputs, Restarted, ::testing::ValuesIn(restarted()),
                         [](const auto& tested) { return tested.param; });

// One bond a pass means as many rounds of breaking as there are bonds, and a search for loose pieces in each of them.
TEST(RestartedPasses, OneBondAtATime) {
  expect_same_in_pieces(deck_of(torn_plate, {"fracture.pass_share=1e-9", "fracture.max_passes=1000"}));
}

}  // namespace
}  // namespace perinox::test
