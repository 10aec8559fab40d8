#pragma once
#include <memory>
#include <string>

#include "perinox/body/body.hpp"
#include "perinox/core/record.hpp"
#include "perinox/deck/deck.hpp"

namespace perinox::output {

/// Writes everything that a run leaves in its directory: results.h5 and results.xdmf, history.csv, convergence.csv and
/// deck.resolved.yaml. It prints the Newton table and progress on standard output unless it is quiet. Warnings go to
/// standard error even if it is quiet.
class RunWriter : public Observer {
 public:
  /// Creates the directory. Results that it already holds are moved into its folder previous-<N>, and one line says so.
  /// Collective. Throws InputError if the directory cannot be used, RunError if a file cannot be created.
  RunWriter(const deck::Deck& deck, const body::Body& body, std::string directory, bool quiet);

  /// How far the files of an earlier run are kept, as its checkpoint says.
  struct Continuation {
    int step = 0;
    long long history_bytes = 0;
    long long convergence_bytes = 0;
    int phases = 0;   ///< phases in time that are over
    int attempt = 0;  ///< attempt at the step after `step` if it has begun, from 1; 0: it has not
  };
  /// Goes on with the files of the directory behind a committed step. Later rows and steps are dropped. A file with
  /// which the run cannot go on (lost, damaged, with other columns) is moved into previous-<N>, which one line says,
  /// and begun anew.
  RunWriter(const deck::Deck& deck, const body::Body& body, std::string directory, bool quiet,
            const Continuation& from);
  ~RunWriter() override;

  void newton_iteration(const NewtonIteration& row) override;
  void step_rejected(double t_from, double t_to, const std::string& reason) override;
  void bonds_broken(const BreakingPass& pass) override;
  void phase_begins(const MotionPhase& phase) override;
  /// Writes the phase to results.h5, which has every phase.
  void phase_ended(const MotionPhase& phase) override;
  void moves(const MotionMoment& moment) override;
  void note(const std::string& sentence) override;
  /// Writes the row and the group of step 0.
  void run_begins(const StepRecord& record) override;
  /// Writes a step. history.csv has every step. results.h5 has every deck.output.every-th step and the last one, with
  /// displacement, force and the fields of deck.output.fields that the scene carries. Collective. Throws RunError if
  /// the disk refuses.
  void step_committed(const StepRecord& record) override;
  /// Brings all files to the disk. step: the last committed one. Returns the lengths of the tables, the same on every
  /// rank. Collective. Throws RunError.
  Continuation sync(int step);
  /// Writes to results.h5 the last converged step if `every` has left it out, or the state that has lost its
  /// equilibrium, which is one step further.
  void run_stopped(const StepRecord* last) override;

 private:
  struct Files;
  void begin(const deck::Deck& deck, const body::Body& body, bool quiet, const Continuation* from);
  /// Writes the row, and the step if it is one of those that results.h5 has.
  void write(const StepRecord& record);
  std::unique_ptr<Files> files_;
};

}  // namespace perinox::output
