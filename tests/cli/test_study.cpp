/// Tests perinox study from its file to its table: costs and errors, taking up where it was stopped, and what it
/// refuses.
#include <gmock/gmock.h>
#include <sys/file.h>

#include <cmath>
#include <map>

#include "decks.hpp"
#include "program.hpp"
#include "support/breaking_decks.hpp"

namespace perinox::cli {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

/// A strip pulled at its right end. The study has four runs of a fraction of a second.
const std::string strip = R"(dimension: plane-strain
body: [{name: plate, shape: {box: {min: [0, 0], max: [12, 6]}}, spacing: 1, material: steel}]
horizon: {ratio: 2.015}
deformation: small
materials: {steel: {model: elastic, bulk_modulus: 160e3, shear_modulus: 80e3}}
sets: {left: {where: "x < 2"}, right: {where: "x > 10"}}
boundary:
  - {set: left, displacement: {x: "1e-3*x*t", y: 0}}
  - {set: right, displacement: {x: "1e-3*x*t", y: 0}}
steps: {end: 1, count: 2}
solver: {newton: {max_iterations: 6}}
output: {fields: [displacement, dilatation]}
history: [{name: pull, reaction: right, component: x}]
)";

const std::string sweep_study = R"(title: strip
deck: strip.yaml
sweep:
  - {key: quadrature, values: [whole, position-aware]}
  - {key: body.0.spacing, values: [1, 0.5]}
measures:
  - {name: F, history: "pull/6", exact: "0.1 + 0*spacing"}
  - {name: u, field: displacement, solution: {x: "1e-3*x*t"}, where: "x > 2*spacing"}
  - {name: theta, field: dilatation, solution: {value: "1e-3*t"}}
  - {name: near, field: displacement, reference: finest}
  - {name: half, field: displacement, solution: {x: "2e-3*x*t"}, where: "x < 2"}
  - {name: early, field: displacement, at: 0.5, solution: {x: "0.5e-3*x"}, where: "x < 2"}
)";

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> cells(1);
  for (const char c : line)
    if (c == ',')
      cells.emplace_back();
    else
      cells.back() += c;
  return cells;
}

using Table = std::vector<std::map<std::string, std::string>>;

/// Reads a table. No cell of these studies holds a comma unless it is a reason, which is not asked for.
Table table_of(const std::filesystem::path& file) {
  Table table;
  std::vector<std::string> names;
  for (const std::string& line : lines_of(read(file))) {
    const std::vector<std::string> cells = split(line);
    if (names.empty()) {
      names = cells;
      continue;
    }
    table.emplace_back();
    for (std::size_t c = 0; c < names.size() && c < cells.size(); ++c) table.back()[names[c]] = cells[c];
  }
  return table;
}

/// The table without what each run measures anew: times, and memory that depends on where pages fall.
Table without_costs(Table table) {
  for (auto& row : table)
    for (const char* cost : {"cpu_seconds", "wall_seconds", "solve_seconds", "peak_megabytes"}) {
      EXPECT_GT(std::stod(row.at(cost)), 0);
      row.erase(cost);
    }
  return table;
}

