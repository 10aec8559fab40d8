#pragma once
#include <functional>
#include <optional>
#include <string>

#include "commands.hpp"
#include "perinox/core/record.hpp"
#include "perinox/deck/restart.hpp"
#include "perinox/output/checkpoint.hpp"
#include "perinox/output/run_writer.hpp"

namespace perinox::app {

/// The checkpoint from which a run goes on.
struct Restart {
  std::string file;
  std::string directory;  ///< directory that holds it
  output::CheckpointHead head;
};

/// File and directory of options.restart, which must not be empty. The head is not read yet.
Restart restart_of(const Options& options);

/// Reads the head of options.restart and compares its deck with this one. It is absent without --restart. Collective.
/// Throws InputError if the checkpoint is not whole, if keys differ that may not, or if the deck's files have other
/// contents.
std::optional<Restart> find_restart(const Options& options, const deck::Deck& deck, const Communicator& communicator);

/// Writes checkpoints as a run goes, and stops it between two steps, or time steps, when a signal has been noted or the
/// deck's time is nearly up.
class Checkpointing {
 public:
  /// `save` hands over everything that the run needs to go on. All other arguments are kept by reference. begin:
  /// seconds of the steady clock at which the run's time began.
  Checkpointing(const Options& options, const deck::Deck& deck, std::function<void(StateWriter&)> save,
                output::RunWriter& writer, const body::Body& body, const std::string& directory, double begin);

  /// To be called after every committed step. Collective. Throws RunError to stop the run.
  void committed(const StepRecord& record);

  /// To be called when the run is about to stop at a committed step. Collective. Throws RunError if a checkpoint cannot
  /// be written.
  void stopping(const StepRecord& last);

  /// To be called between time steps of a step that has not been committed. step: the last committed one. Collective.
  /// Throws RunError to stop the run.
  void passing(int step, double t);

  /// The command that goes on from the last checkpoint; "" if there is none.
  std::string resume_command() const;

 private:
  void write(int step, double t, bool within);
  /// True on all ranks if the last checkpoint is so old that it is worth writing another. Collective.
  bool late() const;
  /// The reason to stop now, or "". seconds: what must still fit into the deck's time. Collective.
  std::string reason_to_stop(double seconds) const;

  const Options& options_;
  const deck::Deck& deck_;
  std::function<void(StateWriter&)> save_;
  output::RunWriter& writer_;
  Communicator communicator_;
  deck::Checkpoints asked_;
  bool possible_;  ///< a checkpoint would hold everything
  std::string resolved_;
  std::string files_;  ///< contents of the deck's files at the start
  output::CheckpointWriter file_;
  double begin_, last_ = 0, last_pass_ = 0, last_write_ = 0;  ///< moments on the steady clock
  double longest_ = 0;       ///< longest time from one committed step to the next, of late
  double longest_pass_ = 0;  ///< longest time between time steps that are reported, of late
  double writing_ = 0;       ///< seconds that the last checkpoint took
  int count_ = 0;            ///< checkpoints written
  int last_step_ = -1;       ///< last step that was checkpointed between steps
};

}  // namespace perinox::app
