#pragma once
/// What a deck says about breaking bonds and about motion in time. deck.hpp includes it.
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "perinox/deck/expression.hpp"
#include "perinox/deck/location.hpp"

namespace perinox::deck {

/// The limit of a bond into which energy_release_rate is turned.
enum class BreakCriterion { automatic, bond_energy, stretch };
/// A point fails at the equivalent plastic strain strain * exp(-slope * triaxiality).
struct DuctileFailure {
  double strain = 0;  ///< d0
  double slope = 0;   ///< c
};
/// Says when the bonds of a material break. Exactly one of the four limits is given.
struct Damage {
  Location location;
  std::optional<double> critical_stretch;
  std::optional<double> critical_bond_energy;  ///< energy a volume squared
  std::optional<double> energy_release_rate;   ///< energy an area
  std::optional<DuctileFailure> ductile;
  BreakCriterion criterion = BreakCriterion::automatic;  ///< how energy_release_rate is used
};

/// Says how bonds break in passes at one load.
struct Fracture {
  Location location;
  std::vector<std::string> unbreakable;  ///< names of sets; bonds with an end in one of them never break
  double pass_share = 1e-4;              ///< most bonds broken in one pass over all bonds; the worst bond always breaks
  int max_passes = 1000;                 ///< most passes at one load
};

enum class Dynamics { quasi_static, explicit_ };
struct InitialVelocity {
  Location location;
  std::string set;
  std::array<std::optional<Expression>, 3> component;
};
/// Short-range repulsion between particles that share no bond.
struct Contact {
  double distance = 0.9;   ///< distance below which two particles repel, over the larger of their spacings
  double stiffness = 1.0;  ///< stiffness of a pair over that of a bond between them
};
struct Explicit {
  Location location;
  std::optional<double> time_step;  ///< time; none: the largest stable one times `safety`
  double safety = 0.8;              ///< time step over the largest stable one; 0: motion::time_step_safety
  double damping = 0;               ///< mass-proportional, 1/time
  std::optional<Contact> contact;
};

/// What happens where a quasi-static step has no equilibrium.
enum class Fallback { automatic, explicit_, none };
struct HandOver {
  Location location;
  double broken_share = 0.005;  ///< share of all bonds broken in one load step that makes it a dynamic event
  double overload = 4;          ///< load of the worst bond after a pass over its limit, beyond which the crack runs
  double kinetic_share = 1e-3;  ///< kinetic over stored energy, below which the body is at rest
  /// Time without a broken bond; none: the time of a wave's passage through the body.
  std::optional<double> quiet_time;
  std::optional<double> longest_time;  ///< time after which the run stops; none: the time of a thousand passages
  std::optional<double> damping;       ///< 1/time, during the hand-over; none: two over the time of a passage
  double rate = 0;                     ///< change of the load parameter over time during the hand-over
};

enum class Control { load, arc_length };
/// Settings of an arc-length run, and where it ends besides steps.end.
struct ArcLength {
  Location location;
  int max_steps = 1000;
  int wanted_iterations = 5;  ///< Newton iterations a step; the arc grows with fewer and shrinks with more
  double largest_growth = 4;  ///< largest arc over the first step's
  struct Until {
    std::string set;
    int component = 0;
    double displacement = 0;  ///< mean displacement of the set, length; it is reached from the side of 0
  };
  std::optional<Until> until;
};

}  // namespace perinox::deck
