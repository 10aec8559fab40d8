#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "perinox/core/profile.hpp"
#include "perinox/core/record.hpp"
#include "perinox/deck/deck.hpp"
#include "perinox/equilibrium/newton.hpp"
#include "perinox/equilibrium/step_control.hpp"
#include "perinox/fracture/bond_breaking.hpp"
#include "perinox/loads/boundary.hpp"
#include "perinox/mechanics/peridynamic_medium.hpp"
#include "perinox/stepping/energies.hpp"
#include "perinox/stepping/hand_over.hpp"
#include "perinox/stepping/step_records.hpp"
#include "perinox/stepping/validity.hpp"

namespace perinox::stepping {

/// Drives a medium from t = 0 to its end, in load steps or along an arc (step_control.hpp). The only place where a
/// trial state becomes the committed one: after convergence. A failed step is halved, and grown again after a success.
class LoadStepper {
 public:
  /// The medium is kept by reference. Collective. Throws InputError for a deck that cannot be run, and std::logic_error
  /// where bonds may break or the run may go on in time and the medium is not a peridynamic one.
  LoadStepper(const deck::Deck& deck, medium::Medium& medium);
  /// Makes the medium of a scene at t = 0.
  LoadStepper(const deck::Deck& deck, mechanics::Scene& scene);

  /// Runs to the end. Throws RunError with the reason if it cannot go on; every step committed before has been handed
  /// to the observer.
  void run(Observer& observer);

  /// Called when a step has converged, before the medium commits its state under trial (`perinox verify`).
  using Converged = std::function<void()>;
  void on_convergence(Converged callback) { converged_ = std::move(callback); }

  /// Called after the observer has been told of a committed step, on every rank; a RunError it throws ends the run
  /// there.
  using Told = std::function<void(const StepRecord& record)>;
  void on_commit(Told callback) { told_ = std::move(callback); }

  /// Called every few time steps while the run goes on in time within a load step, on every rank: steps committed so
  /// far, t at hand. A RunError it throws ends the run there.
  using Passing = std::function<void(int step, double t)>;
  void on_passing(Passing callback) { passing_ = std::move(callback); }

  /// Everything run() goes on from, in a callback, and the way back: restored on as many ranks, the run goes on to the
  /// last bit as it would have. restore() is called before run(). Collective.
  void save(StateWriter& writer) const;
  void restore(StateReader& reader);

  /// Called on every rank before the run stops because a step does not converge: the state is that of the last
  /// committed step, `last`, and what is saved now goes on with a whole step.
  void on_stop(Told callback) { stopped_ = std::move(callback); }

  const medium::Medium& medium() const { return medium_; }
  /// The committed state of a peridynamic medium. Throws std::logic_error for another one.
  const mechanics::Committed& committed() const;
  const loads::Boundary& boundary() const { return boundary_; }
  equilibrium::Newton& newton() { return newton_; }
  const Energies& energies() const { return energies_; }
  /// Null for a medium that is not peridynamic.
  const Validity* validity() const { return validity_.get(); }
  /// What load steps have not followed, for a warning at the end of a run; "": nothing.
  std::string jumps() const;
  /// StepControl::unreached() of a run that has come to its end.
  std::string unreached() const { return control_->unreached(); }
  /// Internal force at the committed state. [owned * dimension], force.
  const std::vector<double>& force() const { return force_; }

