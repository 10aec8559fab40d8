#pragma once
#include <optional>

#include "perinox/equilibrium/bordered_newton.hpp"
#include "perinox/equilibrium/step_control.hpp"

namespace perinox::equilibrium {

/// steps.control: arc-length. Follows the path of equilibria (u, t) wherever it goes: over limit points, where t turns
/// back, and along a plastic limit load. The first step goes to t = end/count and its displacement is the unit of the
/// arc; the last one lands on steps.end or on `until` exactly. Where a load turns back a step ends, and the next one
/// goes on to a given t again, as the first did: from there the path leads on in both directions of t, and the last
/// increment does not tell which.
class ArcLength : public StepControl {
 public:
  /// Throws InputError: nothing to follow, because nothing is free or no load changes with t. Collective.
  ArcLength(const deck::Deck& deck, medium::Medium& medium, const loads::Boundary& boundary, Newton& newton);

  bool finished() const override { return ended_ || steps_ >= settings_.max_steps; }
  std::string unreached() const override;
  NewtonResult attempt(int step, Observer& observer, std::vector<double>& force) override;
  double tried() const override { return tried_; }
  void accept() override;
  bool cut() override;
  double share() const override;

 private:
  enum class End { none, load, displacement };
  PathPoint committed_point() const;
  /// First guess of a step of the length arc_: the last increment again where that is nearly in balance, else along the
  /// tangent, in the direction that makes an acute angle with the last increment.
  NewtonResult predict(const PathPoint& origin, PathPoint& guess);
  /// Solves at a given t from the committed state, which is `point`, and moves that on to what it finds.
  NewtonResult solve_at(double t, int step, Observer& observer, PathPoint& point, std::vector<double>& force);
  /// The step up to where it may end early: along the arc, or to a given t. turned_ is true where a load turns back
  /// at its end.
  NewtonResult advance(const PathPoint& origin, int step, Observer& observer, PathPoint& point,
                       std::vector<double>& force);
  NewtonResult solve_on_path(const PathConstraint& constraint, int step, Observer& observer, PathPoint& point,
                             std::vector<double>& force);
  /// Share of the step from `origin` to `to` after which the run's end is passed; 1 and none if it is not.
  std::pair<double, End> passed(const PathPoint& origin, const PathPoint& to) const;

  const deck::Deck& deck_;
  const deck::ArcLength& settings_;
  medium::Medium& medium_;
  const loads::Boundary& boundary_;
  Newton& newton_;  ///< of steps to a given t
  BorderedNewton bordered_;
  PathNorm norm_;
  std::optional<FixedMean> until_;
  PathPoint last_increment_;
  PathPoint increment_;   ///< of the last attempt
  int iterations_ = 0;    ///< of the last attempt
  double first_load_;     ///< t of the first step
  double start_load_;     ///< change of t of a step that goes to a given one
  bool starting_ = true;  ///< the next step goes to a given t
  bool turned_ = false;   ///< a load turns back where the last attempt ends
  bool forward_ = true;   ///< t grew in the last step
  double arc_ = 0;        ///< of the next step; 0: there has been no step
  double shortest_ = 0, longest_ = 0;
  int cuts_ = 0;  ///< of a step to a given t
  int steps_ = 0;
  double tried_ = 0;
  double reached_ = 0;         ///< mean displacement of the set of `until`
  bool landed_ = false;        ///< the last attempt ends the run
  bool missed_until_ = false;  ///< the last attempt lands at steps.end, though the deck has an arc_length.until
  bool ended_ = false;
  bool indefinite_ = false;  ///< as last noted
};

}  // namespace perinox::equilibrium
