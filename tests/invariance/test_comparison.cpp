/// Tests the suite itself: it must detect deviations, and rewriting a deck twice must lead back.
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include "answer.hpp"
#include "rewriting.hpp"
#include "workshop.hpp"

namespace perinox::invariance {
namespace {

/// Three particles with a displacement, a force and a stress each, and a row of history.
Answer small_answer() {
  Answer answer;
  answer.dimension = 3;
  answer.spacing = 1;
  answer.place = {0, 0, 0, 1, 0, 0, 0, 1.5, 0};
  answer.volume = {1, 1, 0.5};
  answer.family = {2, 2, 2};
  answer.fields["displacement"] = {3, {0.1, 0.2, 0.3, -0.1, 0, 0.2, 0, 0, 0.05}};
  answer.fields["force"] = {3, {1, 2, 3, -4, 0, 2, 0, 1, 0.5}};
  answer.fields["stress"] = {6, {1, 2, 3, 4, 5, 6, 0, 0, 0, 0, 0, 0, -1, 0, 0, 0, 0, 2}};
  answer.rows.push_back({1, {10, 1, 11}, {5, -6}, {0.1}, {0.5}, 0});
  return answer;
}

double apart(const Answer& changed, bool more = false) {
  return deviation(small_answer(), changed, {}, Rows::all, more);
}

TEST(Comparison, SeesEveryQuantity) {
  EXPECT_EQ(apart(small_answer()), 0);
  Answer changed = small_answer();
  changed.fields["displacement"].values[4] = 3e-7;
  EXPECT_NEAR(apart(changed), 1e-6, 1e-12);
  changed = small_answer();
  std::swap(changed.fields["stress"].values[1], changed.fields["stress"].values[3]);
  EXPECT_NEAR(apart(changed), 2.0 / 6, 1e-12);
  changed = small_answer();
  changed.fields.erase("force");
  EXPECT_EQ(apart(changed), 1);
  changed = small_answer();
  changed.family[2] = 1;
  EXPECT_EQ(apart(changed), 1);
  changed = small_answer();
  changed.volume[1] = 1 + 1e-5;
  EXPECT_NEAR(apart(changed), 1e-5, 1e-12);
  changed = small_answer();
  changed.rows[0].reactions[1] = -6.6;
  EXPECT_NEAR(apart(changed), 0.6 / 13.5, 1e-12);  // of the sum of all forces
  changed = small_answer();
  changed.fields["force"].values[0] = std::nan("");
  EXPECT_FALSE(apart(changed) <= 1);
  changed = small_answer();
  changed.refused = "deck.yaml:1:1: no";
  EXPECT_EQ(apart(changed), 1);
}

TEST(Comparison, SeesParticlesThatAreMissingOrTooMany) {
  Answer changed = small_answer();
  changed.place[3] = 1.2;
  EXPECT_EQ(apart(changed), 1);
  changed = small_answer();
  changed.place.insert(changed.place.end(), {50, 0, 0});
  changed.volume.push_back(1);
  changed.family.push_back(0);
  for (auto& [name, field] : changed.fields) field.values.resize(field.values.size() / 3 * 4);
  EXPECT_EQ(apart(changed), 1);
  EXPECT_EQ(apart(changed, true), 0);
}

/// A stress turns as a tensor: sigma n for the turned normal is the turned traction.
TEST(Comparison, TurnsTensorsAsTheirTractions) {
  Transformation change;
  change.turn = rotation({1, -2, 0.5}, 0.7);
  const double s[6] = {1, 2, 3, 4, 5, 6};
  const auto made = change.tensor(s);
  const auto times = [](const double* t, const Vector3& n) {
    return Vector3{t[0] * n[0] + t[1] * n[1] + t[2] * n[2], t[1] * n[0] + t[3] * n[1] + t[4] * n[2],
                   t[2] * n[0] + t[4] * n[1] + t[5] * n[2]};
  };
  const Vector3 normal{0.3, 0.4, -0.8};
  const Vector3 wanted = change.direction(times(s, normal)), found = times(made.data(), change.direction(normal));
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(found[c], wanted[c], 1e-13);  // 2e-15
}

TEST(Rewriting, KnowsPlacesEdgesDirectionsAndUnits) {
  Transformation change;
  change.turn = {{{0, -1, 0}, {1, 0, 0}, {0, 0, 1}}};  // x goes to y, y to -x
  change.shift = {100, 0, 0};
  change.length = 10;
  change.stress = 1000;
  const std::string yaml = transformed({R"(
dimension: 3
body: [{name: a, shape: {box: {min: [0, 1, 2], max: [3, 5, 7]}}, spacing: 0.5, material: m}]
horizon: {ratio: 3.015}
cracks: [{rectangle: {corner: [1, 1, 1], edge1: [1, 0, 0], edge2: [0, 0, 2]}}]
materials: {m: {model: elastic, young_modulus: 70, poisson_ratio: 0.3, density: 2, damage: {energy_release_rate: 0.1}}}
sets: {foot: {where: "x < 0.5 && max(y, 2) > z"}}
boundary:
  - {set: foot, displacement: {x: "0.1*t", y: 0}}
  - {set: foot, traction: {x: "x*t"}, facing: [1, 0, 0]}
steps: {end: 1, count: 1}
history: [{name: pull, reaction: foot, component: x}]
)",
                                        "."},
                                       change, "unused");
  const YAML::Node root = YAML::Load(yaml);
  const auto number = [](const YAML::Node& node) { return node.as<double>(); };
  EXPECT_EQ(number(root["body"][0]["shape"]["box"]["min"][0]), 50);
  EXPECT_EQ(number(root["body"][0]["shape"]["box"]["max"][0]), 90);
  EXPECT_EQ(number(root["body"][0]["shape"]["box"]["max"][1]), 30);
  EXPECT_EQ(number(root["body"][0]["spacing"]), 5);
  EXPECT_EQ(number(root["horizon"]["ratio"]), 3.015);
  EXPECT_EQ(number(root["cracks"][0]["rectangle"]["corner"][0]), 90);
  EXPECT_EQ(number(root["cracks"][0]["rectangle"]["edge1"][1]), 10);
  EXPECT_EQ(number(root["materials"]["m"]["young_modulus"]), 70000);
  EXPECT_EQ(number(root["materials"]["m"]["density"]), 20);
  EXPECT_EQ(number(root["materials"]["m"]["damage"]["energy_release_rate"]), 1000);
  EXPECT_EQ(number(root["boundary"][1]["facing"][1]), 1);
  EXPECT_TRUE(root["boundary"][0]["displacement"]["y"]);
  EXPECT_TRUE(root["boundary"][0]["displacement"]["x"]);
  EXPECT_FALSE(root["boundary"][1]["traction"]["x"]);
  EXPECT_EQ(root["history"][0]["component"].as<std::string>(), "y");
  EXPECT_NE(root["sets"]["foot"]["where"].as<std::string>().find("max("), std::string::npos);
}

}  // namespace
}  // namespace perinox::invariance
