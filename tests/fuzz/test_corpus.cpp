/// Tests the files with which the fuzzers start and those that they have found. Each is accepted or refused with a
/// sentence; the lists below say which, where it matters.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>

#include "targets.hpp"

namespace perinox::fuzz {
namespace {

namespace fs = std::filesystem;

std::string bytes_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

class Corpus : public ::testing::TestWithParam<Target> {
 protected:
  std::vector<fs::path> files() const {
    std::vector<fs::path> all;
    for (const auto& entry : fs::directory_iterator(fs::path(PERINOX_SOURCE_DIR) / "fuzz/corpus" / GetParam().name))
      all.push_back(entry.path());
    std::sort(all.begin(), all.end());
    return all;
  }
};

/// Files that are right, so that the rest of the corpus is not refused for a reason that has nothing to do with it.
const std::map<std::string, std::vector<std::string>> right{
    {"deck", {}},
    {"cloud", {"odd_but_right.csv", "plane.csv"}},
    {"table", {"flat.csv", "solid.csv", "two_times.csv"}},
    {"expression", {"condition", "functions", "lists", "nested", "ramp"}},
    {"checkpoint", {"usual"}}};

/// Values under a right checksum that the rest of the program could not bear, and what the refusal says.
const std::map<std::string, std::string> wrong_checkpoints{
    {"broken_half_bond", "has half a bond"},
    {"broken_no_particle", "no particles or no rounds"},
    {"broken_with_itself", "no particles or no rounds"},
    {"broken_half_particle", "no particles or no rounds"},
    {"broken_negative_round", "no particles or no rounds"},
    {"broken_huge_round", "broke in round 1000000000000000"},
    {"broken_twice", "of the particles 0 and 1 twice"},
    {"broken_extension_short", "has another length"},
    {"negative_t", "its t is -1"},
    {"not_finite_t", "its t is nan"},
    {"not_finite_number", "holds in a/number a number that is not finite"},
    {"not_finite_field", "holds in a/field a number that is not finite"},
    {"not_finite_list", "holds in /a/lists a number that is not finite"},
    {"not_finite_bond", "holds in /fracture/broken a number that is not finite"},
    {"negative_length", "do not add up"},
    {"huge_length", "do not add up"}};

TEST_P(Corpus, IsAcceptedOrRefusedWithASentence) {
  ASSERT_GE(files().size(), 4U);
  for (const fs::path& file : files()) {
    SCOPED_TRACE(file.filename().string());
    EXPECT_NO_THROW(GetParam().run(bytes_of(file)));
  }
}

TEST_P(Corpus, WhatIsRightIsAccepted) {
  for (const std::string& name : right.at(GetParam().name)) {
    const fs::path file = fs::path(PERINOX_SOURCE_DIR) / "fuzz/corpus" / GetParam().name / name;
    ASSERT_TRUE(fs::exists(file)) << file;
    EXPECT_TRUE(GetParam().run(bytes_of(file))) << name;
  }
}

TEST(WrongCheckpoints, AreRefused) {
  for (const auto& [name, sentence] : wrong_checkpoints) {
    const fs::path file = fs::path(PERINOX_SOURCE_DIR) / "fuzz/corpus/checkpoint" / name;
    ASSERT_TRUE(fs::exists(file)) << file;
    EXPECT_FALSE(checkpoint(bytes_of(file))) << name;
    EXPECT_NE(refusal().find(sentence), std::string::npos) << name << ": " << refusal();
  }
}

INSTANTIATE_TEST_SUITE_P(EveryKind, Corpus, ::testing::ValuesIn(targets()),
                         [](const auto& one) { return std::string(one.param.name); });

TEST(ShippedDecks, ComeBackFromTheirResolvedForm) {
  int count = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(PERINOX_SOURCE_DIR) / "inputs")) {
    if (entry.path().extension() != ".yaml") continue;
    // Clouds and tables of a deck lie beside it, where the harness does not look.
    std::string text = bytes_of(entry.path());
    if (text.find(".csv") != std::string::npos) continue;
    EXPECT_TRUE(deck(text)) << entry.path();
    ++count;
  }
  EXPECT_GE(count, 20);  // 33 decks are shipped, of which a few name a file
}

}  // namespace
}  // namespace perinox::fuzz
