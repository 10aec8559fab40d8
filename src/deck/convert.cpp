#include "convert.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "perinox/deck/scalar.hpp"
#include "words.hpp"

namespace perinox::deck {
namespace {

/// Makes a number without a parser. Anything else is compiled.
Expression convert_expression(const Value& value) { return Expression(value.text(), value.location()); }

BodyPart convert_body(const Value& value, Dimension dimension) {
  BodyPart part;
  part.location = value.location();
  part.name = value.at("name").text();
  part.material = value.at("material").text();
  part.shape = convert_shape(value.at("shape"), dimension);
  if (value.has("outline")) {
    if (!std::holds_alternative<CloudFile>(part.shape.form))
      refuse(value.at("outline").location(),
             fmt::format("the body {} has a shape, which is its outline; leave outline out", part.name));
    part.outline = convert_shape(value.at("outline"), dimension);
    if (std::holds_alternative<CloudFile>(part.outline->form))
      refuse(value.at("outline").location(), "an outline is a shape, not another point cloud; write a box or the like");
  }
  if (value.has("spacing")) {
    part.spacing = value.at("spacing").number();
    part.spacing_location = value.at("spacing").location();
  } else if (!std::holds_alternative<CloudFile>(part.shape.form)) {
    refuse(value.location(),
           fmt::format("the body {} needs the key spacing: only a point cloud can do without", part.name));
  }
  return part;
}

void convert_boundary_cells(const Value& word, Quadrature quadrature, BodyPart& part) {
  const bool cloud = std::holds_alternative<CloudFile>(part.shape.form);
  if (word.text() == "cut" && cloud)
    refuse(word.location(),
           fmt::format("the body {} is a point cloud, which has no cells that could be cut; leave boundary_cells out",
                       part.name));
  if (word.text() == "cut" && quadrature != Quadrature::position_aware)
    refuse(word.location(),
           "boundary_cells: cut needs quadrature: position-aware, which makes up for uneven volumes; "
           "change one of the two");
  part.cut_cells = word.text() != "whole" && quadrature == Quadrature::position_aware && !cloud;
}

/// Takes every later body's shape away from the earlier ones.
void let_later_bodies_win(std::vector<BodyPart>& bodies) {
  const auto region = [](const BodyPart& part) -> const Shape* {
    if (!std::holds_alternative<CloudFile>(part.shape.form)) return part.as_written ? &*part.as_written : &part.shape;
    return part.outline ? &*part.outline : nullptr;
  };
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    const bool cloud = std::holds_alternative<CloudFile>(bodies[k].shape.form);
    if (cloud && !bodies[k].outline) continue;  // its particles are sorted out one by one
    Shape& own = cloud ? *bodies[k].outline : bodies[k].shape;
    Difference rest{{own}};
    for (std::size_t later = k + 1; later < bodies.size(); ++later)
      if (const Shape* shape = region(bodies[later])) rest.parts.push_back(*shape);
    if (rest.parts.size() == 1) continue;
    bodies[k].as_written = own;
    own.form = std::move(rest);
  }
}

Horizon convert_horizon(const Value& value) {
  Horizon horizon;
  horizon.location = value.location();
  if (value.has("ratio")) horizon.ratio = value.at("ratio").number();
  if (value.has("length")) horizon.length = value.at("length").number();
  return horizon;
}

Set convert_set(const std::string& name, const Value& value, Dimension dimension) {
  Set set;
  set.location = value.location();
  set.name = name;
  const auto& [form, inner] = value.entries().front();
  if (form == "where") {
    const Expression condition = convert_expression(inner);
    if (condition.uses_time()) {
      refuse(inner.location(),
             fmt::format("the formula of the set {} uses t, but a set is the same at every t; use only "
                         "x, y and z",
                         name));
    }
    if (condition.text().find_first_of("<>=!") == std::string::npos && !parse_number(condition.text()))
      refuse(
          inner.location(),
          fmt::format("the formula of the set {} compares nothing, so that it holds wherever it is not exactly zero; "
                      "write a condition, such as \"{} > 0\"",
                      name, condition.text()));
    set.form = SetWhere{condition};
  } else if (form == "box") {
    const SetBox box{convert_point(inner.at("min"), dimension, "min"),
                     convert_point(inner.at("max"), dimension, "max")};
    refuse_empty_box(box.min, box.max, dimension, inner.at("max").location(), "box");
    set.form = box;
  } else if (form == "ids") {
    SetIds ids;
    for (const Value& id : inner.items()) ids.ids.push_back(id.integer());
    set.form = ids;
  } else {
    set.form = SetBody{inner.text()};
  }
  return set;
}

Point facing_of(const Value& value, LoadKind kind, Dimension dimension) {
  if (kind != LoadKind::traction && kind != LoadKind::pressure)
    refuse(value.location(), "facing chooses faces of the surface and goes with traction or pressure only; remove it");
  const Point direction = convert_point(value, dimension, "facing");
  const double length = std::hypot(direction[0], direction[1], direction[2]);
  if (!(length > 0)) refuse(value.location(), "facing has length 0 and points nowhere; give a direction");
  return {direction[0] / length, direction[1] / length, direction[2] / length};
}

Load convert_load(const Value& value, Dimension dimension) {
  Load load;
  load.location = value.location();
  load.set = value.at("set").text();
  const std::string name = *std::find_if(words::load_kind.begin(), words::load_kind.end(),
                                         [&](const std::string& kind) { return value.has(kind); });
  load.kind = words::value_of<LoadKind>(words::load_kind, name);
  if (value.has("facing")) load.facing = facing_of(value.at("facing"), load.kind, dimension);
  const Value& inner = value.at(name);
  if (load.kind == LoadKind::pressure) {
    load.component[0] = convert_expression(inner);
    return load;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string& axis = words::component[i];
    if (!inner.has(axis)) continue;
    const Value& component = inner.at(axis);
    if (i == 2 && dimension != Dimension::three) {
      refuse(component.location(), fmt::format("{} has a z component, but this deck is 2-D; remove z", name));
    }
    load.component[i] = convert_expression(component);
  }
  if (load.kind == LoadKind::displacement && inner.has("table")) {
    load.table = inner.at("table").text();
    load.table_location = inner.at("table").location();
  }
  return load;
}

Material convert_material(const std::string& name, const Value& value) {
  Material material{value.location(), name, value.at("model").text(), value, {}, {}};
  if (value.has("density")) material.density = value.at("density").number();
  if (value.has("damage")) material.damage = convert_damage(value.at("damage"));
  return material;
}

Steps convert_steps(const Value& value) {
  Steps steps;
  steps.end = value.at("end").number();
  steps.count = static_cast<int>(value.at("count").integer());
  steps.adaptive = value.at("adaptive").boolean();
  steps.max_cuts = static_cast<int>(value.at("max_cuts").integer());
  steps.control = words::value_of<Control>(words::control, value.at("control").text());
  return steps;
}

template <class Enumeration>
Enumeration convert_word(const Value& map, const std::string& key, const std::vector<std::string>& words) {
  return words::value_of<Enumeration>(words, map.at(key).text());
}

Solver convert_solver(const Value& value) {
  Solver solver;
  solver.location = value.location();
  solver.tangent = convert_word<TangentKind>(value, "tangent", words::tangent_kind);
  solver.form = convert_word<TangentForm>(value, "form", words::tangent_form);
  const Value& newton = value.at("newton");
  solver.newton.tolerance = newton.at("tolerance").number();
  solver.newton.update_tolerance = newton.at("update_tolerance").number();
  solver.newton.max_iterations = static_cast<int>(newton.at("max_iterations").integer());
  solver.newton.line_search = convert_word<LineSearch>(newton, "line_search", words::line_search);
  solver.newton.forcing = convert_word<Forcing>(newton, "forcing", words::forcing);
  const Value& linear = value.at("linear");
  solver.linear.method = convert_word<LinearMethod>(linear, "method", words::linear_method);
  solver.linear.preconditioner = convert_word<Preconditioner>(linear, "preconditioner", words::preconditioner);
  solver.linear.tolerance = linear.at("tolerance").number();
  solver.linear.max_iterations = static_cast<int>(linear.at("max_iterations").integer());
  const int word = convert_word<int>(linear, "chebyshev_steps", words::chebyshev_steps);
  solver.linear.chebyshev_steps = word == 0 ? 0 : 2 * word - 1;
  refuse_unfit_solver(solver, linear);
  return solver;
}

Output convert_output(const Value& value) {
  Output output;
  output.every = static_cast<int>(value.at("every").integer());
  for (const Value& field : value.at("fields").items()) output.fields.push_back(field.text());
  return output;
}

HistoryEntry convert_history(const Value& value, Dimension dimension) {
  HistoryEntry entry;
  entry.location = value.location();
  entry.name = value.at("name").text();
  for (const std::string& kind : words::history_kind) {
    if (!value.has(kind)) continue;
    entry.kind = words::value_of<HistoryKind>(words::history_kind, kind);
    entry.set = value.at(kind).text();
  }
  const bool directed = entry.kind != HistoryKind::yielded;
  if (directed && !value.has("component")) {
    refuse(value.location(), fmt::format("the history entry {} needs the key component: x, y or z", entry.name));
  }
  if (!directed && value.has("component")) {
    refuse(value.at("component").location(),
           fmt::format("the history entry {} is a fraction and has no component; remove it", entry.name));
  }
  if (directed) entry.component = convert_word<int>(value, "component", words::component);
  if (entry.component == 2 && dimension != Dimension::three) {
    refuse(value.at("component").location(),
           fmt::format("the history entry {} asks for the z component, but this deck is 2-D; use x or y", entry.name));
  }
  return entry;
}

}  // namespace

