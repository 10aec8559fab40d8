/// Runs that are stopped, killed or refused, and go on: as a user meets it.
#include <gmock/gmock.h>

#include <functional>

#include "decks.hpp"
#include "program.hpp"

namespace perinox::cli {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// A few plastic steps of a few milliseconds.
const std::string deck = changed(changed(base_deck, "count: 2", "count: 6"), "0.01*t", "0.05*t");

/// history.csv without its times: up to linear_iterations.
std::vector<std::string> history(const Folder& folder, const std::string& results) {
  std::vector<std::string> lines = lines_of(read(folder.path() / results / "history.csv"));
  for (std::string& line : lines) {
    std::size_t end = 0;
    for (int column = 0; column < 8; ++column) end = line.find(',', end) + 1;
    line.erase(end - 1);
  }
  return lines;
}

/// The displacements of the last step, bit by bit, as far as text can tell: results.xdmf names the steps, history.csv
/// has sums of them with 17 digits.
void expect_same_results(const Folder& folder, const std::string& one, const std::string& other) {
  EXPECT_EQ(history(folder, one), history(folder, other));
  EXPECT_EQ(read(folder.path() / one / "convergence.csv"), read(folder.path() / other / "convergence.csv"));
  EXPECT_EQ(read(folder.path() / one / "results.xdmf"), read(folder.path() / other / "results.xdmf"));
}

/// Starts a run, sends it `signal` once `steps` steps are in its history, waits for its end.
int interrupted(const Folder& folder, const std::string& results, int signal, std::size_t steps, std::string& error) {
  const std::string out = folder.path() / "out", err = folder.path() / "err";
  const pid_t child = fork();
  if (child == 0) {
    const int file = open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    dup2(file, STDERR_FILENO);
    if (chdir(folder.path().c_str()) == 0)
      execl(PERINOX_BINARY, PERINOX_BINARY, "run", "deck.yaml", "--output", results.c_str(), "--quiet", "--set",
            "steps.count=2000", nullptr);
    _exit(127);
  }
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (lines_of(read(folder.path() / results / "history.csv")).size() < steps + 1 &&
         std::chrono::steady_clock::now() < end)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  kill(child, signal);
  int status = 0;
  waitpid(child, &status, 0);
  error = read(err);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

TEST(Restart, GoesOnInItsOwnDirectoryAsIfNothingHadBeen) {
  const Folder folder;
  folder.write("deck.yaml", deck);
  ASSERT_EQ(folder.perinox({"run", "deck.yaml", "--output", "whole", "--quiet"}).status, 0);
  const Outcome stopped =
      folder.perinox({"run", "deck.yaml", "--output", "part", "--quiet", "--set", "steps.time_limit=1e-3"});
  EXPECT_EQ(stopped.status, 1);
  EXPECT_THAT(stopped.error, HasSubstr("step 1"));
  EXPECT_THAT(stopped.error, HasSubstr("steps.time_limit = 0.001"));
  EXPECT_THAT(stopped.error, HasSubstr("resume with: perinox run deck.yaml --restart part/checkpoint.h5"));
  EXPECT_EQ(history(folder, "part").size(), 2u);
  const Outcome rest = folder.perinox({"run", "deck.yaml", "--restart", "part/checkpoint.h5"});
  ASSERT_EQ(rest.status, 0) << rest.error;
  EXPECT_THAT(rest.out, HasSubstr("restart after step 1"));
  expect_same_results(folder, "whole", "part");
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "part/previous-1"));
  // What is finished has nothing left to do.
  EXPECT_EQ(folder.perinox({"run", "deck.yaml", "--restart", "part", "--quiet"}).status, 0);
  expect_same_results(folder, "whole", "part");
}

