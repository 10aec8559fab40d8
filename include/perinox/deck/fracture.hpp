#pragma once
/// What a deck says of breaking bonds and of motion in time. Included by deck.hpp.
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "perinox/deck/expression.hpp"
#include "perinox/deck/location.hpp"

namespace perinox::deck {

/// What energy_release_rate is turned into.
enum class BreakCriterion { automatic, bond_energy, stretch };
/// A point fails at the equivalent plastic strain strain * exp(-slope * triaxiality).
struct DuctileFailure {
  double strain = 0;  ///< d0
  double slope = 0;   ///< c
};
/// When the bonds of a material break: exactly one of the four is given.
struct Damage {
  Location location;
  std::optional<double> critical_stretch;
  std::optional<double> critical_bond_energy;  ///< energy a volume squared
  std::optional<double> energy_release_rate;   ///< energy an area
  std::optional<DuctileFailure> ductile;
  BreakCriterion criterion = BreakCriterion::automatic;  ///< of energy_release_rate
};

/// Passes of bond breaking at one load.
struct Fracture {
  Location location;
  std::vector<std::string> unbreakable;  ///< sets: bonds with an end in one of them never break
  double pass_share = 1e-4;              ///< most bonds broken in one pass, of all bonds; always at least the worst
  int max_passes = 1000;                 ///< at one load
};

enum class Dynamics { quasi_static, explicit_ };
struct InitialVelocity {
  Location location;
  std::string set;
  std::array<std::optional<Expression>, 3> component;
};
/// Short-range repulsion between particles that share no bond.
struct Contact {
  double distance = 0.9;   ///< below which two particles repel, of the larger of their spacings
  double stiffness = 1.0;  ///< of a pair, of the stiffness of a bond between them
};
struct Explicit {
  Location location;
  std::optional<double> time_step;  ///< time; none: the largest stable one times safety
  double safety = 0.8;              ///< time step over the largest stable one; 0: motion::time_step_safety
  double damping = 0;               ///< mass-proportional, 1/time
  std::optional<Contact> contact;
};

/// What happens where a quasi-static step has no equilibrium.
enum class Fallback { automatic, explicit_, none };
struct HandOver {
  Location location;
  double broken_share = 0.005;         ///< bonds broken in one load step, of all bonds, that make it a dynamic event
  double overload = 4;                 ///< of the worst bond after a pass, over its limit: the crack runs
  double kinetic_share = 1e-3;         ///< of the stored energy: at rest below it
  std::optional<double> quiet_time;    ///< time without a broken bond; none: a wave's passage through the body
  std::optional<double> longest_time;  ///< time after which the run stops; none: a thousand passages
  std::optional<double> damping;       ///< 1/time during the hand-over; none: two over a passage
  double rate = 0;                     ///< of the load parameter over time during the hand-over
};

enum class Control { load, arc_length };
/// Where an arc-length run ends besides steps.end.
struct ArcLength {
  Location location;
  int max_steps = 1000;
  int wanted_iterations = 5;  ///< Newton iterations a step; the arc grows below, shrinks above
  double largest_growth = 4;  ///< of the arc, over the first step's
  struct Until {
    std::string set;
    int component = 0;
    double displacement = 0;  ///< mean of the set, length; reached from the side of 0
  };
  std::optional<Until> until;
};

}  // namespace perinox::deck
