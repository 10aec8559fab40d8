/// Reads back results.h5 and the tables of a run in one process.
#include <gmock/gmock.h>

#include "output/results_file.hpp"
#include "perinox/core/error.hpp"
#include "perinox/output/results_reader.hpp"
#include "perinox/output/table_reader.hpp"
#include "perinox/output/tables.hpp"
#include "support/shuffled_body.hpp"

namespace perinox::output {
namespace {

using test::value_of;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

template <class Work>
std::string failure_of(const Work& work) {
  try {
    work();
  } catch (const RunError& error) {
    return error.what();
  }
  return "";
}

TEST(ResultsReader, ReadsWhatWasWritten) {
  constexpr GlobalId total = 23;
  const Communicator one_rank(MPI_COMM_SELF);
  const test::TemporaryDirectory directory;
  const body::Body body = test::shuffled_body(one_rank, total, 2);
  ResultsFile results(directory.path(), "a title", {"block", "second"}, body);
  const auto displacement = test::field_values(body, 5, 2), damage = test::field_values(body, 6, 1);
  const std::vector<Field> fields{{"displacement", 2, displacement.data()}, {"damage", 1, damage.data()}};
  results.write(test::step_record(2, 0.25), fields);
  results.write(test::step_record(10, 0.5), fields);

  const ResultsReader file(directory / "results.h5");
  EXPECT_EQ(file.particles(), 23);
  EXPECT_EQ(file.dimension(), 2);
  const auto steps = file.steps();
  ASSERT_EQ(steps.size(), 2);
  EXPECT_EQ(steps[0].number, 2);
  EXPECT_EQ(steps[1].number, 10);
  EXPECT_EQ(steps[1].t, 0.5);
  EXPECT_EQ(file.columns(2, "displacement"), 3);
  EXPECT_EQ(file.columns(2, "damage"), 1);
  EXPECT_EQ(file.columns(2, "force"), 0);
  const auto reference = file.reference(), volume = file.volume(), u = file.field(10, "displacement"),
             d = file.field(10, "damage");
  for (std::size_t i = 0; i < 23; ++i) {
    const auto id = static_cast<GlobalId>(i);
    EXPECT_EQ(volume[i], value_of(id, 2));
    EXPECT_EQ(d[i], value_of(id, 6));
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_EQ(reference[i * 3 + c], c < 2 ? value_of(id, 1, static_cast<int>(c)) : 0);
      EXPECT_EQ(u[i * 3 + c], c < 2 ? value_of(id, 5, static_cast<int>(c)) : 0);
    }
  }
  EXPECT_THAT(failure_of([&] { file.field(10, "force"); }), HasSubstr("results.h5 has no dataset /steps/10/force"));
  EXPECT_THAT(failure_of([&] { ResultsReader(directory / "none.h5"); }), HasSubstr("none.h5 cannot be opened"));
}

TEST(TableReader, ReadsAHistoryBack) {
  const test::TemporaryDirectory directory;
  const std::string path = directory / "history.csv";
  StepRecord record = test::step_record(4, 1.0 / 3.0);
  record.history = {2.5e-17, -7};
  {
    HistoryTable table(path, {"pull, left", "say \"so\""});
    table.row(record);
    table.row(record);
  }
  std::ofstream(path, std::ios::app) << "9,0.5";  // a row that was not written to its end
  const NumberTable table = read_table(path);
  ASSERT_EQ(table.rows.size(), 2);
  EXPECT_EQ(table.rows[1][table.column("t").value()], 1.0 / 3.0);
  EXPECT_EQ(table.rows[1][table.column("pull, left").value()], 2.5e-17);
  EXPECT_EQ(table.rows[1][table.column("say \"so\"").value()], -7);
  EXPECT_FALSE(table.column("pull"));
}

TEST(TableReader, SaysWhatIsWrong) {
  const test::TemporaryDirectory directory;
  const std::string path = directory / "table.csv";
  EXPECT_EQ(failure_of([&] { read_table(path); }), path + " cannot be read or is empty");
  std::ofstream(path) << "a,b\n1,2\n1,x\n";
  EXPECT_EQ(failure_of([&] { read_table(path); }), path + ", line 3: 'x' is no number");
  std::ofstream(path) << "a,b\n1\n";
  EXPECT_EQ(failure_of([&] { read_table(path); }), path + ", line 2: 1 cells under 2 names");
  EXPECT_THAT(csv_cells("a,\"b,\"\"c\"\"\",,d"), ElementsAre("a", "b,\"c\"", "", "d"));
}

}  // namespace
}  // namespace perinox::output