TEST(Restart, RowsAfterTheCheckpointAreReplaced) {
  const Folder folder;
  folder.write("deck.yaml", deck);
  ASSERT_EQ(folder.perinox({"run", "deck.yaml", "--output", "whole", "--quiet"}).status, 0);
  ASSERT_EQ(
      folder.perinox({"run", "deck.yaml", "--output", "part", "--quiet", "--set", "output.checkpoint_every=4"}).status,
      0);
  ASSERT_EQ(
      folder.perinox({"run", "deck.yaml", "--output", "part", "--quiet", "--set", "steps.time_limit=1e-3"}).status, 1);
  const std::string early = read(folder.path() / "part/checkpoint.h5");
  ASSERT_EQ(folder.perinox({"run", "deck.yaml", "--restart", "part/checkpoint.h5", "--quiet"}).status, 0);
  folder.write("part/checkpoint.h5", early);  // after step 1, among files of six steps
  ASSERT_EQ(folder.perinox({"run", "deck.yaml", "--restart", "part/checkpoint.h5", "--quiet"}).status, 0);
  expect_same_results(folder, "whole", "part");
}

TEST(Restart, InAnotherDirectoryOnlyTheRestIsWritten) {
  const Folder folder;
  folder.write("deck.yaml", deck);
  ASSERT_EQ(folder.perinox({"run", "deck.yaml", "--output", "whole", "--quiet"}).status, 0);
  ASSERT_EQ(
      folder.perinox({"run", "deck.yaml", "--output", "part", "--quiet", "--set", "steps.time_limit=1e-3"}).status, 1);
  const std::string before = read(folder.path() / "part/history.csv");
  ASSERT_EQ(
      folder.perinox({"run", "deck.yaml", "--restart", "part/checkpoint.h5", "--output", "rest", "--quiet"}).status, 0);
  std::vector<std::string> whole = history(folder, "whole");
  whole.erase(whole.begin() + 1);
  EXPECT_EQ(history(folder, "rest"), whole);
  EXPECT_EQ(read(folder.path() / "part/history.csv"), before);
}

TEST(Restart, OnTwoRanksAndBack) {
  const Folder folder;
  folder.write("deck.yaml", deck);
  ASSERT_EQ(
      folder.perinox({"run", "deck.yaml", "--output", "part", "--quiet", "--set", "steps.time_limit=1e-3"}).status, 1);
  const Outcome two = folder.perinox_on_ranks(
      2, {"run", "deck.yaml", "--restart", "part/checkpoint.h5", "--quiet", "--set", "steps.time_limit=1e-3"});
  EXPECT_EQ(two.status, 1);
  EXPECT_THAT(two.error, HasSubstr("after step 2"));
  EXPECT_THAT(two.error, HasSubstr("mpirun -np 2 perinox run deck.yaml --restart part/checkpoint.h5"));
  ASSERT_EQ(folder.perinox({"run", "deck.yaml", "--restart", "part/checkpoint.h5", "--quiet"}).status, 0);
  EXPECT_EQ(history(folder, "part").size(), 7u);
}

TEST(Restart, AnotherProblemIsRefused) {
  const Folder folder;
  folder.write("deck.yaml", deck);
  ASSERT_EQ(
      folder.perinox({"run", "deck.yaml", "--output", "part", "--quiet", "--set", "steps.time_limit=1e-3"}).status, 1);
  const std::string before = read(folder.path() / "part/checkpoint.h5");
  const Outcome refused = folder.perinox({"run", "deck.yaml", "--restart", "part/checkpoint.h5", "--set",
                                          "materials.steel.shear_modulus=81e3", "--set", "horizon.ratio=2.2"});
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.error, HasSubstr("materials.steel.shear_modulus"));
  EXPECT_THAT(refused.error, HasSubstr("horizon.ratio (2.015 there, 2.2 now)"));
  EXPECT_THAT(refused.error, HasSubstr("may change"));
  EXPECT_EQ(read(folder.path() / "part/checkpoint.h5"), before);
  EXPECT_EQ(folder
                .perinox({"run", "deck.yaml", "--restart", "part/checkpoint.h5", "--quiet", "--set", "steps.end=2",
                          "--set", "steps.count=12", "--set", "solver.newton.tolerance=1e-9"})
                .status,
            0);
  EXPECT_EQ(history(folder, "part").size(), 13u);
}

