/// Every number of ranks must write the same results file, even if one of them owns nothing.
#include <gtest/gtest.h>

#include "output/agree.hpp"
#include "output/parallel_file.hpp"
#include "output/results_file.hpp"
#include "output/run_directory.hpp"
#include "perinox/core/error.hpp"
#include "support/shuffled_body.hpp"

namespace perinox::output {
namespace {

void write_two_steps(const std::string& directory, const Communicator& ranks, GlobalId total, int dimension) {
  const body::Body body = test::shuffled_body(ranks, total, dimension);
  ResultsFile results(directory, "title", {"one", "the second block"}, body);
  for (int step = 1; step <= 2; ++step) {
    const auto displacement = test::field_values(body, step, dimension);
    const auto dilatation = test::field_values(body, 10 + step, 1);
    results.write(test::step_record(step, 0.5 * step),
                  {{"displacement", dimension, displacement.data()}, {"dilatation", 1, dilatation.data()}});
  }
}

TEST(OutputOnRanks, FileHoldsTheSameNumbersAsFromOneRank) {
  const Communicator all;
  const Communicator one(MPI_COMM_SELF);
  for (const int dimension : {2, 3})
    for (const GlobalId total : {GlobalId{2}, GlobalId{101}, GlobalId{4001}}) {  // 2: some ranks hold no rows either
      const test::TemporaryDirectory together, alone;
      write_two_steps(together.path(), all, total, dimension);
      if (!all.is_root()) continue;
      write_two_steps(alone.path(), one, total, dimension);
      const ParallelFile a(together / "results.h5", one, ParallelFile::Mode::read);
      const ParallelFile b(alone / "results.h5", one, ParallelFile::Mode::read);
      const auto n = static_cast<int>(total);
      for (const char* name :
           {"/particles/id", "/particles/volume", "/particles/block", "/steps/1/dilatation", "/steps/2/dilatation"})
        EXPECT_EQ(a.read_rows(name, total, 0, n), b.read_rows(name, total, 0, n)) << name;
      for (const char* name : {"/particles/reference", "/steps/1/displacement", "/steps/2/displacement"})
        EXPECT_EQ(a.read_rows(name, total, 0, n, 3), b.read_rows(name, total, 0, n, 3)) << name;
      EXPECT_EQ(a.texts_attribute("/particles/block", "names"), (std::vector<std::string>{"one", "the second block"}));
      EXPECT_EQ(test::file_text(together / "results.xdmf"), test::file_text(alone / "results.xdmf"));
    }
}

TEST(OutputOnRanks, RowsComeBackToTheirOwners) {
  const body::Body body = test::shuffled_body(Communicator(), 101, 3);
  const RowOrder order(body.communicator, body.id, body.owned, body.total);
  const auto values = test::field_values(body, 1, 3);
  const auto rows = order.to_rows(values.data(), 3);
  for (int r = 0; r < order.rows(); ++r)
    EXPECT_EQ(rows[static_cast<std::size_t>(r) * 3 + 1], test::value_of(order.first_row() + r, 1, 1));
  EXPECT_EQ(order.to_owners(rows.data(), 3), values);
}

TEST(OutputOnRanks, AFailureIsOneSentenceOnEveryRank) {
  const Communicator all;
  EXPECT_THROW(ParallelFile("/nonexistent/results.h5", all, ParallelFile::Mode::create), RunError);
  EXPECT_THROW(prepare_directory("/dev/null/results", all), InputError);
  try {
    agree_on_run_error(all, all.rank() == all.size() - 1 ? "the last rank fails" : "");
    ADD_FAILURE();
  } catch (const RunError& error) {
    EXPECT_STREQ(error.what(), "the last rank fails");
  }
  EXPECT_THROW(RowOrder(all, {0}, 1, all.size() + 1), std::logic_error);
}

}  // namespace
}  // namespace perinox::output
