/// Tests child processes, what is kept of them, and when a kept run counts.
#include <cstdlib>

#include "perinox/deck/read.hpp"
#include "perinox/materials/material.hpp"
#include "study/fixture.hpp"
#include "study/run_record.hpp"

namespace perinox::study {
namespace {

std::string text_of(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(ChildProcess, SaysHowItEndedAndWhatItCost) {
  const fixture::Folder folder;
  const std::string out = folder / "out", error = folder / "error";
  const Outcome busy = run_child(
      {"sh", "-c", "i=0; while [ $i -lt 20000 ]; do i=$((i+1)); done; echo said; echo no >&2; exit 3"}, out, error);
  EXPECT_EQ(busy.status, 3);
  EXPECT_GT(busy.cpu_seconds, 0);
  EXPECT_GE(busy.wall_seconds, 0.9 * busy.cpu_seconds);
  EXPECT_GT(busy.peak_megabytes, 0.5);
  EXPECT_EQ(text_of(out), "said\n");
  EXPECT_EQ(text_of(error), "no\n");
  EXPECT_EQ(run_child({"sh", "-c", "kill -9 $$"}, out, error).status, 137);
  EXPECT_THROW(run_child({"no_such_program_anywhere"}, out, error), RunError);
}

TEST(ChildProcess, KnowsNothingOfAnMpirunAround) {
  const fixture::Folder folder;
  ::setenv("OMPI_COMM_WORLD_SIZE", "7", 1);
  ::setenv("OMPI_COMM_WORLD_RANK", "3", 1);
  EXPECT_EQ(ranks_around(), 7);
  EXPECT_FALSE(first_rank_around());
  run_child({"sh", "-c", "echo \"$OMPI_COMM_WORLD_SIZE|$OMP_NUM_THREADS\""}, folder / "out", folder / "error");
  ::unsetenv("OMPI_COMM_WORLD_SIZE");
  ::unsetenv("OMPI_COMM_WORLD_RANK");
  EXPECT_EQ(ranks_around(), 1);
  EXPECT_TRUE(first_rank_around());
  const char* threads = std::getenv("OMP_NUM_THREADS");
  EXPECT_EQ(text_of(folder / "out"), std::string("|") + (threads == nullptr ? "1" : threads) + "\n");
}

TEST(RunRecord, ReadsBack) {
  const fixture::Folder folder;
  RunRecord record;
  record.fingerprint = "h12";
  record.outcome = {1, 0.125, 2.5, 33};
  record.reason = "stopped: \"so\"";
  record.bonds = 12345678901;
  write_record(folder / "", record);
  const auto back = read_record(folder / "");
  ASSERT_TRUE(back);
  EXPECT_EQ(back->fingerprint, "h12");
  EXPECT_EQ(back->outcome.status, 1);
  EXPECT_EQ(back->outcome.cpu_seconds, 0.125);
  EXPECT_EQ(back->outcome.wall_seconds, 2.5);
  EXPECT_EQ(back->outcome.peak_megabytes, 33);
  EXPECT_EQ(back->reason, "stopped: \"so\"");
  EXPECT_EQ(back->bonds, 12345678901);
  folder.write("record.yaml", "fingerprint: h12\nstatus");
  EXPECT_FALSE(read_record(folder / "")) << "half a record is none";
  EXPECT_FALSE(read_record(folder / "nothing"));
}

TEST(RunRecord, IsOfOneDeckItsFilesAndItsRanks) {
  const fixture::Folder folder;
  folder.write("cloud.csv", "x,y,z,volume\n0,0,0,1\n");
  const std::string yaml =
      fixture::changed(fixture::flat_deck, "{box: {min: [0, 0], max: [3, 3]}}", "{file: cloud.csv}");
  const deck::Schema schema(materials::declarations());
  const auto of = [&](const std::vector<std::string>& overrides, int ranks = 1, int repetitions = 1) {
    return fingerprint(deck::read_text(yaml, folder / "deck.yaml", schema, overrides), ranks, repetitions);
  };
  const std::string first = of({});
  EXPECT_EQ(of({}), first);
  EXPECT_EQ(of({"steps.count=10"}), first) << "a default written out changes nothing";
  EXPECT_NE(of({"steps.count=11"}), first);
  EXPECT_NE(of({}, 2), first);
  EXPECT_NE(of({}, 1, 2), first);
  folder.write("cloud.csv", "x,y,z,volume\n0,0,0,2\n");
  EXPECT_NE(of({}), first);
}

TEST(RunRecord, TakesReasonAndBondsFromWhatTheRunSaid) {
  const fixture::Folder folder;
  folder.write("error", "note: a remark\nwarning: something\nperinox: stopped at t = 0.5\n---\nmpirun says more\n");
  EXPECT_EQ(reason_in(folder / "error"), "stopped at t = 0.5");
  folder.write("error", "note: a remark\ndeck.yaml:3:1: wrong\n");
  EXPECT_EQ(reason_in(folder / "error"), "deck.yaml:3:1: wrong");
  folder.write("error",
               "perinox: SIGTERM: stops after the step at hand\nperinox: stopped after step 3: SIGTERM was received\n");
  EXPECT_EQ(reason_in(folder / "error"), "stopped after step 3: SIGTERM was received");
  EXPECT_TRUE(was_told_to_stop(reason_in(folder / "error")));
  EXPECT_FALSE(was_told_to_stop("stopped at t = 0.5"));
  folder.write("out", "title\n  3-D: 1 particles\n  84288 directed bonds, 28 to 122 a family\n");
  EXPECT_EQ(bonds_in(folder / "out"), 84288);
  folder.write("out", "title\n");
  EXPECT_EQ(bonds_in(folder / "out"), 0);
}

}  // namespace
}  // namespace perinox::study
