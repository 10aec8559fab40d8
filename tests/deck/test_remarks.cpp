/// Remarks on what a deck may say but hardly means: one sentence each with its place, and none on ordinary decks.
#include <filesystem>

#include "deck/fixture.hpp"
#include "perinox/deck/remarks.hpp"

namespace perinox::deck {
namespace {

using fixture::base_deck, fixture::changed, fixture::flat_deck;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::vector<std::string> remarks_of(const std::string& yaml) {
  return remarks(read_text(yaml, "deck.yaml", fixture::schema()));
}

std::vector<std::string> field_remarks_of(const std::string& yaml) {
  return remarks_on_fields(read_text(yaml, "deck.yaml", fixture::schema()), fixture::schema());
}

TEST(Remarks, AnOrdinaryDeckHasNone) {
  EXPECT_THAT(remarks_of(base_deck), IsEmpty());
  EXPECT_THAT(field_remarks_of(base_deck), IsEmpty());
}

TEST(Remarks, ALoadThatNeverUsesT) {
  EXPECT_THAT(
      remarks_of(changed(base_deck, "\"0.3*t\"", "0.3")),
      ElementsAre("deck.yaml:22:5: the displacement on head does not use t, so that it is there in full from the "
                  "first step on, and all 20 steps find the same state, as no load uses t; let it grow as in "
                  "\"1.5*t\" unless that is meant"));
  // The cases are a steady load beside one that grows, a formula of the place alone, and a pressure.
  EXPECT_THAT(
      remarks_of(changed(base_deck, "steps:",
                         "  - {set: all, body_force: {y: \"-1e-3*x\"}}\n  - {set: all, pressure: "
                         "2}\nsteps:")),
      ElementsAre(
          "deck.yaml:24:5: the body_force on all does not use t, so that it is there in full from the first step "
          "on; let it grow as in \"1.5*t\" unless that is meant",
          "deck.yaml:25:5: the pressure on all does not use t, so that it is there in full from the first step "
          "on; let it grow as in \"1.5*t\" unless that is meant"));
  // These give no remark: one component that grows is enough, one step has no other, and in time a load may well act
  // from the start.
  EXPECT_THAT(remarks_of(changed(base_deck, "{z: \"0.3*t\"}", "{x: 1, z: \"0.3*t\"}")), IsEmpty());
  EXPECT_THAT(remarks_of(changed(changed(base_deck, "\"0.3*t\"", "0.3"), "count: 20", "count: 1")), IsEmpty());
  EXPECT_THAT(remarks_of(changed(changed(base_deck, "\"0.3*t\"", "0.3"), "    model:", "    density: 1\n    model:") +
                         "dynamics: explicit\n"),
              IsEmpty());
}

TEST(Remarks, AHorizonOfTheNearestNeighbours) {
  const auto sentence = [](const char* place, const char* spacings) {
    return std::string("deck.yaml:") + place + ": a horizon of " + spacings +
           " times the spacing holds hardly more than the nearest neighbours, whose bonds follow the lattice and not "
           "the material; "
           "3 are usual";
  };
  EXPECT_THAT(remarks_of(changed(base_deck, "3.015", "1.0")), ElementsAre(sentence("8:10", "1")));
  EXPECT_THAT(remarks_of(changed(base_deck, "ratio: 3.015", "length: 1.2")), ElementsAre(sentence("8:10", "1.2")));
  EXPECT_THAT(remarks_of(changed(flat_deck, "length: 1.5", "length: 0.6")),
              ::testing::Contains(sentence("3:10", "1.2")));
  EXPECT_THAT(remarks_of(changed(base_deck, "3.015", "1.5")), IsEmpty());
}

TEST(Remarks, AFieldThatTheSceneDoesNotHave) {
  EXPECT_THAT(field_remarks_of(changed(base_deck, "[displacement, force]", "[plastic_strain_zz, velocity]")),
              ElementsAre("deck.yaml:28:29: this scene has no field plastic_strain_zz, so that it will not be in "
                          "results.h5; it exists in plastic 2-D scenes",
                          "deck.yaml:28:48: this scene has no field velocity, so that it will not be in results.h5; it "
                          "exists with dynamics: explicit"));
  EXPECT_THAT(field_remarks_of(flat_deck + "output: {fields: [stress, plastic_multiplier]}\n"),
              ElementsAre("deck.yaml:9:27: this scene has no field plastic_multiplier, so that it will not be in "
                          "results.h5; it exists in plastic scenes"));
}

}  // namespace
}  // namespace perinox::deck
