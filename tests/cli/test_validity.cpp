/// Tests what a run says about states for which the model does not hold: in its log, at its end and in history.csv.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "program.hpp"

namespace perinox::cli {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

const char* const pressed_crack = R"yaml(
dimension: plane-stress
body: [{name: plate, shape: {box: {min: [0, 0], max: [20, 20]}}, spacing: 1, material: m}]
horizon: {ratio: 3.015}
materials: {m: {model: elastic, young_modulus: 1000, poisson_ratio: 0.3}}
cracks: [{segment: {start: [5, 10], end: [15, 10]}}]
sets: {lo: {where: "y < 3"}, hi: {where: "y > 17"}}
boundary: [{set: lo, displacement: {x: 0, y: 0}}, {set: hi, displacement: {x: 0, y: "-2*t*(1.01-t)"}}]
steps: {end: 1, count: 4}
)yaml";

TEST(Validity, FacesOfACrackThatPassEachOtherAreSaidOnceAStepAndAtTheEnd) {
  const Folder folder;
  folder.write("deck.yaml", pressed_crack);
  const Outcome outcome = folder.perinox({"run", "deck.yaml", "--output", "out"});
  EXPECT_EQ(outcome.status, 0) << outcome.error;
  std::size_t said = 0;
  for (const std::string& line : lines_of(outcome.out))
    if (line.find("warning: faces that no bond joins overlap by ") != std::string::npos) ++said;
  EXPECT_EQ(said, 3u) << outcome.out;  // not at the end, where the load is gone
  EXPECT_THAT(outcome.error, StartsWith("warning: in step 2, t = 0.5, faces that no bond joins overlap by "));
  const std::vector<std::string> rows = lines_of(read(folder.path() / "out/history.csv"));
  EXPECT_THAT(rows[0], EndsWith(",overlap"));
  EXPECT_THAT(rows[5], EndsWith(",0"));
  EXPECT_THAT(rows[3], Not(EndsWith(",0")));

  const Outcome quiet = folder.perinox({"run", "deck.yaml", "--output", "out", "--quiet"});
  EXPECT_EQ(quiet.error, outcome.error);
  const Outcome pulled =
      folder.perinox({"run", "deck.yaml", "--output", "out", "--set", "boundary.1.displacement.y=2*t*(1.01-t)"});
  EXPECT_EQ(pulled.status, 0);
  EXPECT_EQ(pulled.error, "");
  EXPECT_THAT(pulled.out, Not(HasSubstr("overlap")));
}

TEST(Validity, AJumpIsSaidAtTheEndWithQuietAndAfterARestart) {
  const Folder folder;
  folder.write("deck.yaml", R"yaml(
dimension: plane-stress
body: [{name: column, shape: {box: {min: [0, 0], max: [40, 3]}}, spacing: 1, material: m}]
horizon: {ratio: 3.015}
materials: {m: {model: elastic, young_modulus: 1000, poisson_ratio: 0.3}}
sets: {l: {where: "x<3"}, r: {where: "x>37"}}
boundary: [{set: l, displacement: {x: 0, y: 0}}, {set: r, force: {x: "-600*t", y: "0.01*t"}}]
steps: {end: 1, count: 4}
)yaml");
  const std::string said =
      "warning: the body jumps to another equilibrium in 1 load step, at t = 0.00683594: 2.276 of ";
  const Outcome whole = folder.perinox({"run", "deck.yaml", "--output", "whole", "--quiet"});
  ASSERT_EQ(whole.status, 0) << whole.error;
  EXPECT_THAT(whole.error, StartsWith(said));
  EXPECT_EQ(lines_of(whole.error).size(), 1u) << whole.error;
  const Outcome first = folder.perinox(
      {"run", "deck.yaml", "--output", "out", "--quiet", "--set", "steps.end=0.5", "--set", "steps.count=2"});
  EXPECT_THAT(first.error, StartsWith(said));
  const Outcome rest = folder.perinox({"run", "deck.yaml", "--restart", "out", "--quiet"});
  ASSERT_EQ(rest.status, 0) << rest.error;
  EXPECT_EQ(rest.error, whole.error);  // and nothing is unaccounted for
}

TEST(Validity, ARestartStillKnowsTheDeepestOverlap) {
  const Folder folder;
  folder.write("deck.yaml", pressed_crack);
  const std::vector<std::string> start{"run", "deck.yaml", "--output", "out"};
  const Outcome whole = folder.perinox(start);
  const Outcome first =
      folder.perinox({"run", "deck.yaml", "--output", "out", "--set", "steps.end=0.75", "--set", "steps.count=3"});
  ASSERT_EQ(first.status, 0) << first.error;
  const Outcome rest = folder.perinox({"run", "deck.yaml", "--restart", "out"});
  ASSERT_EQ(rest.status, 0) << rest.error;
  EXPECT_THAT(whole.error, HasSubstr("in step 2, t = 0.5, faces"));
  EXPECT_THAT(rest.error, HasSubstr("in step 2, t = 0.5, faces"));
}

std::string stretched_bar(double by, const char* deformation) {
  return std::string(R"yaml(
dimension: 3
body: [{name: bar, shape: {box: {min: [0, 0, 0], max: [4, 4, 10]}}, spacing: 1, material: m}]
horizon: {ratio: 2.015}
materials: {m: {model: elastic-plastic, young_modulus: 200e3, poisson_ratio: 0.3, yield_stress: {tension: 350}}}
sets: {lo: {where: "z < 2"}, hi: {where: "z > 8"}}
boundary: [{set: lo, displacement: {x: 0, y: 0, z: 0}}, {set: hi, displacement: {x: 0, y: 0, z: ")yaml") +
         std::to_string(by) + "*t\"}}]\nsteps: {end: 1, count: 5}\ndeformation: " + deformation + "\n";
}

TEST(Validity, BondsThatFlowAndAreStretchedTooFarAreSaidWhenTheyFirstAreAndAtTheEnd) {
  const Folder folder;
  folder.write("deck.yaml", stretched_bar(0.4, "finite"));
  const Outcome outcome = folder.perinox({"run", "deck.yaml", "--output", "out"});
  EXPECT_EQ(outcome.status, 0) << outcome.error;
  const char* const sentence = "a bond of a material that flows is stretched by ";
  std::size_t said = 0;
  for (const std::string& line : lines_of(outcome.out))
    if (line.find(sentence) != std::string::npos) ++said;
  EXPECT_EQ(said, 1u) << outcome.out;
  EXPECT_THAT(outcome.error, StartsWith(std::string("warning: in step 5, t = 1, ") + sentence));
  EXPECT_THAT(folder.perinox({"check", "deck.yaml"}).out,
              HasSubstr("warning: at t = 1 the prescribed displacements stretch a material that flows by 5 % about (2, "
                        "2, 5)"));

  for (const std::string& deck : {stretched_bar(0.4, "small"), stretched_bar(0.05, "finite")}) {
    folder.write("deck.yaml", deck);
    EXPECT_EQ(folder.perinox({"run", "deck.yaml", "--output", "out"}).error, "");
    EXPECT_THAT(folder.perinox({"check", "deck.yaml"}).out, Not(HasSubstr("stretch")));
  }
}

}  // namespace
}  // namespace perinox::cli
