/// Tests charts as files, and which plots a table of runs gives.
#include <cmath>

#include "study/fixture.hpp"
#include "study/plotting.hpp"
#include "study/report.hpp"

namespace perinox::study {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::string text_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Adds errors of order `order` at three spacings, and costs that grow.
void add_rows(std::vector<Row>& rows, std::size_t point, const std::string& label, double order, double scale) {
  std::size_t k = 0;
  for (const double h : {1.0, 0.5, 0.25}) {
    Row row;
    row.run.name = label + std::to_string(k);
    row.run.point = {point, k++};
    row.run.label = {label, short_number(h)};
    row.run.numbers = {{"spacing", h}};
    row.values = {
        {"E_error", -scale * std::pow(h, order)}, {"E", 1}, {"cpu_seconds", 1 / h + static_cast<double>(point)}};
    rows.push_back(row);
  }
}

Study study_of() {
  Study study;
  study.title = "a title";
  study.sweep.resize(2);
  study.sweep[0].name = "quadrature";
  study.sweep[0].points = {{"whole", {}, {}}, {"position-aware", {}, {}}};
  study.sweep[1].name = "spacing";
  study.sweep[1].points = {{"1", 1.0, {}}, {"0.5", 0.5, {}}, {"0.25", 0.25, {}}};
  study.measures.resize(1);
  study.measures[0].name = "E";
  study.measures[0].history = "pull";
  study.measures[0].exact = "1";
  return study;
}

TEST(Plots, AreErrorAgainstTheFirstNumericSweepAndAgainstWork) {
  std::vector<Row> rows;
  add_rows(rows, 0, "whole", 1, 0.4);
  add_rows(rows, 1, "position-aware", 2, 0.1);
  const std::vector<Plot> plots = plots_of(study_of(), rows);
  ASSERT_EQ(plots.size(), 2);
  EXPECT_EQ(plots[0].file, "E_error_against_spacing");
  EXPECT_TRUE(plots[0].chart.x.logarithmic && plots[0].chart.y.logarithmic);
  EXPECT_THAT(plots[0].chart.x.marked, ElementsAre(0.25, 0.5, 1));
  EXPECT_THAT(plots[0].findings,
              ElementsAre("whole: slope 1.00 over 3 points", "position-aware: slope 2.00 over 3 points"));
  EXPECT_EQ(plots[0].chart.curves[1].name, "position-aware, slope 2.00");
  EXPECT_EQ(plots[1].file, "E_error_against_cpu_seconds");
  // The series `whole` has errors 0.4, 0.2, 0.1 at CPU seconds 1, 2, 4, and `position-aware` has 0.1, 0.025, 0.00625 at
  // 2, 3, 5.
  EXPECT_THAT(plots[1].findings,
              ElementsAre("On the Pareto front, cheapest first:", "whole, 1: 0.4 at 1 cpu_seconds",
                          "position-aware, 1: 0.1 at 2 cpu_seconds", "position-aware, 0.5: 0.025 at 3 cpu_seconds",
                          "position-aware, 0.25: 6.25e-03 at 5 cpu_seconds"));
}

TEST(Plots, FitNoSlopeToAnErrorThatChangesSign) {
  std::vector<Row> rows;
  add_rows(rows, 0, "whole", 1, 0.4);
  rows[0].values["E_error"] *= -1;
  EXPECT_THAT(plots_of(study_of(), rows)[0].findings,
              ElementsAre("whole: the error changes sign, so that no slope is fitted"));
}

TEST(Plots, LeaveOutWhatCouldNotBeMeasured) {
  std::vector<Row> rows;
  add_rows(rows, 0, "whole", 1, 0.4);
  rows[1].values.erase("E_error");
  rows[1].reason = "stopped at t = 0.5";
  rows[1].status = 1;
  const Study study = study_of();
  const std::vector<Plot> plots = plots_of(study, rows);
  EXPECT_THAT(plots[0].findings, ElementsAre("whole: slope 1.00 over 2 points"));
  EXPECT_THAT(page(study, rows, plots), HasSubstr("- whole1: stopped at t = 0.5"));
  for (Row& row : rows) row.values.clear();
  EXPECT_TRUE(plots_of(study, rows).empty());
}

TEST(Plots, OfNewtonShowTheResidualsAndTheirOrder) {
  Study study = study_of();
  study.kind = Kind::newton;
  study.measures.clear();
  std::vector<Row> rows;
  add_rows(rows, 0, "whole", 1, 1);
  rows.resize(1);
  rows[0].residuals = {1e-1, 1e-2, 1e-4, 1e-8};
  const std::vector<Plot> plots = plots_of(study, rows);
  ASSERT_EQ(plots.size(), 1);
  EXPECT_THAT(plots[0].findings, ElementsAre("whole, spacing 1: order 2.00 over 3 iterations"));
  EXPECT_EQ(plots[0].chart.curves[0].points[3].x, 3);
  EXPECT_EQ(plots[0].chart.curves[0].points[3].y, 1e-8);
}

TEST(RunTable, IsCsvWithEveryDigit) {
  std::vector<Row> rows;
  add_rows(rows, 0, "whole", 1, 0.1);
  rows.resize(1);
  rows[0].reason = "stopped, \"early\"";
  rows[0].status = 1;
  EXPECT_EQ(csv_text(study_of(), rows),
            "run,quadrature,spacing,status,reason,E_error,E,ranks,particles,unknowns,bonds,steps,newton_iterations,"
            "linear_iterations,cpu_seconds,wall_seconds,solve_seconds,peak_megabytes\n"
            "whole0,whole,1,1,\"stopped, \"\"early\"\"\",-0.10000000000000001,1,,,,,,,,1,,,\n");
}

TEST(Chart, IsWrittenAsSvgAndPng) {
  const fixture::Folder folder;
  Chart chart{"a title", {"x", true, {}}, {"y", true, {}}, {{"curve", {{1, 1}, {10, 0.1}, {0, 5}}}}};
  ASSERT_TRUE(chart.has_points());
  draw(chart, folder / "chart");
  const std::string svg = text_of(folder / "chart.svg"), png = text_of(folder / "chart.png");
  EXPECT_THAT(svg, HasSubstr("<svg"));
  EXPECT_THAT(svg, HasSubstr("</svg>"));
  EXPECT_EQ(png.substr(1, 3), "PNG");
  draw(chart, folder / "again");
  EXPECT_EQ(text_of(folder / "again.png"), png) << "the same picture each time";
  chart.curves[0].points[1].y = 0.01;
  draw(chart, folder / "other");
  EXPECT_NE(text_of(folder / "other.png"), png);
  EXPECT_THROW(draw(chart, folder / "no/such/folder"), RunError);
  chart.curves[0].points = {{0, 1}, {-1, 1}};
  EXPECT_FALSE(chart.has_points());
}

}  // namespace
}  // namespace perinox::study
