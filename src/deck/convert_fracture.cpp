/// Converts what a deck says about breaking bonds, motion in time, and the way from one to the other.
#include <fmt/format.h>

#include "convert.hpp"
#include "perinox/deck/scalar.hpp"
#include "words.hpp"

namespace perinox::deck {
namespace {

template <class Enumeration>
Enumeration word_of(const Value& map, const std::string& key, const std::vector<std::string>& words) {
  return words::value_of<Enumeration>(words, map.at(key).text());
}

std::optional<double> number_of(const Value& map, const std::string& key) {
  return map.has(key) ? std::optional<double>(map.at(key).number()) : std::nullopt;
}

}  // namespace

Damage convert_damage(const Value& value) {
  Damage damage;
  damage.location = value.location();
  damage.critical_stretch = number_of(value, "critical_stretch");
  damage.critical_bond_energy = number_of(value, "critical_bond_energy");
  damage.energy_release_rate = number_of(value, "energy_release_rate");
  if (value.has("ductile"))
    damage.ductile = DuctileFailure{value.at("ductile").at("d0").number(), value.at("ductile").at("c").number()};
  damage.criterion = word_of<BreakCriterion>(value, "criterion", words::break_criterion);
  if (damage.criterion != BreakCriterion::automatic && !damage.energy_release_rate)
    refuse(value.at("criterion").location(), "criterion goes with energy_release_rate only; remove it");
  return damage;
}

Fracture convert_fracture(const Value& value) {
  Fracture fracture;
  fracture.location = value.location();
  for (const Value& set : value.at("unbreakable").items()) fracture.unbreakable.push_back(set.text());
  fracture.pass_share = value.at("pass_share").number();
  fracture.max_passes = static_cast<int>(value.at("max_passes").integer());
  return fracture;
}

Explicit convert_explicit(const Value& value) {
  Explicit motion;
  motion.location = value.location();
  motion.time_step = number_of(value, "time_step");
  motion.safety = value.has("safety") ? value.at("safety").number() : 0;
  motion.damping = value.at("damping").number();
  if (value.has("contact"))
    motion.contact = Contact{value.at("contact").at("distance").number(), value.at("contact").at("stiffness").number()};
  return motion;
}

InitialVelocity convert_initial_velocity(const Value& value, Dimension dimension) {
  InitialVelocity initial;
  initial.location = value.location();
  initial.set = value.at("set").text();
  const Value& velocity = value.at("velocity");
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string& axis = words::component[i];
    if (!velocity.has(axis)) continue;
    const Value& component = velocity.at(axis);
    if (i == 2 && dimension != Dimension::three)
      refuse(component.location(), "the velocity has a z component, but this deck is 2-D; remove z");
    initial.component[i] = Expression(component.text(), component.location());
    if (initial.component[i]->uses_time())
      refuse(component.location(), "an initial velocity holds at t = 0 only, so its formula cannot use t; remove it");
  }
  return initial;
}

HandOver convert_hand_over(const Value& value) {
  HandOver change;
  change.location = value.location();
  change.broken_share = value.at("broken_share").number();
  change.overload = value.at("overload").number();
  change.kinetic_share = value.at("kinetic_share").number();
  change.quiet_time = number_of(value, "quiet_time");
  change.longest_time = number_of(value, "longest_time");
  change.damping = number_of(value, "damping");
  change.rate = value.at("rate").number();
  return change;
}

ArcLength convert_arc_length(const Value& value, Dimension dimension) {
  ArcLength arc;
  arc.location = value.location();
  arc.max_steps = static_cast<int>(value.at("max_steps").integer());
  arc.wanted_iterations = static_cast<int>(value.at("wanted_iterations").integer());
  arc.largest_growth = value.at("largest_growth").number();
  if (!value.has("until")) return arc;
  const Value& until = value.at("until");
  arc.until = ArcLength::Until{until.at("set").text(), word_of<int>(until, "component", words::component),
                               until.at("displacement").number()};
  if (arc.until->component == 2 && dimension != Dimension::three)
    refuse(until.at("component").location(), "until asks for the z component, but this deck is 2-D; use x or y");
  if (arc.until->displacement == 0)
    refuse(until.at("displacement").location(), "a displacement of 0 is where the run begins; give another");
  return arc;
}

void refuse_unfit_arc_length(const Deck& deck) {
  if (deck.steps.control != Control::arc_length) return;
  for (const Material& material : deck.materials)
    if (material.damage)
      refuse(
          material.damage->location,
          "arc-length control follows a body whose bonds hold: between two passes of bond breaking there is no path to "
          "follow; remove damage, or use steps.control: load");
  for (const Load& load : deck.boundary) {
    if (load.table) return;
    for (const auto& component : load.component)
      if (component && component->uses_time()) return;
  }
  refuse(deck.resolved.at("steps").at("control").location(),
         "arc-length follows the load parameter t, but nothing in boundary depends on it; write a force or a "
         "displacement as a formula of t");
}

void refuse_unfit_dynamics(const Deck& deck) {
  const bool moving = deck.dynamics == Dynamics::explicit_;
  for (const Load& load : deck.boundary)
    if (load.kind == LoadKind::velocity && !moving)
      refuse(load.location, "a prescribed velocity needs dynamics: explicit; prescribe a displacement, or ask for it");
  if (!moving && !deck.initial_velocity.empty())
    refuse(deck.initial_velocity.front().location,
           "an initial velocity needs dynamics: explicit; remove it, or ask for it");
  if (moving && deck.steps.control == Control::arc_length)
    refuse(deck.arc_length.location, "arc-length control follows equilibria and cannot go with dynamics: explicit");
  if (!moving && deck.fallback != Fallback::explicit_) return;
  for (const Material& material : deck.materials)
    if (!material.density)
      refuse(material.location, fmt::format("the material {} needs the key density: {}", material.name,
                                            moving ? "dynamics is explicit" : "fallback: explicit goes on in time"));
}

}  // namespace perinox::deck
