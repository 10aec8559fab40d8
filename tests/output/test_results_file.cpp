#include <fmt/format.h>
#include <gmock/gmock.h>
#include <sys/resource.h>

#include <csignal>
#include <filesystem>
#include <map>
#include <regex>

#include "output/parallel_file.hpp"
#include "output/results_file.hpp"
#include "perinox/core/error.hpp"
#include "support/shuffled_body.hpp"

namespace perinox::output {
namespace {
using test::field_values;
using test::value_of;
using ::testing::AllOf;
using ::testing::HasSubstr;
constexpr GlobalId total = 101;

class ResultsFileTest : public ::testing::TestWithParam<int> {
 protected:
  test::TemporaryDirectory directory_;
  Communicator one_rank_{MPI_COMM_SELF};
};

TEST_P(ResultsFileTest, RowsAreInIdOrderWithThreeColumns) {
  const int dimension = GetParam();
  const body::Body body = test::shuffled_body(one_rank_, total, dimension);
  ASSERT_NE(body.id.front(), 0);
  ResultsFile results(directory_.path(), "a title", {"block", "second"}, body);
  const auto displacement = field_values(body, 5, dimension);
  const auto damage = field_values(body, 6, 1);
  results.write(test::step_record(4, 0.25),
                {{"displacement", dimension, displacement.data()}, {"damage", 1, damage.data()}});

  const ParallelFile file(directory_ / "results.h5", one_rank_, ParallelFile::Mode::read);
  const auto id = file.read_rows("/particles/id", total, 0, total);
  const auto reference = file.read_rows("/particles/reference", total, 0, total, 3);
  const auto volume = file.read_rows("/particles/volume", total, 0, total);
  const auto block = file.read_rows("/particles/block", total, 0, total);
  const auto u = file.read_rows("/steps/4/displacement", total, 0, total, 3);
  const auto d = file.read_rows("/steps/4/damage", total, 0, total);
  for (GlobalId row = 0; row < total; ++row) {
    const auto i = static_cast<std::size_t>(row);
    EXPECT_EQ(id[i], static_cast<double>(row));
    EXPECT_EQ(volume[i], value_of(row, 2));
    EXPECT_EQ(block[i], test::block_of(row));
    EXPECT_EQ(d[i], value_of(row, 6));
    for (int c = 0; c < 3; ++c) {
      EXPECT_EQ(reference[i * 3 + static_cast<std::size_t>(c)], c < dimension ? value_of(row, 1, c) : 0.0);
      EXPECT_EQ(u[i * 3 + static_cast<std::size_t>(c)], c < dimension ? value_of(row, 5, c) : 0.0);
    }
  }
  EXPECT_EQ(file.text_attribute("/", "title"), "a title");
  EXPECT_EQ(file.text_attribute("/", "perinox_version"), PERINOX_VERSION);
  EXPECT_EQ(file.number_attribute("/", "dimension"), dimension);
  EXPECT_EQ(file.number_attribute("/steps/4", "t"), 0.25);
  EXPECT_EQ(file.number_attribute("/steps/4", "load"), 0.25);
  EXPECT_EQ(file.number_attribute("/steps/4", "newton_iterations"), 3);
  EXPECT_EQ(file.number_attribute("/steps/4", "linear_iterations"), 44);
  const std::vector<std::string> names = file.texts_attribute("/particles/block", "names");
  ASSERT_EQ(names.size(), 2U);
  EXPECT_EQ(names[0], "block");
  EXPECT_THROW(file.text_attribute("/particles/block", "names"), RunError);
}

INSTANTIATE_TEST_SUITE_P(Dimensions, ResultsFileTest, ::testing::Values(2, 3));

TEST_F(ResultsFileTest, IsReadableAfterEveryStepWhileTheRunGoesOn) {
  const body::Body body = test::shuffled_body(one_rank_, total, 3);
  ResultsFile results(directory_.path(), "", {"block"}, body);
  for (int step = 1; step <= 3; ++step) {
    const auto displacement = field_values(body, step, 3);
    results.write(test::step_record(step, 0.1 * step), {{"displacement", 3, displacement.data()}});
    const ParallelFile file(results.path(), one_rank_, ParallelFile::Mode::read);
    for (int earlier = 1; earlier <= step; ++earlier)
      EXPECT_EQ(file.read_rows("/steps/" + std::to_string(earlier) + "/displacement", total, 0, total, 3)[0],
                value_of(0, earlier));
    EXPECT_FALSE(file.has("/steps/" + std::to_string(step + 1)));
  }
}

/// Tensors have nine columns in the order in which every reader names them: xx xy xz, yx yy yz, zx zy zz.
TEST_P(ResultsFileTest, TensorsHaveNineColumns) {
  const int dimension = GetParam();
  const body::Body body = test::shuffled_body(one_rank_, total, dimension);
  ResultsFile results(directory_.path(), "", {"block"}, body);
  const auto stress = field_values(body, 5, 6);
  results.write(test::step_record(0, 0), {{"stress", 6, stress.data()}});
  const ParallelFile file(results.path(), one_rank_, ParallelFile::Mode::read);
  const auto written = file.read_rows("/steps/0/stress", total, 0, total, 9);
  const int place[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};  // in xx, xy, xz, yy, yz, zz
  for (GlobalId row = 0; row < total; ++row)
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        EXPECT_EQ(written[static_cast<std::size_t>(row * 9 + i * 3 + j)], value_of(row, 5, place[i][j]));
  const std::string xml = test::file_text(directory_ / "results.xdmf");
  EXPECT_THAT(xml,
              HasSubstr("<Attribute Name=\"stress\" AttributeType=\"Tensor\" Center=\"Node\">\n          <DataItem "
                        "Dimensions=\"101 9\" NumberType=\"Float\" Precision=\"8\" Format=\"HDF\">"
                        "results.h5:/steps/0/stress</DataItem>"));
  EXPECT_EQ(xml.find("Tensor6"), std::string::npos);
}

/// For readers a component is a field of its own, though its numbers are stored once.
TEST_P(ResultsFileTest, ComponentsOfTensorsHaveNames) {
  const int dimension = GetParam();
  const body::Body body = test::shuffled_body(one_rank_, total, dimension);
  const auto stress = field_values(body, 5, 6), strain = field_values(body, 7, 6);
  const std::vector<Field> fields{{"stress", 6, stress.data()}, {"strain", 6, strain.data()}};
  std::string h5;
  {
    ResultsFile results(directory_.path(), "", {"block"}, body);
    results.write(test::step_record(0, 0), fields);
    results.write(test::step_record(1, 0.5), fields);
    h5 = results.path();
  }
  const std::map<std::string, int> components =
      dimension == 3 ? std::map<std::string, int>{{"xx", 0}, {"xy", 1}, {"xz", 2}, {"yy", 3}, {"yz", 4}, {"zz", 5}}
                     : std::map<std::string, int>{{"xx", 0}, {"xy", 1}, {"yy", 3}, {"zz", 5}};
  const auto expect = [&](int steps) {
    const ParallelFile file(h5, one_rank_, ParallelFile::Mode::read);
    const std::string xml = test::file_text(directory_ / "results.xdmf");
    for (int step = 0; step < steps; ++step)
      for (const auto& [name, place] : components) {
        const std::string view = fmt::format("/components/{}/strain_{}", step, name);
        const auto values = file.read_rows(view, total, 0, total);
        for (GlobalId row = 0; row < total; ++row)
          EXPECT_EQ(values[static_cast<std::size_t>(row)], value_of(row, 7, place));
        EXPECT_THAT(xml, HasSubstr("<Attribute Name=\"strain_" + name + "\" AttributeType=\"Scalar\""));
        EXPECT_THAT(xml, HasSubstr("results.h5:" + view + "</DataItem>"));
      }
    EXPECT_EQ(file.has("/components/0/strain_xz"), dimension == 3);
    EXPECT_FALSE(file.has(fmt::format("/components/{}", steps)));
    EXPECT_EQ(xml.find(fmt::format("/components/{}/", steps)), std::string::npos);
  };
  expect(2);
  { const ResultsFile after_a_restart(directory_.path(), "", {"stress", "strain"}, body, ResultsFile::Continue{0, 0}); }
  expect(1);
}

TEST_F(ResultsFileTest, AFileWithTensorsOfSixColumnsIsNotGoneOnWith) {
  const body::Body body = test::shuffled_body(one_rank_, total, 3);
  { const ResultsFile results(directory_.path(), "", {"block"}, body); }
  {
    ParallelFile file(directory_ / "results.h5", one_rank_, ParallelFile::Mode::append);
    file.make_group("/steps/1");
    file.set_attribute("/steps/1", "t", 0.5);
    file.write_rows("/steps/1/stress", std::vector<double>(6 * total, 1.0), total, 0, 6);
    file.close();
  }
  try {
    const ResultsFile results(directory_.path(), "", {"stress"}, body, ResultsFile::Continue{1, 0});
    ADD_FAILURE() << "an index that names six columns wrongly was made";
  } catch (const RunError& error) {
    EXPECT_THAT(error.what(), HasSubstr("results.h5 has six columns of stress"));
  }
}

TEST_F(ResultsFileTest, TheIndexCountsStepsWhereTMayTurnBack) {
  const body::Body body = test::shuffled_body(one_rank_, total, 3);
  ResultsFile results(directory_.path(), "", {"block"}, body, true);
  const auto displacement = field_values(body, 5, 3);
  results.write(test::step_record(1, 0.75), {{"displacement", 3, displacement.data()}});
  results.write(test::step_record(2, -0.25), {{"displacement", 3, displacement.data()}});
  EXPECT_THAT(test::file_text(directory_ / "results.xdmf"),
              AllOf(HasSubstr("<Time Value=\"1\"/>"), HasSubstr("<Time Value=\"2\"/>")));
}

TEST_F(ResultsFileTest, IndexIsWellFormedAndNamesOnlyDatasetsThatExist) {
  const body::Body body = test::shuffled_body(one_rank_, total, 3);
  ResultsFile results(directory_.path(), "steel & \"rubber\" <1>", {"block"}, body);
  const auto displacement = field_values(body, 5, 3);
  for (int step = 1; step <= 2; ++step)
    results.write(test::step_record(step, 0.5 * step), {{"displacement", 3, displacement.data()}});

  const std::string xml = test::file_text(directory_ / "results.xdmf");
  // The index is well-formed if every tag that opens closes, in order.
  std::vector<std::string> open;
  const std::regex tag("<(/?)([A-Za-z?]+)((?:\\s+[A-Za-z]+=\"[^\"<>]*\")*)\\s*([/?]?)>");
  for (std::sregex_iterator match(xml.begin(), xml.end(), tag), end; match != end; ++match) {
    if ((*match)[1] == "/") {
      ASSERT_FALSE(open.empty());
      EXPECT_EQ(open.back(), (*match)[2]);
      open.pop_back();
    } else if ((*match)[4] == "") {
      open.push_back((*match)[2]);
    }
  }
  EXPECT_TRUE(open.empty());
  EXPECT_EQ(std::regex_replace(xml, tag, "").find_first_of("<>\""), std::string::npos);
  EXPECT_THAT(xml, AllOf(HasSubstr("steel &amp; &quot;rubber&quot; &lt;1&gt;"), HasSubstr("<Time Value=\"0.5\"/>"),
                         HasSubstr("<Time Value=\"1\"/>")));

  const ParallelFile file(results.path(), one_rank_, ParallelFile::Mode::read);
  const std::regex data("Dimensions=\"101( 3)?\"[^>]*>results.h5:([^<]+)<");
  int named = 0;
  for (std::sregex_iterator match(xml.begin(), xml.end(), data), end; match != end; ++match, ++named)
    EXPECT_NO_THROW(file.read_rows((*match)[2], total, 0, total, (*match)[1].length() > 0 ? 3 : 0)) << (*match)[2];
  EXPECT_EQ(named, 2 * 5);  // id, reference, displacement, block, volume of each step
  EXPECT_FALSE(std::filesystem::exists(directory_ / "results.xdmf.part"));
}

TEST_F(ResultsFileTest, FailuresAreSentencesWithPathAndReason) {
  const body::Body body = test::shuffled_body(one_rank_, total, 3);
  ::testing::internal::CaptureStderr();
  try {
    const ResultsFile results(directory_ / "nowhere", "", {"block"}, body);
    ADD_FAILURE() << "a file in a directory that does not exist was created";
  } catch (const RunError& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("nowhere/results.h5 cannot be opened: No such file or directory")));
  }
  ResultsFile results(directory_.path(), "", {"block"}, body);
  std::filesystem::resize_file(results.path(), 100);
  EXPECT_THROW(results.write(test::step_record(1, 1), {}), RunError);
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

TEST_F(ResultsFileTest, AFullDiskLeavesTheEarlierStepsWhole) {
  const body::Body body = test::shuffled_body(one_rank_, total, 3);
  ResultsFile results(directory_.path(), "", {"block"}, body);
  const auto displacement = field_values(body, 5, 3);
  results.write(test::step_record(1, 1), {{"displacement", 3, displacement.data()}});
  // A limit on the size of files stands in for the full disk.
  const auto ignored = std::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  rlimit tight = before;
  tight.rlim_cur = std::filesystem::file_size(results.path()) + 1000;
  setrlimit(RLIMIT_FSIZE, &tight);
  std::string reason;
  try {
    results.write(test::step_record(2, 2), {{"displacement", 3, displacement.data()}});
  } catch (const RunError& error) {
    reason = error.what();
  }
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, ignored);
  EXPECT_THAT(reason, AllOf(HasSubstr("results.h5 is left as it is"), HasSubstr("File too large")));
  const ParallelFile file(results.path(), one_rank_, ParallelFile::Mode::read);
  EXPECT_EQ(file.read_rows("/steps/1/displacement", total, 0, total, 3)[1], value_of(0, 5, 1));
  EXPECT_FALSE(file.has("/steps/2"));
}

TEST_F(ResultsFileTest, ReadingRefusesAnotherShape) {
  const body::Body body = test::shuffled_body(one_rank_, total, 3);
  const ResultsFile results(directory_.path(), "", {"block"}, body);
  const ParallelFile file(results.path(), one_rank_, ParallelFile::Mode::read);
  EXPECT_THROW(file.read_rows("/particles/volume", total, 0, total, 3), RunError);
  EXPECT_THROW(file.read_rows("/particles/volume", total + 1, 0, total), RunError);
  EXPECT_THROW(file.read_rows("/particles/colour", total, 0, total), RunError);
  EXPECT_THROW(file.number_attribute("/", "colour"), RunError);
}

}  // namespace
}  // namespace perinox::output