TEST(Restart, ADamagedCheckpointIsRefusedWithASentence) {
  const Folder folder;
  folder.write("deck.yaml", deck);
  ASSERT_EQ(
      folder.perinox({"run", "deck.yaml", "--output", "part", "--quiet", "--set", "steps.time_limit=1e-3"}).status, 1);
  const std::string whole = read(folder.path() / "part/checkpoint.h5");
  const auto refused = [&](const std::string& bytes) {
    folder.write("part/checkpoint.h5", bytes);
    const Outcome outcome = folder.perinox({"run", "deck.yaml", "--restart", "part/checkpoint.h5"});
    EXPECT_EQ(outcome.status, 2);
    return outcome.error;
  };
  EXPECT_THAT(refused(whole.substr(0, whole.size() / 2)), HasSubstr("part/checkpoint.h5 is truncated"));
  std::string flipped = whole;
  flipped[whole.size() / 3] = static_cast<char>(flipped[whole.size() / 3] ^ 4);
  EXPECT_THAT(refused(flipped), HasSubstr("part/checkpoint.h5 is damaged"));
  EXPECT_THAT(refused("something"), HasSubstr("is no checkpoint of perinox"));
  const Outcome missing = folder.perinox({"run", "deck.yaml", "--restart", "nowhere/checkpoint.h5"});
  EXPECT_EQ(missing.status, 2);
  EXPECT_THAT(missing.error, HasSubstr("nowhere/checkpoint.h5 cannot be read: No such file or directory"));
}

TEST(Restart, FilesThatCannotBeGoneOnWithAreKeptAside) {
  const Folder folder;
  folder.write("deck.yaml", deck);
  ASSERT_EQ(
      folder.perinox({"run", "deck.yaml", "--output", "part", "--quiet", "--set", "steps.time_limit=1e-3"}).status, 1);
  folder.write("part/history.csv", "step,t\n");
  folder.write("part/results.h5", "damaged");
  const Outcome rest = folder.perinox({"run", "deck.yaml", "--restart", "part/checkpoint.h5"});
  ASSERT_EQ(rest.status, 0) << rest.error;
  EXPECT_THAT(rest.out, HasSubstr("history.csv is moved to part/previous-1"));
  EXPECT_THAT(rest.out, HasSubstr("results.h5 is begun anew after step 1"));
  EXPECT_EQ(read(folder.path() / "part/previous-1/history.csv"), "step,t\n");
  EXPECT_EQ(read(folder.path() / "part/previous-2/results.h5"), "damaged");
  EXPECT_EQ(history(folder, "part").size(), 6u);  // steps 2 to 6
}

TEST(Restart, ASignalEndsTheRunAfterItsStep) {
  for (const int signal : {SIGTERM, SIGINT, SIGUSR1}) {
    const Folder folder;
    folder.write("deck.yaml", deck);
    std::string error;
    EXPECT_EQ(interrupted(folder, "part", signal, 3, error), 1);
    EXPECT_THAT(error, HasSubstr(signal == SIGTERM ? "SIGTERM" : signal == SIGINT ? "SIGINT" : "SIGUSR1"));
    EXPECT_THAT(error, HasSubstr("resume with: perinox run deck.yaml --restart part/checkpoint.h5"));
    const std::size_t steps = history(folder, "part").size() - 1;
    EXPECT_GE(steps, 3u);
    const Outcome rest = folder.perinox({"run", "deck.yaml", "--restart", "part/checkpoint.h5", "--quiet", "--set",
                                         "steps.count=2000", "--set", "steps.time_limit=1e-3"});
    EXPECT_THAT(rest.error, HasSubstr("after step " + std::to_string(steps + 1) + ","));
  }
}

TEST(Restart, AKilledRunGoesOn) {
  const Folder folder;
  folder.write("deck.yaml", deck);
  std::string error;
  EXPECT_EQ(interrupted(folder, "part", SIGKILL, 5, error), 128 + SIGKILL);
  const std::size_t steps = history(folder, "part").size() - 1;
  const Outcome rest = folder.perinox({"run", "deck.yaml", "--restart", "part/checkpoint.h5", "--quiet", "--set",
                                       "steps.count=2000", "--set", "steps.time_limit=1e-3"});
  EXPECT_EQ(rest.status, 1) << rest.error;
  // The last row may have been on the disk before its checkpoint.
  EXPECT_GE(history(folder, "part").size() - 1, steps);
}

}  // namespace
}  // namespace perinox::cli
