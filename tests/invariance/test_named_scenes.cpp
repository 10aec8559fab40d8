/// Scenes in which an answer once depended on something unrelated, each with the description that showed it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support/measured.hpp"
#include "variants.hpp"
#include "workshop.hpp"

namespace perinox::invariance {
namespace {

/// Newton goes on until nothing but rounding is left.
const std::string exact = R"(
solver:
  newton: {tolerance: 1e-13, update_tolerance: 1e-12, max_iterations: 60, forcing: constant}
  linear: {tolerance: 1e-9}
)";

struct Named {
  std::string name, yaml;
  std::vector<Variant> variants;
  bool frames = false;  ///< also moved, mirrored and so on
};

Variant variant(const std::string& kind, const std::string& yaml, Rows rows = Rows::all, bool more = false) {
  Variant made{kind, yaml};
  made.rows = rows;
  made.more = more;
  return made;
}

// Body b is far from a and of the same spacing, but not on one lattice with it. Body a once lost its cubic factor to
// it.
Named lattices_apart() {
  const auto deck = [](bool both) {
    return fmt::format(
               R"(
dimension: 3
deformation: small
bond_bodies: false
body:
  - {{name: a, shape: {{box: {{min: [0, 0, 0], max: [6, 6, 14]}}}}, spacing: 1, material: m}}
{}horizon: {{length: 3.015}}
materials: {{m: {{model: elastic, young_modulus: 1000, poisson_ratio: 0.3}}}}
sets: {{lo: {{where: "z<3 && x<50"}}, hi: {{where: "z>11 && x<50"}}{}}}
boundary:
  - {{set: lo, displacement: {{x: 0, y: 0, z: 0}}}}
  - {{set: hi, displacement: {{x: "0.01*t", y: 0, z: "0.02*t"}}}}
{}steps: {{end: 1, count: 1}}
history: [{{name: Fz, reaction: hi, component: z}}, {{name: Fx, reaction: hi, component: x}}]
)",
               both
                   ? "  - {name: b, shape: {box: {min: [100.3, 0, 0], max: [106.3, 6, 14]}}, spacing: 1, material: m}\n"
                   : "",
               both ? ", far: {where: \"x>50\"}" : "",
               both ? "  - {set: far, displacement: {x: 0, y: 0, z: 0}}\n" : "") +
           exact;
  };
  return {
      "two lattices far apart", deck(false), {variant("another body beside it", deck(true), Rows::all, true)}, true};
}

/// Two bodies with two spacings between them. They are bonded as bodies that touch are, or not at all.
Named bodies_with_a_gap() {
  const auto deck = [](const char* bonded) {
    return fmt::format(R"(
dimension: plane-stress
bond_bodies: {}
body:
  - {{name: a, shape: {{box: {{min: [0, 0], max: [10, 8]}}}}, spacing: 1, material: m}}
  - {{name: b, shape: {{box: {{min: [12, 0], max: [22, 8]}}}}, spacing: 1, material: m}}
horizon: {{ratio: 3.015}}
materials: {{m: {{model: elastic, young_modulus: 1000, poisson_ratio: 0.3}}}}
sets: {{left: {{where: "x < 2"}}, right: {{where: "x > 20"}}}}
boundary:
  - {{set: left, displacement: {{x: 0, y: 0}}}}
  - {{set: right, displacement: {{x: "0.1*t", y: "0.03*t"}}}}
steps: {{end: 1, count: 1}}
history: [{{name: pull, reaction: right, component: x}}]
)",
                       bonded) +
           exact;
  };
  return {
      "bodies with a gap of two spacings", deck("false"), {variant("bonded across a gap or not", deck("true"))}, true};
}

