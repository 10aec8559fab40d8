#pragma once
/// Plain records of what a run tells the outside world. The solver hands them to an Observer and does not know who
/// listens.
#include <optional>
#include <string>
#include <vector>

#include "perinox/core/profile.hpp"

namespace perinox {

/// One row of the Newton table and of convergence.csv. Iteration 0 is the state that the step starts from.
struct NewtonIteration {
  int step = 0;
  double t = 0;
  int iteration = 0;
  double residual = 0;           ///< 2-norm of the out-of-balance force over the free unknowns
  double relative_residual = 0;  ///< residual over the reaction scale (docs/theory.md, section 10)
  double update = 0;             ///< 2-norm of this iteration's change of displacement; 0 in iteration 0
  double relative_update = 0;    ///< update over the 2-norm of the step's whole displacement increment
  int linear_iterations = 0;
  double forcing = 0;      ///< tolerance asked of the linear solve; 0 in iteration 0
  double step_length = 1;  ///< step length that the line search took
};

/// A field over the owned particles, in the body's own order.
struct Field {
  std::string name;
  int components = 1;              ///< 1; the body's dimension; 6: symmetric tensor xx xy xz yy yz zz
  const double* values = nullptr;  ///< [owned * components]
};

/// Numbers of a scene whose bonds can break. Bonds are counted once, not once a direction. All numbers except the
/// passes count from t = 0.
struct FractureRow {
  int passes = 0;  ///< passes of bond breaking in the step
  long long broken_bonds = 0;
  double released_energy = 0;  ///< stored energy that went with the bonds as they broke, at fixed deformation
  /// Energy lost on the way to the next equilibrium of the passes; it is in no kinetic energy.
  double relaxed_energy = 0;
  long long fragments = 0;         ///< pieces of more than one particle that chains of intact bonds hold together
  long long single_particles = 0;  ///< particles without a bond
};
/// Reason why a run left equilibrium and went on in time. The numbers are those of history.csv.
enum class LostEquilibrium {
  no = 0,
  newton = 1,          ///< no equilibrium at the smallest load step
  after_breaking = 2,  ///< no equilibrium once bonds have broken
  broken_share = 3,    ///< more bonds broken in a load step than hand_over.broken_share
  overload = 4,        ///< a bond beyond hand_over.overload: the crack runs
  passes = 5,          ///< bonds still break after fracture.max_passes
};
/// One phase of a run in time, between two equilibria.
struct MotionPhase {
  int number = 0;  ///< 1, 2, ... in the order of the run
  int step = 0;    ///< load step to which the phase belongs
  double t_begin = 0, t_end = 0;
  LostEquilibrium cause = LostEquilibrium::no;
  std::string reason;    ///< the cause as a sentence
  bool at_rest = false;  ///< false: the run stops here
  double time = 0;       ///< time that the phase took
  long long time_steps = 0;
  long long broken_bonds = 0;
  double external_work = 0, released_energy = 0, damped_energy = 0;
  double most_kinetic_energy = 0;
  double unaccounted_energy = 0;  ///< energy that the motion gained (negative: lost) without any work being done
  double unaccounted_share = 0;   ///< unaccounted energy over the largest energy in the balance
};

/// Numbers of a scene that moves in time or may come to do so.
struct MotionRow {
  double time = 0;  ///< since the start; with `dynamics: explicit` the same as t
  long long time_steps = 0;
  double kinetic_energy = 0;
  double damped_energy = 0;   ///< since t = 0
  double contact_energy = 0;  ///< energy stored in contacts
  // The following belong to this step's phases in time, in a run that is not explicit throughout.
  int phases = 0;
  LostEquilibrium cause = LostEquilibrium::no;  ///< cause of the first phase
  double phase_time = 0, phase_energy = 0;      ///< time that they took, and energy damped in them
};

/// Where a run that moves in time has got to, between two rows of the history or within a phase.
struct MotionMoment {
  double t = 0;
  double time = 0;  ///< of the phase, or since the start
  long long time_steps = 0;
  double kinetic_energy = 0, stored_energy = 0, damped_energy = 0;
  long long broken_bonds = 0;  ///< of the phase, or since the start
};

/// One pass of bond breaking at a fixed load.
struct BreakingPass {
  int step = 0;
  double t = 0;
  int pass = 0;            ///< 1, 2, ... at this load
  long long critical = 0;  ///< bonds at or above their limit
  long long broken = 0;    ///< critical bonds that broke in this pass
  double worst = 0;        ///< largest ratio of a bond's measure to its limit
};

/// One converged and committed step, or the state at the start. It is one row of history.csv and one group of
/// results.h5.
struct StepRecord {
  int step = 0;  ///< 1, 2, ...; 0: the start
  double t = 0;
  int newton_iterations = 0;
  int linear_iterations = 0;
  double stored_energy = 0;      ///< at the end of the step
  double dissipated_energy = 0;  ///< since t = 0
  double external_work = 0;      ///< since t = 0
  double seconds = 0;            ///< wall time of the step, its rejected attempts included
  /// Where the time went, section by section: counts of this rank, and the largest seconds over the ranks. It covers
  /// the time from one record to the next. `output` is therefore the time that the observers have taken since the last
  /// record, which is mostly for the step before this one: a step's own output is still to come when its record is
  /// made.
  ProfileReading profile;
  double remaining_seconds = 0;  ///< estimated wall time to the end of the run
  double end = 0;                ///< t at the end of the run
  std::optional<FractureRow> fracture;
  /// Depth to which faces have passed into each other; present where Deck::may_overlap().
  std::optional<double> overlap;
  std::optional<MotionRow> motion;
  std::vector<double> history;  ///< one value per deck.history entry
  std::vector<Field> fields;    ///< every field the scene carries; stress and strain are those of the last written step
  bool last = false;
};

/// Receives what happens in a run. The calls are collective: every rank gets every call, with the same scalars.
class Observer {
 public:
  virtual ~Observer() = default;
  virtual void newton_iteration(const NewtonIteration&) {}
  /// A step from `t_from` to `t_to` did not converge and will be tried again with a shorter one. `reason` is a
  /// sentence.
  virtual void step_rejected(double /*t_from*/, double /*t_to*/, const std::string& /*reason*/) {}
  /// Reports step 0, the state at t = 0: at rest, without displacement and before any load. In a run in time it has its
  /// initial velocities. A run that goes on from a checkpoint does not report it again.
  virtual void run_begins(const StepRecord&) {}
  virtual void step_committed(const StepRecord&) {}
  virtual void bonds_broken(const BreakingPass&) {}
  /// The run goes on in time from here. Only the fields up to `reason` are known yet.
  virtual void phase_begins(const MotionPhase&) {}
  virtual void phase_ended(const MotionPhase&) {}
  /// Called every few time steps of a motion.
  virtual void moves(const MotionMoment&) {}
  /// Receives a sentence for the log, for example about particles that have been taken out.
  virtual void note(const std::string& /*sentence*/) {}
  /// The run cannot go on. `last` is the last committed step once more, or null if there has been none. Where
  /// equilibrium is lost with bonds, it is the state in which it was lost, under the number of the step that did not
  /// come to its end.
  virtual void run_stopped(const StepRecord* /*last*/) {}
};

}  // namespace perinox
