#pragma once
/// What a run tells the outside world: plain records, handed to an Observer. The solve room does not know who listens.
#include <optional>
#include <string>
#include <vector>

#include "perinox/core/profile.hpp"

namespace perinox::solve {

/// One row of the Newton table and of convergence.csv. Iteration 0 is the state the step starts from.
struct NewtonIteration {
  int step = 0;
  double t = 0;
  int iteration = 0;
  double residual = 0;           ///< 2-norm of the out-of-balance force over the free unknowns
  double relative_residual = 0;  ///< residual over the reaction scale
  double update = 0;             ///< 2-norm of this iteration's change of displacement; 0 in iteration 0
  double relative_update = 0;    ///< update over the 2-norm of the step's whole displacement increment
  int linear_iterations = 0;
  double forcing = 0;      ///< tolerance asked of the linear solve; 0 in iteration 0
  double step_length = 1;  ///< of the line search
};

/// A point field of the owned particles, in the body's own order.
struct Field {
  std::string name;
  int components = 1;              ///< 1; the body's dimension; 6: symmetric tensor xx xy xz yy yz zz
  const double* values = nullptr;  ///< [owned * components]
};

/// Of a scene whose bonds can break. Counts are of bonds, not of directed ones; since t = 0 but for the passes.
struct FractureRow {
  int passes = 0;  ///< of bond breaking in the step
  long long broken_bonds = 0;
  double released_energy = 0;  ///< stored energy that went with the bonds as they broke, the deformation held
  double relaxed_energy = 0;   ///< lost on the way to the next equilibrium of the passes: nobody's kinetic energy
};
/// Of a scene that moves in time or may come to.
struct MotionRow {
  double time = 0;  ///< since the start; with dynamics: explicit the same as t
  long long time_steps = 0;
  double kinetic_energy = 0;
  double damped_energy = 0;   ///< since t = 0
  double contact_energy = 0;  ///< stored in contacts
};

/// One pass of bond breaking.
struct BreakingPass {
  int step = 0;
  double t = 0;
  int pass = 0;            ///< 1, 2, ... at this load
  long long critical = 0;  ///< bonds at or above their limit
  long long broken = 0;    ///< of them, in this pass
  double worst = 0;        ///< largest ratio of a bond's measure to its limit
};

/// One converged and committed step: one row of history.csv, one group of results.h5.
struct StepRecord {
  int step = 0;  ///< 1, 2, ...
  double t = 0;
  int newton_iterations = 0;
  int linear_iterations = 0;
  double stored_energy = 0;      ///< at the end of the step
  double dissipated_energy = 0;  ///< since t = 0
  double external_work = 0;      ///< since t = 0
  double seconds = 0;            ///< wall time of the step, its rejected attempts included
  /// Where it went: counts of this rank, seconds the largest over the ranks, section by section. From one record to the
  /// next, so `output` is the time that the observers took since the last record: mostly for the step before this one,
  /// because a step's own output is still to come when its record is made.
  ProfileReading profile;
  double remaining_seconds = 0;  ///< estimate to the end
  double end = 0;                ///< t at the end of the run
  std::optional<FractureRow> fracture;
  std::optional<MotionRow> motion;
  std::vector<double> history;  ///< one value per deck.history entry
  std::vector<Field> fields;    ///< every field the scene carries; stress and strain of the last written step
  bool last = false;
};

/// Callbacks are collective: every rank gets every call, with the same scalars.
class Observer {
 public:
  virtual ~Observer() = default;
  virtual void newton_iteration(const NewtonIteration&) {}
  /// A step from `t_from` to `t_to` did not converge and will be tried again, shorter; `reason` is a sentence.
  virtual void step_rejected(double /*t_from*/, double /*t_to*/, const std::string& /*reason*/) {}
  virtual void step_committed(const StepRecord&) {}
  virtual void bonds_broken(const BreakingPass&) {}
  /// A sentence for the log: what has been taken out, why the run goes on in time, when it is at rest again.
  virtual void note(const std::string& /*sentence*/) {}
  /// The run cannot go on; `last` is the last committed step once more, if there has been one.
  virtual void run_stopped(const StepRecord* /*last*/) {}
};

}  // namespace perinox::solve
