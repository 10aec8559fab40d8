/// Tests runs that are stopped, killed or refused, and go on, as a user meets them.
#include <gmock/gmock.h>

#include <functional>

#include "decks.hpp"
#include "program.hpp"
#include "support/breaking_decks.hpp"

namespace perinox::cli {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

/// A few plastic steps of a few milliseconds.
const std::string deck = changed(changed(base_deck, "count: 2", "count: 6"), "0.01*t", "0.05*t");

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells(1);
  for (const char letter : line)
    if (letter == ',')
      cells.emplace_back();
    else
      cells.back() += letter;
  return cells;
}

/// The text of history.csv without its wall-clock times.
std::vector<std::string> history(const Folder& folder, const std::string& results) {
  std::vector<std::string> lines = lines_of(read(folder.path() / results / "history.csv"));
  const std::vector<std::string> names = lines.empty() ? lines : cells_of(lines.front());
  for (std::string& line : lines) {
    const std::vector<std::string> cells = cells_of(line);
    line.clear();
    for (std::size_t k = 0; k < cells.size(); ++k)
      if (k >= names.size() || names[k].rfind("seconds", 0) != 0) line += cells[k] + ',';
  }
  return lines;
}

/// Expects the same displacements of the last step, bit by bit as far as text can tell: results.xdmf names the steps,
/// and history.csv has sums of displacements with 17 digits.
void expect_same_results(const Folder& folder, const std::string& one, const std::string& other) {
  EXPECT_EQ(history(folder, one), history(folder, other));
  EXPECT_EQ(read(folder.path() / one / "convergence.csv"), read(folder.path() / other / "convergence.csv"));
  EXPECT_EQ(read(folder.path() / one / "results.xdmf"), read(folder.path() / other / "results.xdmf"));
}

/// Starts a run, sends it `signal` once `steps` steps are in its history and there is a checkpoint, and waits for its
/// end.
int interrupted(const Folder& folder, const std::string& results, int signal, std::size_t steps, std::string& error,
                const std::string& set = "steps.count=2000") {
  const std::string out = folder.path() / "out", err = folder.path() / "err";
  const pid_t child = fork();
  if (child == 0) {
    const int file = open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    dup2(file, STDERR_FILENO);
    if (chdir(folder.path().c_str()) == 0)
      execl(PERINOX_BINARY, PERINOX_BINARY, "run", "deck.yaml", "--output", results.c_str(), "--quiet", "--set",
            "output.checkpoint_every=1", "--set", set.c_str(), nullptr);
    _exit(127);
  }
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while ((lines_of(read(folder.path() / results / "history.csv")).size() < steps + 2 ||
          !std::filesystem::exists(folder.path() / results / "checkpoint.h5")) &&
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
  EXPECT_EQ(history(folder, "part").size(), 3u);
  const Outcome rest = folder.perinox({"run", "deck.yaml", "--restart", "part/checkpoint.h5"});
  ASSERT_EQ(rest.status, 0) << rest.error;
  EXPECT_THAT(rest.out, HasSubstr("restart after step 1"));
  expect_same_results(folder, "whole", "part");
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "part/previous-1"));
  // A run that is finished has nothing left to do.
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
  whole.erase(whole.begin() + 1, whole.begin() + 3);  // the start and step 1
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
  EXPECT_EQ(history(folder, "part").size(), 8u);
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
  EXPECT_EQ(history(folder, "part").size(), 14u);
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
    const std::string name = signal == SIGTERM ? "SIGTERM" : signal == SIGINT ? "SIGINT" : "SIGUSR1";
    // The signal is reported at once, and again when the run has stopped.
    EXPECT_THAT(error, StartsWith("\nperinox: " + name + ": stops after the step at hand; a second one ends the run"));
    EXPECT_THAT(error, HasSubstr(name + " was received"));
    EXPECT_THAT(error, HasSubstr("resume with: perinox run deck.yaml --restart part/checkpoint.h5 --set "
                                 "output.checkpoint_every=1"));
    const std::size_t steps = history(folder, "part").size() - 2;
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
  const std::size_t steps = history(folder, "part").size() - 2;
  const Outcome rest = folder.perinox({"run", "deck.yaml", "--restart", "part/checkpoint.h5", "--quiet", "--set",
                                       "steps.count=2000", "--set", "steps.time_limit=1e-3"});
  EXPECT_EQ(rest.status, 1) << rest.error;
  // The last row may have been on the disk before its checkpoint.
  EXPECT_GE(history(folder, "part").size() - 2, steps);
}