TEST(Study, MeasuresEveryRun) {
  const Folder folder;
  folder.write("strip.yaml", strip);
  folder.write("study.yaml", sweep_study);
  const Outcome outcome = folder.perinox({"study", "study.yaml"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.error, "");
  EXPECT_THAT(outcome.out, StartsWith("strip\n  4 runs of strip.yaml, 0 of them finished earlier; in "
                                      "results/studies/study\n"));
  EXPECT_THAT(outcome.out, HasSubstr("On the Pareto front, cheapest first:\n"));
  EXPECT_THAT(outcome.out, HasSubstr("see results/studies/study/study.md\n"));
  const std::filesystem::path results = folder.path() / "results/studies/study";
  for (const char* name : {"study.csv", "study.md", "F_error_against_spacing.svg", "F_error_against_spacing.png",
                           "u_error_against_cpu_seconds.svg", "runs/quadrature-whole_spacing-1/results.h5",
                           "runs/quadrature-whole_spacing-1/run.log"})
    EXPECT_TRUE(std::filesystem::is_regular_file(results / name)) << name;
  const Table table = table_of(results / "study.csv");
  ASSERT_EQ(table.size(), 4);
  for (const auto& row : table) {
    EXPECT_EQ(row.at("status"), "0");
    EXPECT_EQ(row.at("ranks"), "1");
    EXPECT_EQ(row.at("steps"), "2");
    const double spacing = std::stod(row.at("spacing"));
    EXPECT_EQ(std::stod(row.at("particles")), 72 / (spacing * spacing));
    EXPECT_EQ(std::stod(row.at("unknowns")), 144 / (spacing * spacing));
    EXPECT_GT(std::stod(row.at("bonds")), 8 * std::stod(row.at("particles")));
    EXPECT_GE(std::stod(row.at("newton_iterations")), 2);
    EXPECT_NEAR(std::stod(row.at("F_error")), std::stod(row.at("F")) / 0.1 - 1, 1e-9);
    EXPECT_GT(std::stod(row.at("u_error")), 0);
    EXPECT_GE(std::stod(row.at("u_largest")), std::stod(row.at("u_error")));
    EXPECT_GT(std::stod(row.at("theta_error")), 0.01) << "the strip gets thinner";
    EXPECT_LT(std::stod(row.at("theta_error")), 1);
    // Where the displacement is prescribed it is half of that solution, and exact at half the load.
    EXPECT_NEAR(std::stod(row.at("half_error")), 0.5, 1e-12);
    EXPECT_NEAR(std::stod(row.at("half_largest")), 0.5, 1e-12);
    EXPECT_LE(std::stod(row.at("early_error")), 1e-12);  // 0
    EXPECT_EQ(row.at("near_error").empty(), spacing == 0.5) << "the finest run has no error against itself";
  }
  EXPECT_THAT(read(results / "study.md"), HasSubstr("| position-aware | 0.5 | 0 |"));

  // Here the finest run is named as a file.
  folder.write("file.yaml",
               "deck: strip.yaml\nset: {quadrature: whole}\nsweep: [{key: body.0.spacing, values: [1]}]\nmeasures: "
               "[{name: near, field: displacement, reference: "
               "results/studies/study/runs/quadrature-whole_spacing-0.5/results.h5}]\n");
  ASSERT_EQ(folder.perinox({"study", "file.yaml", "--quiet", "--output", "file"}).status, 0);
  const Table against_file = table_of(folder.path() / "file/study.csv");
  ASSERT_EQ(against_file.size(), 1);
  EXPECT_EQ(against_file[0].at("near_error"), table[0].at("near_error"));
}

TEST(Study, HasItsFolderToItself) {
  const Folder folder;
  folder.write("strip.yaml", strip);
  folder.write("study.yaml", sweep_study);
  std::filesystem::create_directories(folder.path() / "r/runs");
  const int other = open((folder.path() / "r/runs/run.lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  ASSERT_EQ(flock(other, LOCK_EX), 0);
  const Outcome outcome = folder.perinox({"study", "study.yaml", "--output", "r"});
  close(other);
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.error,
            "the output directory r/runs is in use by another process: wait for its end, or choose another directory "
            "with --output\n");
}

/// The bar breaks. Without a fallback the run stops when its crack runs, and the peak is what the study is for.
TEST(Study, MeasuresWhatAStoppedRunHasReached) {
  const Folder folder;
  folder.write("deck.yaml", test::snapping_bar);
  folder.write("study.yaml", R"yaml(deck: deck.yaml
set: {steps.end: 0.25, steps.count: 5}
sweep: [{key: fallback, values: [none, automatic]}]
measures:
  - {name: begin, history: t, take: first}
  - {name: reached, history: t, take: last}
  - {name: most, history: stretch, take: max}
  - {name: least, history: stretch, take: min}
  - {name: when, history: stretch, take: argmax}
  - {name: at_least, history: stretch, take: argmin, argument: "2*step"}
  - {name: broken_at, history: t, take: first, where: "broken_bonds > 0"}
  - {name: ratio, history: "stretch/t", take: max, where: "step > 0"}
  - {name: senseless, history: "stretch/t", take: max}
  - {name: infinite, history: "1/(step - step)"}
  - {name: finish, history: t}
)yaml");
  const Outcome outcome = folder.perinox({"study", "study.yaml", "--output", "r", "--quiet"});
  EXPECT_EQ(outcome.status, 1);
  const std::string csv = read(folder.path() / "r/study.csv");
  const Table table = table_of(folder.path() / "r/study.csv");
  ASSERT_EQ(table.size(), 2);
  EXPECT_EQ(table[0].at("status"), "1");
  EXPECT_EQ(table[1].at("status"), "0");
  const std::string text = read(folder.path() / "r/runs/fallback-none/history.csv");
  const std::vector<std::string> rows = lines_of(text);
  ASSERT_EQ(rows.size(), 4u);  // the start, t = 0.05 and 0.1
  // The reason of a stopped run may hold commas, so its cells are counted from the end.
  const auto cell = [&](std::size_t row, const std::string& name) {
    const std::vector<std::string> names = split(lines_of(csv)[0]), cells = split(lines_of(csv)[row + 1]);
    const auto column = std::find(names.begin(), names.end(), name) - names.begin();
    return cells[cells.size() - names.size() + static_cast<std::size_t>(column)];
  };
  EXPECT_EQ(cell(0, "begin"), "0");
  EXPECT_EQ(cell(0, "reached"), split(rows[3])[1]);
  EXPECT_EQ(cell(0, "most"), split(rows[3])[2]);
  EXPECT_EQ(cell(0, "least"), "0");
  EXPECT_EQ(cell(0, "when"), split(rows[3])[1]);
  EXPECT_EQ(cell(0, "at_least"), "0");
  EXPECT_EQ(cell(0, "broken_at"), "");
  EXPECT_EQ(cell(0, "finish"), "");
  EXPECT_GT(std::stod(cell(0, "ratio")), 0);
  EXPECT_NEAR(std::stod(cell(1, "broken_at")), 0.15, 1e-12);
  EXPECT_EQ(cell(1, "finish"), "0.25");
  for (const std::size_t row : {0, 1}) {
    EXPECT_EQ(cell(row, "senseless"), "") << "0/0 at the start";
    EXPECT_EQ(cell(row, "infinite"), "");
  }
  EXPECT_THAT(csv, HasSubstr("the measure senseless is "));
  EXPECT_THAT(csv, HasSubstr("in step 0, t = 0; leave rows out"));
}

TEST(Study, ComponentsOfTensorsAreTakenByTheirNames) {
  const Folder folder;
  folder.write("strip.yaml", R"yaml(dimension: plane-strain
body: [{name: plate, shape: {box: {min: [0, 0], max: [6, 6]}}, spacing: 1, material: steel}]
horizon: {ratio: 2.015}
deformation: small
materials: {steel: {model: elastic, bulk_modulus: 160e3, shear_modulus: 80e3}}
boundary: [{set: all, displacement: {x: "(1e-3*x + 1e-3*y)*t", y: "(2e-3*x + 4e-3*y)*t"}}]
steps: {end: 1, count: 1}
output: {fields: [strain]}
)yaml");
  folder.write("study.yaml", R"yaml(deck: strip.yaml
sweep: [{key: body.0.spacing, values: [1]}]
measures:
  - {name: whole, field: strain, solution: {xx: 1e-3, xy: 1.5e-3, xz: 0, yy: 4e-3, yz: 0, zz: 0}}
  - {name: xx, field: strain, solution: {xx: 2e-3}}
  - {name: yy, field: strain, solution: {yy: 2e-3}}
  - {name: xy, field: strain, solution: {xy: 3e-3}}
)yaml");
  const Outcome outcome = folder.perinox({"study", "study.yaml", "--output", "r", "--quiet"});
  ASSERT_EQ(outcome.status, 0) << outcome.error;
  const auto row = table_of(folder.path() / "r/study.csv")[0];
  EXPECT_LT(std::stod(row.at("whole_error")), 1e-12);
  EXPECT_NEAR(std::stod(row.at("xx_error")), 0.5, 1e-12);
  EXPECT_NEAR(std::stod(row.at("yy_error")), 1, 1e-12);
  EXPECT_NEAR(std::stod(row.at("xy_error")), 0.5, 1e-12);
}

TEST(Study, AMeasureThatIsNotFiniteIsAFailure) {
  const Folder folder;
  folder.write("strip.yaml", strip);
  folder.write("study.yaml",
               "deck: strip.yaml\nsweep: [{key: body.0.spacing, values: [1]}]\nmeasures: [{name: F, history: "
               "\"pull/(step - 2)\"}]\n");
  const Outcome outcome = folder.perinox({"study", "study.yaml", "--output", "r", "--quiet"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.error, HasSubstr("warning: 1 of 1 runs stopped short or could not be measured"));
  EXPECT_THAT(read(folder.path() / "r/study.csv"), HasSubstr("F of the run in r/runs/spacing-1 is inf"));
  EXPECT_EQ(table_of(folder.path() / "r/study.csv")[0].at("F"), "");
}

TEST(Study, TakesUpWhereItWasKilled) {
  const Folder folder;
  folder.write("strip.yaml", strip);
  folder.write("study.yaml", changed(sweep_study, "[whole, position-aware]", "[whole]"));
  ASSERT_EQ(folder.perinox({"study", "study.yaml", "--quiet", "--output", "whole"}).status, 0);
  // The study is killed outright as soon as the first run is finished.
  const std::string runs = "killed/runs/";
  const Outcome killed =
      folder.run("/bin/sh", {"-c", std::string(PERINOX_BINARY) +
                                       " study study.yaml --quiet --output killed & pid=$!; while [ ! -e " + runs +
                                       "quadrature-whole_spacing-1/record.yaml ]; do sleep 0.02; done; kill -9 $pid; "
                                       "wait $pid 2>/dev/null; exit 0"});
  ASSERT_EQ(killed.status, 0);
  ASSERT_FALSE(std::filesystem::exists(folder.path() / "killed/study.csv"));
  const std::string first = read(folder.path() / (runs + "quadrature-whole_spacing-1/record.yaml"));
  const Outcome second = folder.perinox({"study", "study.yaml", "--output", "killed"});
  EXPECT_EQ(second.status, 0);
  EXPECT_THAT(second.out, HasSubstr("2 runs of strip.yaml, 1 of them finished earlier; in killed\n"));
  EXPECT_THAT(second.out, HasSubstr("1/2  quadrature-whole_spacing-1  finished earlier\n"));
  EXPECT_EQ(read(folder.path() / (runs + "quadrature-whole_spacing-1/record.yaml")), first);
  EXPECT_EQ(without_costs(table_of(folder.path() / "killed/study.csv")),
            without_costs(table_of(folder.path() / "whole/study.csv")));

  // When it is run once more, nothing is run and the table is the same to the last digit.
  const std::string table = read(folder.path() / "killed/study.csv");
  const Outcome third = folder.perinox({"study", "study.yaml", "--output", "killed"});
  EXPECT_THAT(third.out, HasSubstr("2 of them finished earlier"));
  EXPECT_EQ(read(folder.path() / "killed/study.csv"), table);

  // Another deck makes every run a different one, and so does --again.
  folder.write("strip.yaml", changed(strip, "count: 2", "count: 1"));
  EXPECT_THAT(folder.perinox({"study", "study.yaml", "--output", "killed", "--plan"}).out,
              HasSubstr("0 of them finished earlier"));
  folder.write("strip.yaml", strip);
  EXPECT_THAT(folder.perinox({"study", "study.yaml", "--output", "killed", "--plan", "--again"}).out,
              HasSubstr("0 of them finished earlier"));
  EXPECT_THAT(folder.perinox({"study", "study.yaml", "--output", "killed", "--plan"}).out,
              HasSubstr("2 of them finished earlier"));
}

TEST(Study, ARunThatStopsShortIsARow) {
  const Folder folder;
  folder.write("strip.yaml", strip);
  folder.write("study.yaml",
               "title: strip\ndeck: strip.yaml\nset: {steps.adaptive: false, solver.newton.tolerance: 1e-11}\n"
               "sweep: [{key: solver.newton.max_iterations, values: [1, 6]}]\n"
               "measures: [{name: F, history: pull}]\n");
  const Outcome outcome = folder.perinox({"study", "study.yaml", "--output", "r"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.error, "warning: 1 of 2 runs stopped short or could not be measured; r/study.csv says why\n");
  const Table table = table_of(folder.path() / "r/study.csv");
  ASSERT_EQ(table.size(), 2);
  EXPECT_EQ(table[0].at("status"), "1");
  EXPECT_THAT(table[0].at("reason"), StartsWith("\"stopped at t = 0 of 1"));
  EXPECT_EQ(table[1].at("status"), "0");
  EXPECT_GT(std::abs(std::stod(table[1].at("F"))), 0);
  EXPECT_THAT(read(folder.path() / "r/study.md"), HasSubstr("- max-iterations-1: stopped at t = 0 of 1"));
  EXPECT_THAT(folder.perinox({"study", "study.yaml", "--output", "r"}).out, HasSubstr("2 of them finished earlier"));
}

TEST(Study, RunsOnSeveralRanksTwice) {
  const Folder folder;
  folder.write("strip.yaml", strip);
  folder.write(
      "study.yaml",
      "deck: strip.yaml\nrepeat: 2\nsweep: [{key: ranks, values: [1, 2]}]\nmeasures: [{name: F, history: pull}]\n");
  ASSERT_EQ(folder.perinox({"study", "study.yaml", "--output", "r"}).status, 0);
  const Table table = table_of(folder.path() / "r/study.csv");
  ASSERT_EQ(table.size(), 2);
  EXPECT_EQ(table[1].at("ranks"), "2");
  EXPECT_NEAR(std::stod(table[1].at("F")) / std::stod(table[0].at("F")), 1, 1e-9);
  EXPECT_THAT(read(folder.path() / "r/runs/ranks-2/run.log"), HasSubstr("  2 ranks: particles "));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "r/runs/ranks-2.repeat"));
}

TEST(Study, OfNewtonTellsTheOrder) {
  const Folder folder;
  folder.write("deck.yaml", base_deck);
  folder.write("study.yaml",
               "kind: newton\ndeck: deck.yaml\n"
               "set: {solver.newton.forcing: constant, solver.linear.tolerance: 1e-12, solver.newton.line_search: "
               "full-step, solver.newton.tolerance: 1e-12, solver.newton.update_tolerance: 1}\n"
               "sweep: [{key: solver.form, values: [consistent]}]\n");
  const Outcome outcome = folder.perinox({"study", "study.yaml", "--output", "r"});
  ASSERT_EQ(outcome.status, 0) << outcome.error;
  EXPECT_THAT(outcome.out, HasSubstr("relative residual against Newton iteration\n"));
  EXPECT_GE(std::stod(table_of(folder.path() / "r/study.csv").at(0).at("newton_order")), 1.7);
  EXPECT_TRUE(std::filesystem::is_regular_file(folder.path() / "r/newton.svg"));
}

TEST(Study, IsRefusedBeforeAnythingRuns) {
  const Folder folder;
  folder.write("strip.yaml", strip);
  const std::pair<std::string, std::string> mistakes[] = {
      {changed(sweep_study, "values: [whole,", "values: [hole,"),
       "--set quadrature=hole: quadrature cannot be 'hole'; did you mean whole? (in the run "
       "quadrature-hole_spacing-1 "
       "of "
       "study.yaml)\n"},
      {changed(sweep_study, "body.0.spacing", "body.0.spacng"),
       "--set body.0.spacng=1: spacng is not a key of a body; did you mean spacing? (in the run "
       "quadrature-whole_spacng-1 "
       "of study.yaml)\n"},
      {changed(sweep_study, "pull/6", "pul/6"),
       "study.yaml:7:5: pul in the formula 'pul/6' is not known; did you mean pull?\n"},
      {changed(sweep_study, "field: displacement, sol", "field: damage, sol"),
       "study.yaml:8:5: the runs do not write the field damage; the deck's output.fields says which they write\n"},
      {changed(sweep_study, "{x: \"1e-3*x*t\"}", "{xx: 1}"),
       "study.yaml:8:5: xx is no component of the field displacement; it has x, y and z\n"},
      {changed(sweep_study, "1e-3*x*t", "1e-3*x*"),
       "study.yaml:8:5: the formula '1e-3*x*' cannot be read at character 8: it ends too early\n"},
  };
  for (const auto& [study, sentence] : mistakes) {
    folder.write("study.yaml", study);
    const Outcome outcome = folder.perinox({"study", "study.yaml"});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.error, sentence);
    EXPECT_EQ(outcome.out, "");
    EXPECT_THAT(folder.names(), ElementsAre("strip.yaml", "study.yaml"));
  }
  EXPECT_EQ(folder.perinox({"study", "none.yaml"}).error,
            "none.yaml: there is no study of this name; check the path\n");
}

// Only a run finds out that a piece can move.
TEST(Study, StopsAtADeckThatItsRunRefuses) {
  const Folder folder;
  folder.write("strip.yaml", changed(changed(strip, "{x: \"1e-3*x*t\", y: 0}", "{x: 0}"), "{x: \"1e-3*x*t\", y: 0}",
                                     "{x: \"1e-3*x*t\"}"));
  folder.write("study.yaml", sweep_study);
  const Outcome outcome = folder.perinox({"study", "study.yaml", "--quiet"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.error, StartsWith("strip.yaml:8:3: the prescribed displacements do not hold the body plate"));
  EXPECT_THAT(outcome.error, HasSubstr(" (in the run quadrature-whole_spacing-1 of study.yaml)\n"));
}

TEST(Study, SaysThatItRunsOnOneRank) {
  const Folder folder;
  folder.write("strip.yaml", strip);
  folder.write("study.yaml", sweep_study);
  const Outcome outcome = folder.perinox_on_ranks(2, {"study", "study.yaml"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.error,
              HasSubstr("perinox study was started on 2 ranks, but it runs on one and starts its runs by "
                        "itself; leave mpirun out, and sweep the key ranks to run decks on several\n"));
}

TEST(Study, TheExamplesAreValid) {
  const Folder folder;
  std::size_t studies = 0;
  for (const auto& entry : std::filesystem::directory_iterator(PERINOX_SOURCE_DIR "/studies")) {
    ++studies;
    const Outcome outcome = folder.perinox({"study", entry.path().string(), "--plan"});
    EXPECT_EQ(outcome.status, 0) << entry.path() << ": " << outcome.error;
    EXPECT_THAT(read(entry.path()), HasSubstr("#   perinox study studies/" + entry.path().filename().string() + "\n"));
  }
  EXPECT_GE(studies, 3);
}

TEST(Study, ThePageHoldsTheTableOfKeys) {
  const Folder folder;
  const std::string table = folder.perinox({"help", "--study"}).out;
  EXPECT_THAT(table, StartsWith("| key | type |"));
  EXPECT_THAT(read(PERINOX_SOURCE_DIR "/docs/studies.md"), HasSubstr(table)) << "write it anew: perinox help --study";
}

}  // namespace
}  // namespace perinox::cli
