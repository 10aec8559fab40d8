/// Declares the keys of breaking bonds, of motion in time, and of the way from one to the other.
#include "declare.hpp"
#include "words.hpp"

namespace perinox::deck {
namespace {

Key share_key(std::string name, std::string fallback, std::string sentence) {
  Key key = positive_key(std::move(name), "-", std::move(sentence));
  key.maximum = 1;
  key.fallback = std::move(fallback);
  return key;
}

Key not_negative_key(std::string name, std::string unit, std::string fallback, std::string sentence) {
  Key key = number_key(std::move(name), std::move(unit), std::move(sentence));
  key.minimum = 0;
  key.fallback = std::move(fallback);
  return key;
}

Key set_list(std::string name, std::string sentence) {
  Key key = list_key(std::move(name), std::move(sentence), text_key("", "A set's or body's name, or all."));
  key.unique = true;
  key.fallback = "[]";
  return key;
}

}  // namespace

Key declare_damage() {
  Key ductile = map_key("ductile",
                        "A bond that is stretched breaks when the mean over its ends of the equivalent plastic strain "
                        "over d0 exp(-c eta) reaches 1; eta is the triaxiality, mean stress over von Mises stress.",
                        {required(positive_key("d0", "-", "Failure strain at zero triaxiality.")),
                         not_negative_key("c", "-", "0", "How fast the failure strain falls with triaxiality.")});
  Key key = map_key(
      "damage", "When the bonds of this material break: exactly one law. Without it they never do.",
      {positive_key("critical_stretch", "-", "A bond breaks when its extension over its length reaches this."),
       positive_key(
           "critical_bond_energy", "energy/volume^2",
           "A stretched bond breaks when the energy that its break releases reaches this; only for materials that "
           "do not flow."),
       positive_key("energy_release_rate", "energy/area",
                    "Energy that a crack takes an area of its surface, G_c; turned into one of the two above with "
                    "this scene's horizon, influence function and quadrature."),
       ductile,
       word_key(
           "criterion", words::break_criterion, "automatic",
           "What energy_release_rate is turned into; automatic takes bond-energy where the material does not flow, "
           "else stretch.")});
  key.alternatives = {{"critical_stretch"}, {"critical_bond_energy"}, {"energy_release_rate"}, {"ductile"}};
  key.place = "a damage law";
  return key;
}

Key declare_fracture() {
  Key key = map_key(
      "fracture",
      "How bonds break under quasi-static load: they are frozen during Newton; then the critical ones break, worst "
      "first, and the same load is solved again, until none breaks.",
      {set_list("unbreakable", "Sets whose particles' bonds never break, such as those under grips."),
       share_key("pass_share", "1e-4",
                 "Most bonds that break in one pass, of all bonds of the bodies that can move; the worst always does."),
       integer_key("max_passes", 1, 1e9, "1000", "Passes at one load after which the step counts as failed.")});
  key.fallback = "{}";
  key.example = "fracture: {unbreakable: [foot, head], pass_share: 1e-4}";
  return key;
}

Key declare_dynamics() {
  Key key = word_key("dynamics", words::dynamics, "quasi-static",
                     "quasi-static: equilibrium at every load; explicit: motion in time by velocity Verlet, t is the "
                     "time, steps.end its end and steps.count the number of rows and of output steps.");
  key.example = "dynamics: explicit";
  return key;
}

Key declare_explicit() {
  Key distance = positive_key("distance", "-",
                              "Particles without a bond between them repel when nearer than this times the larger "
                              "of their spacings.");
  distance.fallback = "0.9";
  Key stiffness = positive_key("stiffness", "-", "Of a pair in contact, times that of a bond between the two.");
  stiffness.fallback = "1";
  Key safety = positive_key("safety", "-",
                            "Time step over the largest stable one. Left out: 0.8, and 0.5 where a material can flow.");
  safety.maximum = 1;
  safety.required = false;
  Key key = map_key(
      "explicit", "Motion in time.",
      {positive_key("time_step", "time",
                    "Longest time step: the time between two rows is cut into equal ones. Left out: the largest stable "
                    "one times safety."),
       safety, not_negative_key("damping", "1/time", "0", "Mass-proportional damping."),
       map_key("contact", "Repulsion between particles that share no bond; left out: none.", {distance, stiffness})});
  key.fallback = "{}";
  key.example = "explicit: {safety: 0.7, contact: {}}";
  return key;
}

Key declare_initial_velocity() {
  Key velocity =
      map_key("velocity", "The velocity; components not named are zero.",
              {expression_key("x", "velocity", "x component: a number or a formula of x, y, z."),
               expression_key("y", "velocity", "y component: a number or a formula of x, y, z."),
               expression_key("z", "velocity", "z component: a number or a formula of x, y, z; only in 3-D.")});
  velocity.alternatives = {{"x", "y", "z"}};
  Key element =
      map_key("", "One initial velocity.",
              {required(text_key("set", "A set's or body's name, or all; a later entry wins.")), required(velocity)});
  element.place = "an initial velocity";
  Key key = list_key("initial_velocity", "Velocities at t = 0; only with dynamics: explicit.", element);
  key.fallback = "[]";
  key.example = "initial_velocity:\n  - {set: head, velocity: {x: -3.2e4}}";
  return key;
}

Key declare_fallback() {
  Key key = word_key("fallback", words::fallback, "automatic",
                     "What happens where a quasi-static step has no equilibrium: explicit: the run goes on in time "
                     "until the body is at rest again; none: it stops with status 1; automatic: explicit where a "
                     "material has a damage law and all have a density, else none.");
  key.example = "fallback: none";
  return key;
}

Key declare_hand_over() {
  Key rate = number_key("rate", "1/time", "Of the load parameter over time while the run is explicit; 0: loads held.");
  rate.minimum = 0;
  rate.fallback = "0";
  Key overload = number_key("overload", "-",
                            "Measure of the worst bond over its limit, after a pass of bond breaking, that makes it a "
                            "dynamic event: the crack runs faster than equilibrium can follow.");
  overload.minimum = 1;
  overload.fallback = "4";
  Key key = map_key(
      "hand_over", "When a quasi-static run goes on in time, and when it comes back.",
      {share_key(
           "broken_share", "0.005",
           "Bonds broken in one load step, of all bonds of the bodies that can move, that make it a dynamic event."),
       overload,
       share_key("kinetic_share", "1e-3", "Kinetic energy over stored energy below which the body is at rest."),
       positive_key("quiet_time", "time",
                    "Time without a broken bond that rest needs; left out: that of a wave through the body."),
       positive_key("longest_time", "time",
                    "Time after which a run that finds no rest stops; left out: a thousand times that of a wave "
                    "through the body."),
       number_key("damping", "1/time",
                  "Mass-proportional damping in this phase; left out: two over the time of a wave through the body."),
       rate});
  key.keys[5].minimum = 0;
  key.fallback = "{}";
  key.example = "hand_over: {broken_share: 0.05, kinetic_share: 1e-4}";
  return key;
}

Key declare_arc_length() {
  Key growth = positive_key("largest_growth", "-", "Largest arc over that of the first step.");
  growth.fallback = "4";
  Key until = map_key(
      "until", "Ends the run where a set's mean displacement, by volume, has come this far; the last step lands there.",
      {required(text_key("set", "A set's or body's name, or all.")),
       required(word_key("component", words::component, "", "Direction.")),
       required(number_key("displacement", "length", "Mean displacement, its sign included."))});
  Key key = map_key(
      "arc_length",
      "Of steps.control: arc-length. The first step goes to t = steps.end/steps.count and its displacement is the unit "
      "of "
      "the arc; the run ends at steps.end, at `until`, or with the last step.",
      {integer_key("max_steps", 1, 1e9, "1000", "Most steps."),
       integer_key("wanted_iterations", 1, 100, "5",
                   "Newton iterations a step; with fewer the arc grows, with more it shrinks, and with more than twice "
                   "as many it is halved and the step done again."),
       growth, until});
  key.fallback = "{}";
  key.example = "arc_length: {max_steps: 200, until: {set: head, component: y, displacement: -2.5}}";
  return key;
}

}  // namespace perinox::deck