/// Goes on for a moment at a time until the run is done. Returns how often it stopped, and how often within a step.
std::pair<int, int> go_on_in_moments(const Folder& folder, const std::string& results, const std::vector<int>& ranks) {
  int stops = 0, within = 0;
  std::vector<std::string> arguments = {"run", "deck.yaml", "--output", results};
  for (;;) {
    std::vector<std::string> all = arguments;
    all.insert(all.end(), {"--quiet", "--set", "steps.time_limit=1e-3"});
    const int on = ranks[static_cast<std::size_t>(stops) % ranks.size()];
    const Outcome outcome = on > 1 ? folder.perinox_on_ranks(on, all) : folder.perinox(all);
    if (outcome.status == 0) return {stops, within};
    EXPECT_THAT(outcome.error, HasSubstr("steps.time_limit")) << outcome.error;
    if (outcome.status != 1 || stops == 200) return {-1, within};
    ++stops;
    if (outcome.error.find("stopped within step") != std::string::npos) ++within;
    arguments = {"run", "deck.yaml", "--restart", results + "/checkpoint.h5"};
  }
}

TEST(Restart, ABarThatSnapsGoesOnFromWithinItsMotion) {
  const Folder folder;
  folder.write("deck.yaml", test::snapping_bar);
  ASSERT_EQ(folder.perinox({"run", "deck.yaml", "--output", "whole", "--quiet"}).status, 0);
  const auto [stops, within] = go_on_in_moments(folder, "part", {1});
  EXPECT_GT(within, 10);  // 26, every ten time steps
  EXPECT_GT(stops, within);
  expect_same_results(folder, "whole", "part");
}

TEST(Restart, ACrackThatGrowsGoesOnAfterEachStep) {
  const Folder folder;
  folder.write("deck.yaml", test::torn_plate);
  ASSERT_EQ(folder.perinox({"run", "deck.yaml", "--output", "whole", "--quiet"}).status, 0);
  EXPECT_EQ(go_on_in_moments(folder, "part", {1}), (std::pair<int, int>{5, 0}));
  expect_same_results(folder, "whole", "part");
}

TEST(Restart, BlocksThatCollideGoOnFromWithinARow) {
  const Folder folder;
  folder.write("deck.yaml", test::smashed_blocks);
  ASSERT_EQ(folder.perinox({"run", "deck.yaml", "--output", "whole", "--quiet"}).status, 0);
  EXPECT_GT(go_on_in_moments(folder, "part", {1}).second, 8);  // 15
  expect_same_results(folder, "whole", "part");
}

TEST(Restart, OfARunInTimeOnOneTwoAndThreeRanksInTurn) {
  const Folder folder;
  folder.write("deck.yaml", test::smashed_blocks);
  ASSERT_EQ(folder.perinox({"run", "deck.yaml", "--output", "whole", "--quiet"}).status, 0);
  EXPECT_GT(go_on_in_moments(folder, "part", {1, 2, 3}).second, 8);
  const std::vector<std::string> a = history(folder, "whole"), b = history(folder, "part");
  ASSERT_EQ(a.size(), b.size());
  const std::size_t columns = cells_of(a[0]).size();
  std::vector<double> scale(columns, 0.0), off(columns, 0.0);
  for (std::size_t k = 1; k < a.size(); ++k)
    for (std::size_t c = 0; c + 1 < columns; ++c) {
      const double x = std::stod(cells_of(a[k])[c]), y = std::stod(cells_of(b[k])[c]);
      scale[c] = std::max(scale[c], std::abs(x));
      off[c] = std::max(off[c], std::abs(x - y));
    }
  for (std::size_t c = 0; c < columns; ++c)
    EXPECT_LE(off[c], 1e-10 * scale[c]) << cells_of(a[0])[c];  // measured 3.8e-15, in contact_energy
}

