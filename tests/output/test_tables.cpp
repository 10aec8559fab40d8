#include <gmock/gmock.h>

#include <cstdlib>

#include "deck/history_columns.hpp"
#include "perinox/output/tables.hpp"
#include "support/shuffled_body.hpp"

namespace perinox::output {
namespace {
using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(HistoryTable, HoldsNamedColumnsAndReadsBackToTheSameNumbers) {
  const test::TemporaryDirectory directory;
  HistoryTable table(directory / "history.csv", {"pull", "a \"quoted\", name"});
  StepRecord record = test::step_record(7, 0.1);
  record.history = {1.0 / 3.0, -2e-300};
  record.stored_energy = 0.125;
  record.dissipated_energy = 0.5;
  record.external_work = 0.625;
  record.seconds = 1.5;
  record.profile.count[static_cast<std::size_t>(Section::product)] = 51;
  for (std::size_t s = 0; s < section_count; ++s) record.profile.seconds[s] = 1 + 0.0625 * static_cast<double>(s);
  table.row(record);
  EXPECT_THAT(
      test::file_lines(directory / "history.csv"),  // read while the table is still open
      ElementsAre("step,t,pull,\"a \"\"quoted\"\", name\",stored_energy,dissipated_energy,external_work,"
                  "newton_iterations,linear_iterations,seconds,products,seconds_product,seconds_preconditioner,"
                  "seconds_halo,seconds_assembly,seconds_output,seconds_force,seconds_linearise",
                  "7,0.10000000000000001,0.33333333333333331,-2.0000000000000001e-300,0.125,0.5,0.625,3,47,1.5,51,"
                  "1,1.0625,1.125,1.1875,1.375,1.25,1.3125"));
  EXPECT_EQ(table.failure(), "");
}

/// The names that a deck's history entries cannot have must be those of the table's own columns, all of them.
TEST(HistoryTable, ItsColumnsAreTheNamesThatAreTaken) {
  std::string all;
  for (const std::string& name : deck::history_columns) all += (all.empty() ? "" : ",") + name;
  EXPECT_EQ(HistoryTable::header({}, {true, true, true, true}), all);
}

TEST(ConvergenceTable, HoldsOneRowAnIterationWithItsAttempt) {
  const test::TemporaryDirectory directory;
  ConvergenceTable table(directory / "convergence.csv");
  table.row({2, 0.5, 1, 10, 0.25, 3, 0.75, 12, 0.0625, 0.5}, 3);
  EXPECT_THAT(test::file_lines(directory / "convergence.csv"),
              ElementsAre("step,t,attempt,iteration,residual,relative_residual,update,relative_update,"
                          "linear_iterations,forcing,step_length",
                          "2,0.5,3,1,10,0.25,3,0.75,12,0.0625,0.5"));
}

TEST(GrowingFile, KeepsItsFirstFailure) {
  GrowingFile missing("/nonexistent/table.csv");
  EXPECT_THAT(missing.failure(), HasSubstr("/nonexistent/table.csv cannot be created: No such file"));
  GrowingFile full("/dev/full");
  EXPECT_EQ(full.failure(), "");
  full.append("1,2,3");
  EXPECT_THAT(full.failure(), HasSubstr("/dev/full could not be written: No space left on device"));
}

}  // namespace
}  // namespace perinox::output
