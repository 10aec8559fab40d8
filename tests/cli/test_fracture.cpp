/// Tests runs whose bonds break, as a user starts them: exit status, what is said, what is on disk.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "decks.hpp"
#include "program.hpp"
#include "support/breaking_decks.hpp"

namespace perinox::cli {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

const std::string snapping_bar =
    test::snapping_bar_of("2.015", "{end: 0.25, count: 5}") + "output: {every: 2, fields: [displacement, damage]}\n";

TEST(Fracture, WithoutAFallbackTheRunStopsWithStatus1) {
  const Folder folder;
  folder.write("deck.yaml", snapping_bar);
  const Outcome outcome = folder.perinox({"run", "deck.yaml", "--output", "out", "--set", "fallback=none"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.error, StartsWith("perinox: stopped at t = 0.15 of 0.25, after 2 converged steps: no equilibrium "
                                        "at t = 0.15 once "));
  EXPECT_THAT(outcome.out, HasSubstr("pass 1 at t = 0.15: 1 of 2 critical bonds broken, the worst at "));
  EXPECT_THAT(
      lines_of(read(folder.path() / "out/history.csv")),
      ElementsAre(StartsWith("step,t,stretch,"), StartsWith("0,0,0,"), StartsWith("1,0.05"), StartsWith("2,0.1")));
  // The files have the second step, and the state in which equilibrium was lost under its own number.
  const std::string index = read(folder.path() / "out/results.xdmf");
  EXPECT_THAT(index, HasSubstr("/steps/2/displacement"));
  EXPECT_THAT(index, HasSubstr("/steps/3/damage"));
  EXPECT_THAT(index, Not(HasSubstr("/steps/4/")));
}

TEST(Fracture, WithOneItGoesOnToTheEnd) {
  const Folder folder;
  folder.write("deck.yaml", snapping_bar);
  for (const char* fallback : {"fallback=automatic", "fallback=explicit"}) {
    const Outcome outcome = folder.perinox({"run", "deck.yaml", "--output", "out", "--set", fallback});
    EXPECT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_THAT(outcome.out, HasSubstr("goes on in time from t = 0.15: 4 bonds have broken in one load step"));
    EXPECT_THAT(outcome.out, HasSubstr("at rest at t = 0.15 after "));
    const std::vector<std::string> rows = lines_of(read(folder.path() / "out/history.csv"));
    ASSERT_EQ(rows.size(), 7u);
    EXPECT_THAT(
        rows[0],
        HasSubstr(",passes,broken_bonds,released_energy,relaxed_energy,fragments,single_particles,time,time_steps,"));
    EXPECT_THAT(rows[6], StartsWith("5,0.25,"));
  }
}

TEST(Fracture, CheckSaysWhenBondsBreak) {
  const Folder folder;
  folder.write("deck.yaml", snapping_bar);
  const Outcome outcome = folder.perinox({"check", "deck.yaml"});
  EXPECT_EQ(outcome.status, 0) << outcome.error;
  EXPECT_THAT(outcome.out, HasSubstr("  brittle: bonds break at "));
}

}  // namespace
}  // namespace perinox::cli