TEST(Restart, ASignalEndsARunInTimeWithinItsRow) {
  const Folder folder;
  // The signal is sent when there is a checkpoint within the first row, which has 400 time steps.
  const std::string longer = changed(test::smashed_blocks, "end: 2e-5", "end: 2e-4");
  folder.write("deck.yaml", longer + "output: {checkpoint_seconds: 1e-9}\n");
  std::string error;
  EXPECT_EQ(interrupted(folder, "part", SIGTERM, 0, error, "title=ended"), 1);
  EXPECT_THAT(error, HasSubstr("stopped within step 1"));
  EXPECT_THAT(error, HasSubstr("SIGTERM was received"));
  EXPECT_THAT(error, HasSubstr("resume with: perinox run deck.yaml --restart part/checkpoint.h5"));
  EXPECT_EQ(history(folder, "part").size(), 2u);
  const Outcome rest = folder.perinox({"run", "deck.yaml", "--restart", "part/checkpoint.h5"});
  ASSERT_EQ(rest.status, 0) << rest.error;
  EXPECT_THAT(rest.out, HasSubstr("restart within step 1"));
  folder.write("deck.yaml", longer);
  ASSERT_EQ(folder.perinox({"run", "deck.yaml", "--output", "whole", "--quiet"}).status, 0);
  expect_same_results(folder, "whole", "part");
}

TEST(Restart, AKilledRunInTimeGoesOnFromWithinItsRow) {
  const Folder folder;
  const std::string longer = changed(test::smashed_blocks, "end: 2e-5", "end: 2e-4");
  folder.write("deck.yaml", longer);
  ASSERT_EQ(folder.perinox({"run", "deck.yaml", "--output", "whole", "--quiet"}).status, 0);
  folder.write("deck.yaml", longer + "output: {checkpoint_seconds: 1e-9}\n");
  std::string error;
  EXPECT_EQ(interrupted(folder, "part", SIGKILL, 0, error, "title=killed"), 128 + SIGKILL);
  const Outcome rest = folder.perinox({"run", "deck.yaml", "--restart", "part/checkpoint.h5"});
  ASSERT_EQ(rest.status, 0) << rest.error;
  EXPECT_THAT(rest.out, HasSubstr("restart within step"));
  EXPECT_EQ(history(folder, "part"), history(folder, "whole"));
}

TEST(Restart, QuickStepsAreNotEachCheckpointed) {
  const Folder folder;
  folder.write("deck.yaml", deck);
  // Forty steps take less than the five seconds that the clock waits, so there is no checkpoint until the end, and then
  // one.
  const Outcome run = folder.perinox({"run", "deck.yaml", "--output", "r", "--set", "steps.count=40"});
  ASSERT_EQ(run.status, 0) << run.error;
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "r/checkpoint.h5"));
  const auto seconds_of = [&](const std::string& results) {
    double sum = 0;
    const std::vector<std::string> lines = lines_of(read(folder.path() / results / "history.csv"));
    const std::vector<std::string> names = cells_of(lines[0]);
    const auto column = std::find(names.begin(), names.end(), "seconds_output") - names.begin();
    for (std::size_t k = 1; k < lines.size(); ++k)
      sum += std::stod(cells_of(lines[k])[static_cast<std::size_t>(column)]);
    return sum;
  };
  ASSERT_EQ(folder
                .perinox({"run", "deck.yaml", "--output", "each", "--set", "steps.count=40", "--set",
                          "output.checkpoint_every=1"})
                .status,
            0);
  EXPECT_LT(seconds_of("r"), 0.7 * seconds_of("each"));  // 0.4 for inputs/shear_cube.yaml, three runs of each
  // A stop by a signal has a checkpoint whatever the clock says, and so has a stop by the time limit.
  ASSERT_EQ(folder.perinox({"run", "deck.yaml", "--output", "s", "--set", "steps.time_limit=1e-3"}).status, 1);
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "s/checkpoint.h5"));
}

