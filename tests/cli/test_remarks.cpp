/// What can be computed but is hardly meant is said as a note on standard error, by check, run and verify alike, once
/// on several ranks. The exit status stays 0.
#include <gmock/gmock.h>

#include "decks.hpp"
#include "program.hpp"

namespace perinox::cli {
namespace {

using ::testing::HasSubstr;

struct Remark {
  const char* name;
  const std::string* deck;
  const char* from;
  const char* to;
  const char* sentence;
};
void PrintTo(const Remark& remark, std::ostream* out) { *out << remark.name; }

const Remark remarks[] = {
    {"yield_stress_above_the_modulus", &base_deck, "tension: 203.1", "tension: 203.1e6",
     "note: deck.yaml:16:29: the yield stress, 2.031e+08 in tension and 1.1726e+08 in shear, is above 0.1 of the shear "
     "modulus, 80000; check that both are in the same unit\n"},
    {"yield_stress_near_the_modulus", &base_deck, "bulk_modulus: 160e3\n    shear_modulus: 80e3",
     "bulk_modulus: 160\n    shear_modulus: 80",
     "note: deck.yaml:16:29: the yield stress, 203.1 in tension and 117.26 in shear, is above 0.1 of the shear "
     "modulus, "
     "80; check that both are in the same unit\n"},
    {"yield_stress_in_the_plane", &flat_deck, "model: elastic,", "model: elastic-plastic, yield_stress: {shear: 9e3},",
     "note: deck.yaml:5:57: the yield stress, 15588.5 in tension and 9000 in shear, is above 0.1 of the shear modulus, "
     "80000; check that both are in the same unit\n"},
    {"horizon_of_one_spacing", &base_deck, "ratio: 2.015", "ratio: 1.0",
     "note: deck.yaml:8:10: a horizon of 1 times the spacing holds hardly more than the nearest neighbours, whose "
     "bonds follow "
     "the lattice and not the material; 3 are usual\n"},
    {"load_that_never_uses_t", &base_deck, "\"0.01*t\"", "0.01",
     "note: deck.yaml:22:5: the displacement on head does not use t, so that it is there in full from the first step "
     "on, and all 2 steps find the same state, as no load uses t; let it grow as in \"1.5*t\" unless that is meant\n"},
    {"contact_in_load_steps", &base_deck, "horizon:", "explicit: {contact: {}}\nhorizon:",
     "note: deck.yaml:8:11: explicit has no effect here: the run goes in load steps, without motion in time and "
     "without "
     "contact; faces may pass into each other\n"},
    {"fracture_without_damage", &base_deck, "horizon:", "fracture: {pass_share: 0.1}\nhorizon:",
     "note: deck.yaml:8:11: fracture has no effect here: no material has a damage law\n"},
    {"arc_length_in_load_steps", &base_deck, "horizon:", "arc_length: {max_steps: 9}\nhorizon:",
     "note: deck.yaml:8:13: arc_length has no effect here: steps.control is load\n"},
    {"field_of_the_plane", &base_deck, "[displacement, force]", "[plastic_strain_zz]",
     "note: deck.yaml:28:29: this scene has no field plastic_strain_zz, so that it will not be in results.h5; it "
     "exists "
     "in 2-D, where a material is elastic-plastic; 0 in the others' particles\n"},
};

class CheckRemark : public ::testing::TestWithParam<Remark> {};

TEST_P(CheckRemark, IsOneNoteAndTheDeckIsValid) {
  const Remark& remark = GetParam();
  const Folder folder;
  folder.write("deck.yaml", changed(*remark.deck, remark.from, remark.to));
  const Outcome outcome = folder.perinox({"check", "deck.yaml", "--quiet"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.error, remark.sentence);
}

INSTANTIATE_TEST_SUITE_P(Cli, CheckRemark, ::testing::ValuesIn(remarks),
                         [](const auto& one) { return std::string(one.param.name); });

TEST(Remark, RunAndVerifySayItToo) {
  const Folder folder;
  folder.write("deck.yaml", changed(base_deck, "\"0.01*t\"", "0.001"));
  for (const char* command : {"run", "verify"}) {
    const Outcome outcome = folder.perinox({command, "deck.yaml", "--quiet"});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_THAT(outcome.error, HasSubstr("note: deck.yaml:22:5: the displacement on head does not use t, "));
  }
  const Outcome on_two = folder.perinox_on_ranks(2, {"check", "deck.yaml", "--quiet"});
  const std::string note = "does not use t";
  const std::size_t first = on_two.error.find(note);
  EXPECT_NE(first, std::string::npos);
  EXPECT_EQ(on_two.error.find(note, first + 1), std::string::npos);
}

TEST(Remark, ATableThatDoesNotReachTheEnd) {
  const Folder folder;
  folder.write("deck.yaml", cloud_deck);
  folder.write("cloud.csv", cloud);
  folder.write("field.csv", field);
  EXPECT_EQ(folder.perinox({"check", "deck.yaml", "--quiet"}).error, "");
  EXPECT_EQ(
      folder.perinox({"check", "deck.yaml", "--quiet", "--set", "steps.end=2"}).error,
      "note: deck.yaml:5:45: the table ends at t = 1, before steps.end = 2; its last displacements stay from there "
      "on\n");
  std::string timeless;
  for (const std::string& line : lines_of(field)) timeless += line.substr(2) + "\n";
  folder.write("field.csv", timeless);
  EXPECT_EQ(
      folder.perinox({"check", "deck.yaml", "--quiet"}).error,
      "note: deck.yaml:5:45: the table has no column t, so that its displacements are there in full from the first "
      "step on\n");
  EXPECT_EQ(folder.perinox({"check", "deck.yaml", "--quiet", "--set", "steps.count=1"}).error, "");
}

}  // namespace
}  // namespace perinox::cli
