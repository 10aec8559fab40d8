/// Tests that one run at a time has an output directory to itself.
#include <gmock/gmock.h>

#include "decks.hpp"
#include "program.hpp"

namespace perinox::cli {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

/// A run whose steps take some milliseconds each and that lasts longer than any of these tests.
const std::string endless = changed(changed(base_deck, "count: 2", "count: 100000"), "0.01*t", "0.05*t");

/// A run that goes on in the background until it is ended.
class Background {
 public:
  Background(const Folder& folder, const std::string& deck, const std::string& results)
      : history_(folder.path() / results / "history.csv") {
    child_ = fork();
    if (child_ == 0) {
      const int nothing = open("/dev/null", O_RDWR);
      dup2(nothing, STDERR_FILENO);
      if (chdir(folder.path().c_str()) == 0)
        execl(PERINOX_BINARY, PERINOX_BINARY, "run", deck.c_str(), "--output", results.c_str(), "--quiet", "--set",
              "output.checkpoint_every=1", nullptr);
      _exit(127);
    }
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (rows() < 6 && std::chrono::steady_clock::now() < end)
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  ~Background() { end(SIGKILL); }
  Background(const Background&) = delete;
  Background& operator=(const Background&) = delete;

  pid_t process() const { return child_; }
  std::size_t rows() const { return lines_of(read(history_)).size(); }
  void end(int signal) {
    if (child_ <= 0) return;
    kill(child_, signal);
    waitpid(child_, nullptr, 0);
    child_ = -1;
  }

 private:
  std::filesystem::path history_;
  pid_t child_ = -1;
};

TEST(OutputDirectory, ASecondRunIsRefusedWithTheNameOfTheFirst) {
  const Folder folder;
  std::filesystem::create_directories(folder.path() / "A");
  std::filesystem::create_directories(folder.path() / "B");
  folder.write("A/deck.yaml", endless);
  folder.write("B/deck.yaml", base_deck);
  Background first(folder, "A/deck.yaml", "results/deck");
  ASSERT_GE(first.rows(), 6u);
  const std::string whose =
      "the output directory results/deck is in use by process " + std::to_string(first.process()) + " on ";
  // Both decks are called deck.yaml, so B's results would go into the same directory.
  for (const int ranks : {1, 2}) {
    const std::vector<std::string> arguments{"run", "B/deck.yaml"};
    const Outcome second = ranks == 1 ? folder.perinox(arguments) : folder.perinox_on_ranks(ranks, arguments);
    EXPECT_EQ(second.status, 2);
    EXPECT_THAT(second.error, AllOf(HasSubstr(whose), HasSubstr((folder.path() / "A/deck.yaml").string()),
                                    HasSubstr("choose another directory with --output")));
  }
  // A restart into it is refused too.
  const Outcome restart = folder.perinox({"run", "A/deck.yaml", "--restart", "results/deck"});
  EXPECT_EQ(restart.status, 2);
  EXPECT_THAT(restart.error, HasSubstr(whose));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "results/deck/previous-1"));
  // Another directory is free.
  EXPECT_EQ(folder.perinox({"run", "B/deck.yaml", "--output", "other", "--quiet"}).status, 0);
}

TEST(OutputDirectory, AKilledRunBlocksNobody) {
  const Folder folder;
  folder.write("deck.yaml", endless);
  Background first(folder, "deck.yaml", "r");
  ASSERT_GE(first.rows(), 6u);
  first.end(SIGKILL);
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "r/run.lock"));
  const Outcome rest =
      folder.perinox({"run", "deck.yaml", "--restart", "r", "--quiet", "--set", "steps.time_limit=1e-3"});
  EXPECT_EQ(rest.status, 1) << rest.error;
  EXPECT_THAT(rest.error, HasSubstr("steps.time_limit"));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "r/run.lock"));
}

TEST(OutputDirectory, ARefusedRunLeavesNoDirectory) {
  const Folder folder;
  folder.write("deck.yaml", changed(base_deck, "\"z > 3\"", "\"z > 30\""));
  const Outcome refused = folder.perinox({"run", "deck.yaml"});
  EXPECT_EQ(refused.status, 2) << refused.out;
  EXPECT_EQ(folder.names(), std::vector<std::string>{"deck.yaml"});
}

}  // namespace
}  // namespace perinox::cli
