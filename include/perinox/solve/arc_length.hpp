#pragma once
#include <optional>

#include "perinox/solve/bordered_newton.hpp"
#include "perinox/solve/step_control.hpp"

namespace perinox::solve {

/// steps.control: arc-length. Follows the path of equilibria (u, t) wherever it goes: over limit points, where t turns
/// back, and along a plastic limit load. The first step goes to t = end/count and its displacement is the unit of the
/// arc; the last one lands on steps.end or on `until` exactly.
class ArcLength : public StepControl {
 public:
  /// Throws InputError: nothing to follow, because nothing is free or no load changes with t. Collective.
  ArcLength(const deck::Deck& deck, const mechanics::Scene& scene, const Boundary& boundary, Newton& newton);

  bool finished() const override { return ended_ || steps_ >= settings_.max_steps; }
  NewtonResult attempt(const mechanics::Committed& committed, int step, Observer& observer, mechanics::Trial& trial,
                       std::vector<double>& force) override;
  double tried() const override { return tried_; }
  void accept(const mechanics::Committed& committed, const mechanics::Trial& trial) override;
  bool cut() override;
  double share() const override;

 private:
  enum class End { none, load, displacement };
  PathPoint committed_point(const mechanics::Committed& committed) const;
  /// First guess of a step of the length arc_: the last increment again where that is nearly in balance, else along the
  /// tangent, in the direction that makes an acute angle with the last increment.
  NewtonResult predict(const mechanics::Committed& committed, const PathPoint& origin, PathPoint& guess);
  /// Share of the step from `origin` to `to` after which the run's end is passed; 1 and none if it is not.
  std::pair<double, End> passed(const PathPoint& origin, const PathPoint& to) const;

  const deck::Deck& deck_;
  const deck::ArcLength& settings_;
  const mechanics::Scene& scene_;
  Newton& newton_;  ///< of the first step
  BorderedNewton bordered_;
  PathNorm norm_;
  std::optional<FixedMean> until_;
  PathPoint last_increment_;
  PathPoint increment_;  ///< of the last attempt
  int iterations_ = 0;   ///< of the last attempt
  double first_load_;    ///< t of the first step
  double arc_ = 0;       ///< of the next step; 0: there has been no step
  double shortest_ = 0, longest_ = 0;
  int cuts_ = 0;  ///< of the first step
  int steps_ = 0;
  double tried_ = 0;
  double reached_ = 0;   ///< mean displacement of the set of `until`
  bool landed_ = false;  ///< the last attempt ends the run
  bool ended_ = false;
  bool indefinite_ = false;  ///< as last noted
};

}  // namespace perinox::solve