TEST(Restart, TheStartIsWrittenOnce) {
  for (const std::string& text : {deck, test::snapping_bar, test::smashed_blocks}) {
    const Folder folder;
    folder.write("deck.yaml", text);
    go_on_in_moments(folder, "part", {1});
    const std::vector<std::string> rows = history(folder, "part");
    ASSERT_GT(rows.size(), 3u);
    EXPECT_THAT(rows[1], StartsWith("0,0,"));
    EXPECT_THAT(rows[2], StartsWith("1,"));
    EXPECT_THAT(read(folder.path() / "part/results.xdmf"), HasSubstr("results.h5:/steps/0/displacement"));
  }
}

TEST(Restart, ARunInTimeStartsWithItsKineticEnergy) {
  const Folder folder;
  folder.write("deck.yaml", test::smashed_blocks);
  ASSERT_EQ(folder.perinox({"run", "deck.yaml", "--output", "r", "--quiet"}).status, 0);
  const std::vector<std::string> rows = history(folder, "r"), names = cells_of(rows[0]);
  const auto value = [&](std::size_t row, const char* name) {
    const auto column = std::find(names.begin(), names.end(), name) - names.begin();
    return std::stod(cells_of(rows[row])[static_cast<std::size_t>(column)]);
  };
  EXPECT_GT(value(1, "kinetic_energy"), 0);
  EXPECT_EQ(value(1, "kinetic_energy"), value(1, "external_work"));  // what has given the blocks their velocities
  EXPECT_EQ(value(1, "stored_energy"), 0);
  EXPECT_EQ(value(1, "time_steps"), 0);
}

/// A run that is copied with its deck goes on where it is now. The contents of its files must be the same.
TEST(Restart, ACopiedRunGoesOnWithItsFiles) {
  const Folder folder;
  std::filesystem::create_directories(folder.path() / "old/data");
  const std::string linear = changed(changed(cloud_deck, "cloud.csv", "data/cloud.csv"), "field.csv", "data/field.csv");
  folder.write("old/deck.yaml",
               linear + "steps: {end: 1, count: 4}\nhistory: [{name: u, displacement: all, component: x}]\n");
  folder.write("old/data/cloud.csv", cloud);
  folder.write("old/data/field.csv", field);
  ASSERT_EQ(folder.perinox({"run", "old/deck.yaml", "--output", "whole", "--quiet"}).status, 0);
  ASSERT_EQ(
      folder.perinox({"run", "old/deck.yaml", "--output", "old/r", "--quiet", "--set", "steps.time_limit=1e-3"}).status,
      1);
  EXPECT_THAT(read(folder.path() / "old/r/deck.resolved.yaml"),
              AllOf(HasSubstr("../data/cloud.csv"), HasSubstr("../data/field.csv"), Not(HasSubstr("old"))));
  std::filesystem::copy(folder.path() / "old", folder.path() / "copy", std::filesystem::copy_options::recursive);
  std::filesystem::rename(folder.path() / "old", folder.path() / "gone");
  // A table of other numbers at the same place is another problem.
  folder.write("copy/data/field.csv", changed(field, "0.1,0,0", "0.2,0,0"));
  const Outcome refused = folder.perinox({"run", "copy/deck.yaml", "--restart", "copy/r", "--quiet"});
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.error, AllOf(HasSubstr("copy/data/field.csv of boundary[0].displacement.table does not hold what "
                                             "it held when copy/r/checkpoint.h5 was written"),
                                   HasSubstr("start anew without --restart")));
  folder.write("copy/data/field.csv", field);
  const Outcome rest = folder.perinox({"run", "copy/deck.yaml", "--restart", "copy/r", "--quiet"});
  ASSERT_EQ(rest.status, 0) << rest.error;
  EXPECT_EQ(history(folder, "copy/r"), history(folder, "whole"));
  // The resolved deck of the copy runs too.
  const Outcome again = folder.perinox({"run", "copy/r/deck.resolved.yaml", "--output", "again", "--quiet"});
  ASSERT_EQ(again.status, 0) << again.error;
  EXPECT_EQ(history(folder, "again"), history(folder, "whole"));
}

}  // namespace
}  // namespace perinox::cli
