/// Tests wrong entries of a deck about hardening, and mistakes in a hardening table. Each ends with one sentence and
/// exit status 2.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "decks.hpp"
#include "program.hpp"

namespace perinox::cli {
namespace {

const char* const good = "plastic_strain,yield_stress\n0,200\n0.01,230\n0.05,250\n";
const char* const with_table = "    hardening_table: {tension: hardening.csv}\n";

struct HardeningMistake {
  const char* name;
  const char* keys;  ///< take the place of the deck's yield_stress
  const char* dimension;
  const char* table;
  const char* sentence;
};
void PrintTo(const HardeningMistake& mistake, std::ostream* out) { *out << mistake.name; }

const HardeningMistake mistakes[] = {
    {"no_yield_stress", "    kinematic_hardening_modulus: {shear: 1}\n", "3", good,
     "deck.yaml:13:5: material steel needs the key yield_stress (a map with exactly one of tension or shear), or a "
     "hardening_table"},
    {"negative_kinematic_hardening", "    yield_stress: {shear: 100}\n    kinematic_hardening_modulus: {tension: -1}\n",
     "3", good, "deck.yaml:17:44: tension is -1 but must be at least 0"},
    {"table_and_yield_stress", "    yield_stress: {shear: 100}\n    hardening_table: {tension: hardening.csv}\n", "3",
     good,
     "deck.yaml:16:19: material steel has both yield_stress and hardening_table, but the table says both the yield "
     "stress and its hardening; keep one"},
    {"table_and_hardening_modulus",
     "    hardening_table: {tension: hardening.csv}\n    hardening_modulus: {shear: 100}\n", "3", good,
     "deck.yaml:17:24: material steel has both hardening_modulus and hardening_table, but the table says both the "
     "yield "
     "stress and its hardening; keep one"},
    {"missing_table", "    hardening_table: {tension: nowhere.csv}\n", "3", good,
     "deck.yaml:16:32: the file nowhere.csv (tension) does not exist; relative names start at the deck's folder, so "
     "this one was looked for as {dir}/nowhere.csv"},
    {"table_without_rows", with_table, "3", "plastic_strain,yield_stress\n",
     "{dir}/hardening.csv: the file has a header but no rows; add at least one"},
    {"table_that_begins_late", with_table, "3", "plastic_strain,yield_stress\n0.01,200\n",
     "{dir}/hardening.csv:2:1: a hardening table begins at plastic strain 0, but this one at 0.01; add the row of "
     "first "
     "yield"},
    {"table_out_of_order", with_table, "3", "plastic_strain,yield_stress\n0,200\n0.02,230\n0.01,220\n",
     "{dir}/hardening.csv:4:1: plastic_strain is 0.01 after 0.02; sort the rows so that it rises from row to row"},
    {"table_with_a_stress_of_zero", with_table, "3", "plastic_strain,yield_stress\n0,200\n0.02,0\n",
     "{dir}/hardening.csv:3:6: yield_stress is 0 but must be greater than 0"},
    {"table_that_falls_too_steeply", with_table, "3", "plastic_strain,yield_stress\n0,2000\n0.005,400\n",
     "deck.yaml:16:32: the yield stress of this hardening table falls with a slope of -320000 in tension, at or beyond "
     "-240000, where the return to it is no longer unique; let it fall more slowly"},
    {"table_that_falls_too_steeply_in_plane_stress", with_table, "plane-stress",
     "plastic_strain,yield_stress\n0,2000\n0.005,1000\n",
     "deck.yaml:16:32: the yield stress of this hardening table falls with a slope of -200000 in tension, at or beyond "
     "-144000, where the return to it is no longer unique; let it fall more slowly"},
    {"table_that_falls_with_continuum_scaling",
     "    hardening_table: {tension: hardening.csv}\n    yield_scaling: continuum\n", "3",
     "plastic_strain,yield_stress\n0,200\n0.01,190\n",
     "deck.yaml:16:32: a hardening table whose yield stress falls needs yield_scaling: discrete, where its slope can "
     "be "
     "compared with the shear modulus"},
};

class MalformedHardening : public ::testing::TestWithParam<HardeningMistake> {};

TEST_P(MalformedHardening, IsRefusedInOneSentence) {
  const HardeningMistake& mistake = GetParam();
  const Folder folder;
  std::string deck = changed(base_deck, "    yield_stress: {tension: 203.1}\n", mistake.keys);
  if (std::string(mistake.dimension) != "3") {
    deck = changed(deck, "dimension: 3", std::string("dimension: ") + mistake.dimension);
    deck = changed(deck, "min: [0, 0, 0], max: [3, 3, 4]", "min: [0, 0], max: [3, 4]");
    deck = changed(deck, "z < 1", "y < 1");
    deck = changed(deck, "z > 3", "y > 3");
    deck = changed(deck, "{x: 0, y: 0, z: 0}", "{x: 0, y: 0}");
    deck = changed(deck, "{z: \"0.01*t\"}", "{y: \"0.01*t\"}");
    deck = changed(deck, "component: z", "component: y");
  }
  folder.write("deck.yaml", deck);
  folder.write("hardening.csv", mistake.table);
  std::string sentence = mistake.sentence;
  const std::size_t at = sentence.find("{dir}");
  if (at != std::string::npos) sentence.replace(at, 5, folder.path().string());
  const Outcome outcome = folder.perinox({"check", "deck.yaml"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.error, sentence + "\n");
  EXPECT_EQ(outcome.out, "");
  // The same table passes when it is mended, so what is refused is the mistake.
  if (mistake.keys != with_table) return;
  folder.write("hardening.csv", good);
  EXPECT_EQ(folder.perinox({"check", "deck.yaml"}).status, 0);
}

INSTANTIATE_TEST_SUITE_P(Cli, MalformedHardening, ::testing::ValuesIn(mistakes),
                         [](const auto& one) { return std::string(one.param.name); });

TEST(MalformedHardening, ATableOnTwoRanksIsRefusedOnce) {
  const Folder folder;
  folder.write("deck.yaml", changed(base_deck, "    yield_stress: {tension: 203.1}\n", with_table));
  folder.write("hardening.csv", "plastic_strain,yield_stress\n0.01,200\n");
  const Outcome outcome = folder.perinox_on_ranks(2, {"run", "deck.yaml"});
  EXPECT_EQ(outcome.status, 2);
  std::size_t times = 0;
  for (const std::string& line : lines_of(outcome.error))
    times += line.find("a hardening table begins at plastic strain 0") != std::string::npos ? 1 : 0;
  EXPECT_EQ(times, 1) << outcome.error;
}

}  // namespace
}  // namespace perinox::cli