/// A crack from corner to corner of a square, through the centres of particles, far from the origin. If it is refused,
/// it must be refused in all descriptions.
Named crack_through_centres(double x, double y) {
  const std::string deck =
      fmt::format(R"(
dimension: plane-stress
body: [{{name: plate, shape: {{box: {{min: [{0}, {1}], max: [{2}, {3}]}}}}, spacing: 0.1, material: m}}]
horizon: {{ratio: 3.015}}
cracks: [{{segment: {{start: [{4}, {5}], end: [{6}, {7}]}}}}]
materials: {{m: {{model: elastic, young_modulus: 1000, poisson_ratio: 0.3}}}}
sets: {{low: {{where: "y < {8}"}}, high: {{where: "y > {9}"}}}}
boundary:
  - {{set: low, displacement: {{x: 0, y: 0}}}}
  - {{set: high, displacement: {{x: 0, y: "0.01*t"}}}}
steps: {{end: 1, count: 1}}
)",
                  digits(x), digits(y), digits(x + 1.2), digits(y + 1.2), digits(x + 0.35), digits(y + 0.35),
                  digits(x + 0.85), digits(y + 0.85), digits(y + 0.3), digits(y + 0.9)) +
      exact;
  return {fmt::format("crack through centres at {:g}", x), deck, {}, true};
}

/// One crack, with its ends exchanged, and made of two that meet. Through centres it may be refused, but then in every
/// form.
Named crack_on_a_row(const std::string& name, double y) {
  const auto deck = [&](const std::string& cracks) {
    return fmt::format(R"(
dimension: plane-stress
body: [{{name: plate, shape: {{box: {{min: [0, 0], max: [12, 12]}}}}, spacing: 1, material: m}}]
horizon: {{ratio: 3.015}}
cracks: [{}]
materials: {{m: {{model: elastic, young_modulus: 1000, poisson_ratio: 0.3}}}}
sets: {{low: {{where: "y < 3"}}, high: {{where: "y > 9"}}}}
boundary:
  - {{set: low, displacement: {{x: 0, y: 0}}}}
  - {{set: high, displacement: {{x: 0, y: "0.1*t"}}}}
steps: {{end: 1, count: 1}}
history: [{{name: pull, reaction: high, component: y}}]
)",
                       cracks) +
           exact;
  };
  const auto segment = [&](double from, double to) {
    return fmt::format("{{segment: {{start: [{}, {}], end: [{}, {}]}}}}", from, y, to, y);
  };
  return {name,
          deck(segment(-1, 6.27)),
          {variant("ends of a crack exchanged", deck(segment(6.27, -1))),
           variant("a crack in two parts", deck(segment(-1, 3.14) + ", " + segment(6.27, 3.14))),
           variant("a crack in two parts", deck(segment(-1, 3.0) + ", " + segment(3.0, 6.27)))},
          true};
}

/// Bounds of sets lie on the centres of particles, which 0.35 and 0.65 are not to the last bit.
Named bounds_on_particles(const char* low, const char* high) {
  const std::string deck = fmt::format(R"(
dimension: plane-stress
body: [{{name: plate, shape: {{box: {{min: [0, 0], max: [1, 1]}}}}, spacing: 0.1, material: m}}]
horizon: {{ratio: 3.015}}
materials: {{m: {{model: elastic, young_modulus: 1000, poisson_ratio: 0.3}}}}
sets: {{low: {}, high: {}}}
boundary:
  - {{set: low, displacement: {{x: 0, y: 0}}}}
  - {{set: high, displacement: {{x: "0.01*t", y: "0.01*t"}}}}
steps: {{end: 1, count: 1}}
history: [{{name: pull, reaction: high, component: y}}]
)",
                                       low, high) +
                           exact;
  return {fmt::format("sets {} and {}", low, high), deck, {}, true};
}