bool Deck::breaks() const {
  return std::any_of(materials.begin(), materials.end(), [](const Material& m) { return m.damage.has_value(); });
}

bool Deck::may_move() const {
  if (dynamics == Dynamics::explicit_ || fallback == Fallback::explicit_) return true;
  return fallback == Fallback::automatic && breaks() &&
         std::all_of(materials.begin(), materials.end(), [](const Material& m) { return m.density.has_value(); });
}

bool Deck::may_overlap() const {
  const bool kept_apart = dynamics == Dynamics::explicit_ && motion.contact;
  return !kept_apart && (breaks() || !cracks.empty() || (!bond_bodies && body.size() > 1));
}

int unknowns(Dimension dimension) { return dimension == Dimension::three ? 3 : 2; }

Deck convert(Value checked, const std::string& file) {
  Deck deck;
  deck.file = file;
  deck.title = checked.at("title").text();
  deck.dimension = convert_word<Dimension>(checked, "dimension", words::dimension);
  for (const Value& part : checked.at("body").items()) deck.body.push_back(convert_body(part, deck.dimension));
  deck.overlap = convert_word<Overlap>(checked, "overlap", words::overlap);
  if (deck.overlap == Overlap::later_wins) let_later_bodies_win(deck.body);
  deck.bond_bodies = checked.at("bond_bodies").boolean();
  deck.across_gaps = convert_word<AcrossGaps>(checked.at("bonds"), "across_gaps", words::across_gaps);
  deck.horizon = convert_horizon(checked.at("horizon"));
  deck.influence = convert_word<Influence>(checked, "influence", words::influence);
  deck.quadrature = convert_word<Quadrature>(checked, "quadrature", words::quadrature);
  for (std::size_t k = 0; k < deck.body.size(); ++k)
    convert_boundary_cells(checked.at("body").items()[k].at("boundary_cells"), deck.quadrature, deck.body[k]);
  deck.small_strain = checked.at("deformation").text() == "small";
  for (const Value& crack : checked.at("cracks").items()) deck.cracks.push_back(convert_crack(crack, deck.dimension));
  for (const auto& [name, value] : checked.at("materials").entries())
    deck.materials.push_back(convert_material(name, value));
  for (const auto& [name, value] : checked.at("sets").entries()) {
    deck.sets.push_back(convert_set(name, value, deck.dimension));
  }
  for (const Value& load : checked.at("boundary").items()) deck.boundary.push_back(convert_load(load, deck.dimension));
  deck.dynamics = convert_word<Dynamics>(checked, "dynamics", words::dynamics);
  for (const Value& value : checked.at("initial_velocity").items())
    deck.initial_velocity.push_back(convert_initial_velocity(value, deck.dimension));
  deck.motion = convert_explicit(checked.at("explicit"));
  deck.fracture = convert_fracture(checked.at("fracture"));
  deck.fallback = convert_word<Fallback>(checked, "fallback", words::fallback);
  deck.hand_over = convert_hand_over(checked.at("hand_over"));
  deck.steps = convert_steps(checked.at("steps"));
  deck.arc_length = convert_arc_length(checked.at("arc_length"), deck.dimension);
  deck.solver = convert_solver(checked.at("solver"));
  deck.output = convert_output(checked.at("output"));
  for (const Value& entry : checked.at("history").items()) {
    deck.history.push_back(convert_history(entry, deck.dimension));
  }
  deck.resolved = std::move(checked);
  check_references(deck);
  refuse_unfit_dynamics(deck);
  refuse_unfit_arc_length(deck);
  return deck;
}

}  // namespace perinox::deck
