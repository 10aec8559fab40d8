#include "perinox/deck/remarks.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "perinox/deck/scalar.hpp"
#include "words.hpp"

namespace perinox::deck {
namespace {

/// Horizon in spacings below which a family holds the nearest neighbours and hardly any others.
constexpr double few_spacings = 1.5;

/// True for a load that is the same at every t and not zero.
bool is_steady(const Load& load) {
  bool acts = false;
  for (const auto& component : load.component) {
    if (!component) continue;
    if (component->uses_time()) return false;
    const auto number = parse_number(component->text());
    acts = acts || !number || *number != 0;
  }
  return acts;
}

bool changes(const Load& load) {
  return load.table || std::any_of(load.component.begin(), load.component.end(),
                                   [](const auto& component) { return component && component->uses_time(); });
}

void remark_on_steady_loads(const Deck& deck, std::vector<std::string>& found) {
  if (deck.dynamics != Dynamics::quasi_static || deck.steps.control != Control::load || deck.steps.count < 2) return;
  const bool some_change = std::any_of(deck.boundary.begin(), deck.boundary.end(), changes);
  for (const Load& load : deck.boundary) {
    if (!is_steady(load)) continue;
    found.push_back(placed(
        load.location,
        fmt::format("the {} on {} does not use t, so that it is there in full from the first step on{}; let it grow "
                    "as in \"1.5*t\" unless that is meant",
                    words::load_kind[static_cast<std::size_t>(load.kind)], load.set,
                    some_change
                        ? ""
                        : fmt::format(", and all {} steps find the same state, as no load uses t", deck.steps.count))));
  }
}

void remark_on_horizon(const Deck& deck, std::vector<std::string>& found) {
  double spacing = 0;
  for (const BodyPart& part : deck.body) spacing = std::max(spacing, part.spacing);
  if (!deck.horizon.ratio && spacing == 0) return;  // clouds alone
  const double spacings = deck.horizon.ratio ? *deck.horizon.ratio : *deck.horizon.length / spacing;
  if (spacings >= few_spacings || spacings < 1) return;
  found.push_back(
      placed(deck.horizon.location,
             fmt::format("a horizon of {:g} times the spacing holds hardly more than the nearest neighbours, whose "
                         "bonds follow the lattice and not the material; 3 are usual",
                         spacings)));
}

/// Remarks on keys that are right but of which this run makes no use. The location of a map that the deck does not have
/// is where the deck begins.
void remark_on_unused(const Deck& deck, std::vector<std::string>& found) {
  const auto unused = [&](const Location& where, const char* key, const char* why) {
    if (where.column > 1) found.push_back(placed(where, fmt::format("{} has no effect here: {}", key, why)));
  };
  const bool in_steps = deck.dynamics == Dynamics::quasi_static;
  if (in_steps && !deck.may_move())
    unused(deck.motion.location, "explicit",
           deck.motion.contact ? "the run goes in load steps, without motion in time and without contact; faces may "
                                 "pass into each other"
                               : "the run goes in load steps, without motion in time");
  if (in_steps && deck.steps.control != Control::arc_length)
    unused(deck.arc_length.location, "arc_length", "steps.control is load");
  if (!deck.breaks()) unused(deck.fracture.location, "fracture", "no material has a damage law");
  if (!in_steps || !deck.may_move())
    unused(deck.hand_over.location, "hand_over",
           in_steps ? "the run goes in load steps only (fallback)" : "the whole run is a motion in time");
}

}  // namespace

std::vector<std::string> remarks(const Deck& deck) {
  std::vector<std::string> found;
  remark_on_unused(deck, found);
  remark_on_horizon(deck, found);
  remark_on_steady_loads(deck, found);
  return found;
}

std::vector<std::string> remarks_on_fields(const Deck& deck, const Schema& schema) {
  std::vector<std::string> found;
  for (const Value& asked : deck.resolved.at("output").at("fields").items()) {
    const std::string& name = asked.text();
    const FieldDeclaration* field = schema.field(name);
    if (field == nullptr) continue;
    bool of_model = false, has_model = false;
    for (const ModelDeclaration& model : schema.models()) {
      const bool its = std::any_of(model.fields.begin(), model.fields.end(),
                                   [&](const FieldDeclaration& own) { return own.name == name; });
      of_model = of_model || its;
      has_model = has_model || (its && std::any_of(deck.materials.begin(), deck.materials.end(),
                                                   [&](const Material& one) { return one.model == model.name; }));
    }
    const bool missing = (field->plane_only && deck.dimension == Dimension::three) || (of_model && !has_model) ||
                         (name == "velocity" && deck.dynamics != Dynamics::explicit_);
    if (missing)
      found.push_back(placed(asked.location(), fmt::format("this scene has no field {}, so that it will not be in "
                                                           "results.h5; it exists {}",
                                                           name, field->exists)));
  }
  return found;
}

}  // namespace perinox::deck