 private:
  LoadStepper(const deck::Deck& deck, std::unique_ptr<mechanics::PeridynamicMedium> own);
  std::unique_ptr<equilibrium::StepControl> make_control();
  void begin_step();
  /// Of the medium's state under trial. followed: equilibrium was kept on the way from the committed state, which flow
  /// may have bent.
  void commit(std::vector<double>&& force, bool followed = false);
  /// Energy that the given loads, held as they were, do over a step of load control whose supports do not move beyond
  /// what the body has taken up: above 0 it would go there by itself, so that it snaps. Collective.
  double set_free() const;
  /// t: to which the load step went; energy: lost on the way.
  void note_jump(double t, double energy);
  void raise_energy_scale();
  /// written: the fields that cost something are made too.
  StepRecord record(const equilibrium::NewtonResult& result, bool written);
  struct Loss {
    LostEquilibrium cause = LostEquilibrium::no;
    std::string reason;  ///< a sentence
  };
  /// Passes of bond breaking at the committed state's load, until no bond is critical or the equilibrium is lost; every
  /// pass before is committed.
  Loss break_bonds(Observer& observer, equilibrium::NewtonResult& total);
  /// Tells the observer and throws RunError with the reason.
  [[noreturn]] void lost_equilibrium(Observer& observer, const std::string& reason,
                                     const equilibrium::NewtonResult& result);
  /// Goes on in time with the loads going to `t` until the body is at rest and in equilibrium again; a reason, if that
  /// does not happen.
  std::string go_through_motion(Observer& observer, double t, const Loss& loss, equilibrium::NewtonResult& total);
  /// The same from within a phase.
  std::string finish_motion(Observer& observer, equilibrium::NewtonResult& total);
  /// patience: as in HandOver::begin.
  void begin_phase(Observer& observer, double t, const Loss& loss, double patience);
  /// One load step, or its rest after a restart within it; false if a smaller one is to be tried.
  bool advance(Observer& observer, equilibrium::NewtonResult& result);
  /// The bonds that are critical after an equilibrium, and what follows if there is none afterwards.
  void settle(Observer& observer, equilibrium::NewtonResult& result);
  /// Where a step fails at its smallest size: down in energy to the next stable equilibrium at load parameter t, and
  /// commits it. False, and the reason added to that of `result`, if there is none.
  bool go_down(Observer& observer, double t, equilibrium::NewtonResult& result);
  [[noreturn]] void stop(Observer& observer, double t, const equilibrium::NewtonResult& result);
  void save_fracture(StateWriter& writer) const;
  void save_phase(StateWriter& writer) const;
  void restore_phase(StateReader& reader);
  /// Broken bonds, loose particles, and Newton's solver made and restored at the crack that it knew.
  void restore_fracture(StateReader& reader);

  const deck::Deck& deck_;
  std::unique_ptr<mechanics::PeridynamicMedium> own_;  ///< where it was made here
  medium::Medium& medium_;
  mechanics::PeridynamicMedium* peridynamic_;  ///< the same, if it is one; else null
  const medium::Model& model_;
  loads::Boundary boundary_;
  equilibrium::Newton newton_;
  std::unique_ptr<fracture::BondBreaking> breaking_;  ///< where bonds can break
  std::unique_ptr<equilibrium::StepControl> control_;
  Energies energies_;
  std::vector<double> force_, external_;
  Converged converged_;
  StepRecords records_;
  std::unique_ptr<Validity> validity_;
  Told told_, stopped_;
  Passing passing_;
  int step_ = 0;
  bool restored_ = false;
  int passes_ = 0;               ///< of the step at hand
  double lost_by_snapping_ = 0;  ///< energy, in the step at hand
  struct Jumps {
    int count = 0;
    double first_t = 0, energy = 0;
  };
  Jumps jumps_;                          ///< to other equilibria since t = 0, without a phase in time
  std::optional<MotionRow> motion_;      ///< where the run may go on in time
  std::unique_ptr<HandOver> hand_over_;  ///< while the run goes on in time
  double passage_ = 0;                   ///< passage_time() before any bond broke
  long long bonds_ = 0;                  ///< moving_bonds() before any bond broke
  struct Phase {
    MotionPhase row;                  ///< number: phases so far
    equilibrium::NewtonResult total;  ///< of the step up to its beginning
    // Of the step before a restart within it.
    double seconds = 0;
    long long products = 0;
  };
  Phase phase_;
  double step_begin_ = 0;                  ///< moment; a restart within a step counts what came before
  ProfileReading told_times_;              ///< at the last record
  equilibrium::NewtonResult last_result_;  ///< of the committed step
};

}  // namespace perinox::stepping
