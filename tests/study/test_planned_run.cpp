/// Tests the runs of a study, and formulas and settings that name its sweeps.
#include "study/fixture.hpp"
#include "study/planned_run.hpp"

namespace perinox::study {
namespace {

using ::testing::ElementsAre;

Sweep sweep_of(const std::string& name, const std::string& key, const std::vector<std::string>& values) {
  Sweep sweep{{"study.yaml", 7, 3}, name, {}};
  for (const std::string& value : values) {
    char* end = nullptr;
    const double number = std::strtod(value.c_str(), &end);
    sweep.points.push_back(
        {value, *end == '\0' ? std::optional<double>(number) : std::nullopt, {{{"study.yaml", 7, 3}, key, value}}});
  }
  return sweep;
}

TEST(PlannedRuns, AreEveryCombinationTheLastSweepFastest) {
  Study study;
  study.set = {{{}, "steps.count", "2"}, {{}, "sets.foot.where", "z < 3*{spacing}"}};
  study.sweep = {sweep_of("quadrature", "quadrature", {"whole", "position-aware"}),
                 sweep_of("spacing", "body.0.spacing", {"1", "0.5"}), sweep_of("ranks", "ranks", {"2"})};
  const std::vector<PlannedRun> runs = planned_runs(study);
  ASSERT_EQ(runs.size(), 4);
  EXPECT_EQ(runs[0].name, "quadrature-whole_spacing-1_ranks-2");
  EXPECT_EQ(runs[1].name, "quadrature-whole_spacing-0.5_ranks-2");
  EXPECT_EQ(runs[2].name, "quadrature-position-aware_spacing-1_ranks-2");
  EXPECT_THAT(runs[3].overrides, ElementsAre("steps.count=2", "sets.foot.where=z < 3*0.5", "quadrature=position-aware",
                                             "body.0.spacing=0.5"));
  EXPECT_EQ(runs[3].ranks, 2);
  EXPECT_THAT(runs[3].label, ElementsAre("position-aware", "0.5", "2"));
  EXPECT_THAT(runs[3].point, ElementsAre(1, 1, 0));
  EXPECT_EQ(runs[3].numbers.at("spacing"), 0.5);
  EXPECT_EQ(runs[3].numbers.count("quadrature"), 0);
  EXPECT_EQ(first_numeric(study), 1);
}

TEST(PlannedRuns, HaveFoldersOfTheirOwn) {
  Study study;
  study.sweep = {sweep_of("a", "a", {"x y", "x/y", std::string(300, 'b'), std::string(300, 'b') + "c"})};
  const std::vector<PlannedRun> runs = planned_runs(study);
  EXPECT_EQ(runs[0].name, "a-x-y");
  EXPECT_EQ(runs[1].name, "a-x-y_1");
  EXPECT_EQ(runs[2].name.size(), 120);
  EXPECT_NE(runs[2].name, runs[3].name);
}

TEST(PlannedRuns, AreRefusedWithTheSweepsPlace) {
  Study study;
  study.sweep = {sweep_of("ranks", "ranks", {"0"})};
  const auto message = [&] { return fixture::refusal([&] { planned_runs(study); }); };
  EXPECT_EQ(message(), "study.yaml:7:3: ranks must be a whole number from 1 to 4096, but '0' was found");
  study.sweep = {sweep_of("a", "steps.count", {"1"}), sweep_of("b", "steps.count", {"2"})};
  EXPECT_EQ(message(), "study.yaml:7:3: two sweeps set steps.count; remove one");
  study.sweep = {sweep_of("spacing", "body.0.spacing", {"1"})};
  study.set = {{{"study.yaml", 3, 5}, "sets.foot.where", "z < {spacin}"}};
  EXPECT_EQ(message(), "study.yaml:3:5: {spacin} names no sweep; did you mean spacing?");
  study.set.clear();
  study.sweep = {sweep_of("a", "a", std::vector<std::string>(101, "1")),
                 sweep_of("b", "b", std::vector<std::string>(100, "1"))};
  EXPECT_EQ(message(), "study.yaml:7:3: the sweeps make more than 10000 runs; leave some values out");
}

TEST(Formula, TakesNamesForNumbers) {
  const deck::Location where{"study.yaml", 9, 4};
  const Numbers numbers{{"h", 0.25}, {"e", -2}, {"pull", 1e-9}};
  EXPECT_EQ(formula("8/h + 1e1*e^2", numbers, {}, where)(0, 0, 0, 0), 72);
  EXPECT_EQ(formula("pull", numbers, {}, where)(0, 0, 0, 0), 1e-9);
  EXPECT_EQ(formula("x > 2*h && h2_ == 0 ? 1 : 0", {{"h", 0.25}, {"h2_", 0}}, {"x"}, where)(1, 0, 0, 0), 1);
  EXPECT_NEAR(formula("sin(pi*x)*t", numbers, {"x", "t"}, where)(0.5, 0, 0, 3), 3, 1e-15);
  EXPECT_EQ(fixture::refusal([&] { formula("pul/2", numbers, {"t"}, where); }),
            "study.yaml:9:4: pul in the formula 'pul/2' is not known; did you mean pull?");
  EXPECT_EQ(fixture::refusal([&] { formula("x", numbers, {"t"}, where); }),
            "study.yaml:9:4: x in the formula 'x' is not known; it may use t, pi, e, h and pull");
}

TEST(Formula, SettingsKeepTheirMaps) {
  EXPECT_EQ(with_words("{length: 1.5}", {{"a", "1"}}, {}), "{length: 1.5}");
  EXPECT_EQ(with_words("{a}/{a} {", {{"a", "12"}}, {}), "12/12 {");
}

}  // namespace
}  // namespace perinox::study
