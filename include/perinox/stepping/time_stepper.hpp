#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "perinox/core/record.hpp"
#include "perinox/fracture/bond_breaking.hpp"
#include "perinox/mechanics/point_fields.hpp"
#include "perinox/motion/explicit_motion.hpp"
#include "perinox/stepping/step_records.hpp"
#include "perinox/stepping/validity.hpp"

namespace perinox::stepping {

/// What a run in time takes: for `perinox check` and for the log.
struct TimeStepPlan {
  double stable = 0;         ///< largest stable time step, 2/omega_max
  double length = 0;         ///< of the time steps: at most the deck's time_step, or safety times the stable one
  long long time_steps = 0;  ///< of the whole run, as long as the stable one does not change
  std::string remark;        ///< a sentence where the deck's time_step is above the stable one; else empty
};

/// Drives a scene of dynamics: explicit from t = 0 to steps.end. Rows fall on their times end * k/count exactly: the
/// time between two rows is cut into time steps of equal length. The stable time step is estimated at the start, and
/// again at the first row after every thousand time steps, because bonds that turn and stretch change it.
class TimeStepper {
 public:
  /// Collective. Throws InputError for a scene that cannot be run.
  TimeStepper(const deck::Deck& deck, mechanics::Scene& scene);

  /// Collective; costs an estimate the first time.
  TimeStepPlan plan();
  /// Runs to the end. Throws RunError if the energies grow without bound or are not finite; every row before has been
  /// handed to the observer. The state is worthless then, so the observer is given no last one.
  void run(Observer& observer);

  /// Called after the observer has been told of a row, on every rank; a RunError it throws ends the run there.
  using Told = std::function<void(const StepRecord& record)>;
  void on_commit(Told callback) { told_ = std::move(callback); }

  /// Called every few time steps within a row, on every rank: rows written so far, t at hand. A RunError it throws ends
  /// the run there.
  using Passing = std::function<void(int step, double t)>;
  void on_passing(Passing callback) { passing_ = std::move(callback); }

  /// Everything run() goes on from, in a callback, and the way back, before run(). Restored on as many ranks, the run
  /// goes on to the last bit as it would have. Collective.
  void save(StateWriter& writer) const;
  void restore(StateReader& reader);

  const loads::Boundary& boundary() const { return boundary_; }
  motion::ExplicitMotion& motion() { return *motion_; }
  /// At the end of the run.
  const Validity* validity() const { return &validity_; }
  const motion::MotionEnergies& energies() const { return energies_; }
  /// Energy gained without anybody's work, over the largest energy of the run so far; a body that only moves has at
  /// least that of energy_scale.hpp.
  double unaccounted() const { return energy_scale_ > 0 ? energies_.gain() / energy_scale_ : 0; }
  /// The largest size of it at any row.
  double worst_gain() const { return worst_gain_; }

 private:
  void make_motion();
  double time_step();
  void begin_row(double t);
  /// Step 0.
  void tell_start(Observer& observer);
  bool advance_to(double t, Observer& observer);
  StepRecord record(bool written, bool last);
  [[noreturn]] void stop(Observer& observer);

  const deck::Deck& deck_;
  mechanics::Scene& scene_;
  loads::Boundary boundary_;
  std::shared_ptr<mechanics::Evaluation> evaluation_;  ///< of the scene: the motion and the breaking of bonds share it
  std::optional<motion::ExplicitMotion> motion_;
  std::unique_ptr<fracture::BondBreaking> breaking_;  ///< where bonds can break
  StepRecords records_;
  mechanics::PointFields fields_;
  Validity validity_;
  motion::MotionEnergies energies_;
  double worst_gain_ = 0, energy_scale_ = 0;
  double length_ = 0;        ///< of a time step in the last row
  long long estimated_ = 0;  ///< time steps done at the last estimate
  int row_ = 0;              ///< rows done of the deck's
  bool restored_ = false;
  int step_ = 0;  ///< rows written: others, where a restart has changed their number
  // Of the row at hand.
  long long row_done_ = 0, row_count_ = 0;  ///< time steps; done: 0 between rows
  double row_end_ = 0;                      ///< t
  double row_longest_ = 0;                  ///< that a time step could be
  double row_begin_ = 0;                    ///< moment; a restart within the row counts what came before
  double row_seconds_ = 0;                  ///< before a restart within it
  Told told_;
  Passing passing_;
};

}  // namespace perinox::stepping