/// An elastic body that is drawn and brought back to exactly where it was.
Named back_to_zero(const std::string& dimension, const std::string& load, const std::string& deformation) {
  const bool solid = dimension == "3";
  const std::string deck =
      fmt::format(R"(
dimension: {0}
deformation: {1}
body: [{{name: p, shape: {{box: {{min: {2}, max: {3}}}}}, spacing: 1, material: m}}]
horizon: {{ratio: 3.015}}
materials: {{m: {{model: elastic, young_modulus: 1000, poisson_ratio: 0.3}}}}
sets: {{lo: {{where: "x<3"}}, hi: {{where: "x>9"}}}}
boundary:
  - {{set: lo, displacement: {4}}}
  - {5}
steps: {{end: 1, count: 1}}
)",
                  dimension, deformation, solid ? "[0, 0, 0]" : "[0, 0]", solid ? "[12, 6, 6]" : "[12, 6]",
                  solid ? "{x: 0, y: 0, z: 0}" : "{x: 0, y: 0}", load);
  return {fmt::format("{} {} under {}", dimension, deformation, load), deck, {through_zero({deck, "."})}, false};
}

std::vector<Named> named_scenes() {
  std::vector<Named> all{
      lattices_apart(),
      bodies_with_a_gap(),
      crack_through_centres(0.5, 0.5),
      crack_through_centres(500000.5, 4600000.5),
      crack_on_a_row("crack between rows", 6.13),
      crack_on_a_row("crack on a row", 6.5),
      bounds_on_particles("{where: \"y <= 0.35\"}", "{where: \"y >= 0.65\"}"),
      bounds_on_particles("{box: {min: [0, 0], max: [1, 0.35]}}", "{box: {min: [0, 0.65], max: [1, 1]}}")};
  for (const char* deformation : {"small", "finite"})
    for (const char* dimension : {"3", "plane-stress"}) {
      all.push_back(back_to_zero(dimension, "{set: hi, displacement: {x: \"0.1*t\"}}", deformation));
      all.push_back(back_to_zero(dimension, "{set: hi, force: {x: \"10*t\", y: \"t\"}}", deformation));
      all.push_back(back_to_zero(dimension, "{set: hi, pressure: \"t\"}", deformation));
    }
  return all;
}

TEST(NamedScenes, NothingElseMatters) {
  const std::vector<Named> scenes = named_scenes();
  Ledger ledger;
  for (std::size_t k = 0; k < scenes.size(); ++k) {
    if (static_cast<int>(k) % ranks_of_world() != rank_of_world()) continue;
    const Named& scene = scenes[k];
    const WorkFolder folder;
    const Answer base = answer_of(scene.yaml, folder.path(), MPI_COMM_SELF);
    std::vector<Variant> variants = scene.variants;
    Lot lot(static_cast<unsigned>(k));
    // The places of a scene that is refused are not known.
    const Extent extent = base.place.empty() ? Extent{{0, 0, 0}, {12, 12, 0}} : extent_of(base);
    const int dimension = scene.yaml.find("dimension: 3") == std::string::npos ? 2 : 3;
    if (scene.frames)
      for (const Variant& other : frames({scene.yaml, folder.path()}, extent, dimension, lot, folder.path() + "/other"))
        variants.push_back(other);
    for (const Variant& other : variants) compare(ledger, scene.name, base, other, folder.path());
  }
  ledger.judge("named scenes");
}

TEST(NamedScenes, OneToFourRanks) {
  const std::vector<Named> scenes = named_scenes();
  Ledger ledger;
  for (std::size_t k = 0; k < 4; ++k)
    for (const std::string& yaml :
         {scenes[k].yaml, scenes[k].variants.empty() ? "" : scenes[k].variants.front().yaml}) {
      if (yaml.empty()) continue;
      const Answer base = rank_of_world() == 0 ? answer_of(yaml, ".", MPI_COMM_SELF) : Answer();
      compare_ranks(ledger, scenes[k].name, base, yaml, ".", 0);
    }
  if (ranks_of_world() > 1) ledger.judge("named scenes on several ranks");
}

}  // namespace
}  // namespace perinox::invariance
