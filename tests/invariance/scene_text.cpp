#include "scene_text.hpp"

#include <numeric>

namespace perinox::invariance {

namespace {

std::string joined(const std::vector<std::string>& parts) {
  std::string all;
  for (const std::string& part : parts) all += (all.empty() ? "" : ", ") + part;
  return all;
}

std::string listed(const std::string& key, const std::vector<std::string>& entries) {
  if (entries.empty()) return "";
  std::string all = key + ":\n";
  for (const std::string& entry : entries) all += "  - " + entry + "\n";
  return all;
}

}  // namespace

SceneText::SceneText(Lot& lot, bool solid) : lot_(lot), solid_(solid), modulus_(lot.between(500, 2000)) {
  h = lot.between(0.3, 3);
  for (int c = 0; c < d(); ++c) origin[static_cast<std::size_t>(c)] = lot.between(-20, 20);
  dimension_ = solid ? "3" : lot.one_of<std::string>({"plane-stress", "plane-strain"});
  quadrature_ = lot.one_of<std::string>({"position-aware", "position-aware", "position-aware", "whole",
                                         "partial-volume", "taper-inside", "surface-energy"});
  influence_ = lot.one_of<std::string>({"constant", "inverse", "polynomial"});
  // No ratio is within 0.005 of the distance of two particles of a lattice, in quarters of a spacing either.
  ratio_ = solid ? lot.one_of<double>({2.515, 3.015}) : lot.one_of<double>({2.515, 3.015, 3.3});
  plastic = lot.chance(0.35);
  small = lot.chance(0.5);
  steps = plastic ? lot.whole(2, 3) : lot.whole(1, 2);
  one_ = material(lot, plastic);
  two_ = material(lot, plastic && lot.chance(0.5));
}

std::string SceneText::material(Lot& lot, bool flows) const {
  const double modulus = modulus_ * lot.between(0.4, 1);
  std::string text = fmt::format("model: {}, young_modulus: {}, poisson_ratio: {}",
                                 flows ? "elastic-plastic" : "elastic", digits(modulus), digits(lot.between(0.1, 0.4)));
  if (!flows) return text;
  text += fmt::format(", yield_stress: {{{}: {}}}", lot.chance(0.5) ? "tension" : "shear",
                      digits(modulus * lot.between(0.001, 0.003)));
  // There is always some hardening, so that every load has an equilibrium.
  text += fmt::format(", hardening_modulus: {{tension: {}}}", digits(modulus * lot.between(0.05, 0.2)));
  if (lot.chance(0.3))
    text += fmt::format(", kinematic_hardening_modulus: {{shear: {}}}", digits(modulus * lot.between(0.01, 0.05)));
  return text;
}

std::string SceneText::point(const Vector3& cells) const {
  std::string text;
  for (int c = 0; c < d(); ++c) {
    const auto k = static_cast<std::size_t>(c);
    text += (c ? ", " : "") + digits(origin[k] + cells[k] * h);
  }
  return "[" + text + "]";
}

std::string SceneText::box(const Vector3& min, const Vector3& max) const {
  return fmt::format("{{box: {{min: {}, max: {}}}}}", point(min), point(max));
}

void SceneText::add_set(const std::string& name, const char* side, double cells) {
  sets.push_back(fmt::format("{}: {{where: \"x {} {}\"}}", name, side, digits(x(cells))));
}

void SceneText::body(const std::string& name, const std::string& shape, double spacing, const std::string& material) {
  bodies.push_back(
      fmt::format("{{name: {}, shape: {}, spacing: {}, material: {}}}", name, shape, digits(spacing), material));
}

std::string SceneText::components(const Vector3& values, const std::string& formula) const {
  std::string text;
  for (int c = 0; c < d(); ++c)
    text +=
        fmt::format("{}{}: \"{}*{}\"", c ? ", " : "", "xyz"[c], digits(values[static_cast<std::size_t>(c)]), formula);
  return "{" + text + "}";
}

void SceneText::hold(const std::string& set) {
  boundary.push_back(fmt::format("{{set: {}, displacement: {}}}", set, components({0, 0, 0}, "t")));
}

void SceneText::move(const std::string& set, double size) {
  const Vector3 way{h * size * lot_.between(0.5, 1), h * size * lot_.between(-1, 1), h * size * lot_.between(-1, 1)};
  boundary.push_back(fmt::format("{{set: {}, displacement: {}}}", set, components(way, "t")));
}

void SceneText::force(const std::string& set, double stress) {
  const double size = modulus_ * stress * std::pow(h, d() - 1);
  boundary.push_back(fmt::format("{{set: {}, force: {}}}", set,
                                 components({size, size * lot_.between(-1, 1), size * lot_.between(-1, 1)}, "t")));
}

void SceneText::weigh(const std::string& set) {
  const double size = modulus_ * 1e-4 / h;
  const Vector3 way{size * lot_.between(-1, 1), size * lot_.between(-1, 1), size * lot_.between(-1, 1)};
  const std::string varies = fmt::format("t*(1 + 0.2*sin((x - 2*y)/{}))", digits(5 * h));
  boundary.push_back(fmt::format("{{set: {}, body_force: {}}}", set, components(way, varies)));
}

void SceneText::pressure(const std::string& set, double stress, const std::string& facing) {
  boundary.push_back(fmt::format("{{set: {}, pressure: \"{}*t\"{}}}", set, digits(modulus_ * stress),
                                 facing.empty() ? "" : ", facing: " + facing));
}

void SceneText::crack(const Vector3& start, const Vector3& end, double thickness) {
  if (!solid_) {
    cracks.push_back(fmt::format("{{segment: {{start: {}, end: {}}}}}", point(start), point(end)));
    return;
  }
  cracks.push_back(fmt::format("{{rectangle: {{corner: {}, edge1: [{}, {}, 0], edge2: [0, 0, {}]}}}}",
                               point({start[0], start[1], -1}), digits((end[0] - start[0]) * h),
                               digits((end[1] - start[1]) * h), digits((thickness + 2) * h)));
}

void SceneText::record(const std::string& set) {
  for (int c = 0; c < d(); ++c) {
    history_.push_back(fmt::format("{{name: force_{0}_{1}, reaction: {0}, component: {1}}}", set, "xyz"[c]));
    history_.push_back(fmt::format("{{name: way_{0}_{1}, displacement: {0}, component: {1}}}", set, "xyz"[c]));
  }
}

std::string SceneText::text() const {
  std::vector<std::string> history = history_;
  if (plastic)
    history.push_back("{name: flowing, yielded: " + bodies.front().substr(7, bodies.front().find(',') - 7) + "}");
  // Newton goes on until nothing but rounding is left.
  return fmt::format("dimension: {}\n", dimension_) + listed("body", bodies) +
         fmt::format("horizon: {{length: {}}}\nquadrature: {}\ninfluence: {}\ndeformation: {}\n", digits(ratio_ * h),
                     quadrature_, influence_, small ? "small" : "finite") +
         listed("cracks", cracks) + fmt::format("materials:\n  one: {{{}}}\n  two: {{{}}}\n", one_, two_) +
         (sets.empty() ? "" : "sets: {" + joined(sets) + "}\n") + listed("boundary", boundary) +
         fmt::format("steps: {{end: 1, count: {}}}\n", steps) + listed("history", history) +
         "output: {fields: [displacement, force, dilatation, stored_energy, stress, damage]}\n"
         "solver:\n"
         "  newton: {tolerance: 1e-13, update_tolerance: 1e-12, max_iterations: 60, forcing: constant}\n"
         "  linear: {tolerance: 1e-9}\n" +
         extra;
}

RandomScene named(const std::string& name, const SceneText& text) {
  RandomScene scene;
  scene.name = name;
  scene.yaml = text.text();
  scene.elastic = !text.plastic;
  scene.small = text.small;
  return scene;
}

}  // namespace perinox::invariance
