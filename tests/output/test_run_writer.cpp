#include <gmock/gmock.h>

#include <filesystem>

#include "output/parallel_file.hpp"
#include "output/run_directory.hpp"
#include "perinox/core/error.hpp"
#include "perinox/output/run_writer.hpp"
#include "support/shuffled_body.hpp"

namespace perinox::output {
namespace {
namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

class RunWriterTest : public ::testing::Test {
 protected:
  RunWriterTest() {
    deck_.title = "test";
    deck_.body.resize(2);
    deck_.body[0].name = "one";
    deck_.body[1].name = "two";
    deck_.output.every = 2;
    deck_.output.fields = {"damage", "displacement", "dilatation"};
    deck_.history.resize(1);
    deck_.history[0].name = "pull";
    deck_.resolved = deck::Value::map({}, {}, true);
  }

  StepRecord record(int step, bool last) {
    StepRecord made = test::step_record(step, 0.25 * step);
    made.history = {10.0 * step};
    made.fields = {{"displacement", 3, displacement_.data()},
                   {"force", 3, force_.data()},
                   {"dilatation", 1, dilatation_.data()},
                   {"stored_energy", 1, dilatation_.data()}};
    made.last = last;
    return made;
  }

  test::TemporaryDirectory directory_;
  Communicator one_rank_{MPI_COMM_SELF};
  body::Body body_ = test::shuffled_body(one_rank_, 20, 3);
  std::vector<double> displacement_ = test::field_values(body_, 3, 3);
  std::vector<double> force_ = test::field_values(body_, 4, 3);
  std::vector<double> dilatation_ = test::field_values(body_, 5, 1);
  deck::Deck deck_;
};

TEST_F(RunWriterTest, WritesWhatWasAskedAndSaysWhatIsMissing) {
  const std::string place = directory_ / "deep/inside";
  ::testing::internal::CaptureStderr();
  ::testing::internal::CaptureStdout();
  {
    RunWriter writer(deck_, body_, place, true);
    writer.run_begins(record(0, false));
    writer.newton_iteration({1, 0.5, 0, 1, 1, 0, 0, 0, 0, 1});
    writer.step_rejected(0, 0.5, "no descent");
    writer.newton_iteration({1, 0.25, 0, 1, 1, 0, 0, 0, 0, 1});
    writer.step_committed(record(1, false));
    writer.newton_iteration({2, 0.5, 0, 1, 1, 0, 0, 0, 0, 1});
    writer.step_committed(record(2, false));
    writer.step_committed(record(3, true));
  }
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");  // quiet
  EXPECT_EQ(::testing::internal::GetCapturedStderr(),
            "warning: this scene carries no field damage: it is not in results.h5\n");

  const ParallelFile file(place + "/results.h5", one_rank_, ParallelFile::Mode::read);
  EXPECT_TRUE(file.has("/steps/0/displacement"));
  EXPECT_FALSE(file.has("/steps/1"));  // every: 2
  EXPECT_TRUE(file.has("/steps/2/displacement"));
  EXPECT_TRUE(file.has("/steps/3/force"));  // the last one, asked or not
  EXPECT_TRUE(file.has("/steps/3/dilatation"));
  EXPECT_FALSE(file.has("/steps/3/stored_energy"));
  EXPECT_THAT(test::file_lines(place + "/history.csv"),
              ElementsAre(StartsWith("step,t,pull,"), StartsWith("0,0,0,"), StartsWith("1,0.25,10,"),
                          StartsWith("2,0.5,20,"), StartsWith("3,0.75,30,")));
  EXPECT_THAT(test::file_lines(place + "/convergence.csv"),
              ElementsAre(StartsWith("step,t,attempt,"), StartsWith("1,0.5,1,0,"), StartsWith("1,0.25,2,0,"),
                          StartsWith("2,0.5,1,0,")));
  EXPECT_TRUE(fs::exists(place + "/results.xdmf"));
  EXPECT_TRUE(fs::exists(place + "/deck.resolved.yaml"));
}

TEST_F(RunWriterTest, ARunThatStopsShortLeavesItsLastConvergedStep) {
  const std::string place = directory_ / "stopped";
  ::testing::internal::CaptureStderr();
  {
    RunWriter writer(deck_, body_, place, true);
    for (int step = 1; step <= 3; ++step) writer.step_committed(record(step, false));
    const StepRecord last = record(3, false);
    writer.run_stopped(&last);
  }
  {
    RunWriter writer(deck_, body_, directory_ / "at_once", true);
    writer.run_stopped(nullptr);
  }
  ::testing::internal::GetCapturedStderr();
  const ParallelFile file(place + "/results.h5", one_rank_, ParallelFile::Mode::read);
  EXPECT_TRUE(file.has("/steps/2/displacement"));  // every: 2
  EXPECT_TRUE(file.has("/steps/3/displacement"));  // and where it stopped
}

TEST_F(RunWriterTest, AStateThatHasLostItsEquilibriumIsOneStepFurther) {
  const std::string place = directory_ / "lost";
  ::testing::internal::CaptureStderr();
  {
    RunWriter writer(deck_, body_, place, true);
    for (int step = 1; step <= 3; ++step) writer.step_committed(record(step, false));
    const StepRecord lost = record(4, false);  // a step that `every: 2` would write had it come to its end
    writer.run_stopped(&lost);
  }
  ::testing::internal::GetCapturedStderr();
  const ParallelFile file(place + "/results.h5", one_rank_, ParallelFile::Mode::read);
  EXPECT_TRUE(file.has("/steps/2/displacement"));
  EXPECT_FALSE(file.has("/steps/3"));
  EXPECT_TRUE(file.has("/steps/4/displacement"));
  EXPECT_EQ(test::file_lines(place + "/history.csv").size(), 4u);  // the header and three rows
}

TEST_F(RunWriterTest, MovesEarlierResultsAside) {
  const auto run = [&](int steps) {
    RunWriter writer(deck_, body_, directory_.path(), false);
    for (int step = 1; step <= steps; ++step) writer.step_committed(record(step, step == steps));
  };
  ::testing::internal::CaptureStdout();
  ::testing::internal::CaptureStderr();
  run(1);
  EXPECT_THAT(::testing::internal::GetCapturedStdout(), StartsWith("  committed step 1"));
  std::ofstream(directory_ / "notes.txt") << "mine";
  ::testing::internal::CaptureStdout();
  run(2);
  EXPECT_THAT(::testing::internal::GetCapturedStdout(),
              StartsWith(directory_.path() + " held earlier results: 5 files are moved to " + directory_.path() +
                         "/previous-1\n"));
  ::testing::internal::CaptureStdout();
  run(3);
  EXPECT_THAT(::testing::internal::GetCapturedStdout(), HasSubstr("/previous-2\n"));
  ::testing::internal::GetCapturedStderr();
  EXPECT_EQ(test::file_lines(directory_ / "previous-1/history.csv").size(), 2u);
  EXPECT_EQ(test::file_lines(directory_ / "previous-2/history.csv").size(), 3u);
  EXPECT_EQ(test::file_lines(directory_ / "history.csv").size(), 4u);
  EXPECT_TRUE(fs::exists(directory_ / "previous-1/results.h5"));
  EXPECT_TRUE(fs::exists(directory_ / "notes.txt"));
}

TEST_F(RunWriterTest, RefusesADirectoryItCannotUseBeforeAnythingRuns) {
  std::ofstream(directory_ / "file") << "in the way";
  for (const std::string& place : {directory_ / "file", directory_ / "file/below"}) try {
      const RunWriter writer(deck_, body_, place, true);
      ADD_FAILURE() << place << " was accepted";
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), AllOf(HasSubstr("the output directory " + place + " cannot be used"),
                                      HasSubstr("choose another with --output")));
    }
  EXPECT_EQ(test::file_text(directory_ / "file"), "in the way");
}

}  // namespace
}  // namespace perinox::output
