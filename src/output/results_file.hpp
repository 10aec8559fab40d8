#pragma once
#include <string>
#include <vector>

#include "perinox/body/body.hpp"
#include "perinox/core/record.hpp"
#include "row_order.hpp"
#include "xdmf.hpp"

namespace perinox::output {

class ParallelFile;

/// Writes `results.h5`, by all ranks together (parallel HDF5), with rows in ascending particle id whatever the number
/// of ranks, and `results.xdmf` beside it. Each step opens the file, appends and closes it. Between steps the file on
/// disk is complete and readable, and a killed run leaves the steps before. The layout is in docs/results.md.
class ResultsFile {
 public:
  /// Creates the file (replacing one of that name) with the group /particles. block_names: names of the deck's bodies,
  /// in the order that body.part counts. steps_as_time: the time in results.xdmf is the number of the step, for a run
  /// in which t turns back. Collective. Throws RunError with path and reason.
  ResultsFile(std::string directory, const std::string& title, const std::vector<std::string>& block_names,
              const body::Body& body, bool steps_as_time = false);
  /// The last step and phase that are kept.
  struct Continue {
    int last_step = 0;
    int last_phase = 0;
  };
  /// Goes on with the file of an earlier run on the same particles. Later steps and phases are removed. fields: in the
  /// order in which results.xdmf shows them. Collective. Throws RunError if the file is not there, is damaged, or has
  /// another number of particles.
  ResultsFile(std::string directory, const std::string& title, const std::vector<std::string>& fields,
              const body::Body& body, Continue kept);

  /// Writes the group /steps/<record.step> with the attributes t, load (the same number), newton_iterations and
  /// linear_iterations and one dataset for each field: [n, 3] for vectors (2-D: third column zero), [n, 9] for tensors,
  /// [n] for scalars. The components of every tensor also become views /components/<record.step>/<field>_xx and so on.
  /// Collective. Throws RunError if the disk refuses; the room is reserved first, so that a full disk leaves the
  /// earlier steps whole.
  void write(const StepRecord& record, const std::vector<Field>& fields);

  /// Writes the group /phases/<phase.number>, which has attributes only: a phase in time of a run that lost its
  /// equilibrium. Collective. Throws RunError.
  void write(const MotionPhase& phase);

  /// Brings the file to the disk; rank 0 does the work. Collective. Throws RunError.
  void sync() const;
  const std::string& path() const { return path_; }

 private:
  /// The groups of the file that come after a step.
  struct Later {
    std::vector<long long> steps, phases;
  };
  /// On rank 0: fills the index with the steps that stay, and returns the others.
  Later look_back(Continue kept, const std::vector<std::string>& fields);
  /// Gives the components of a tensor of a step names of their own in `file`, and returns which ones.
  std::vector<std::string> name_components(ParallelFile& file, int step, const std::string& field) const;
  /// Reserves room for so many numbers at the end of a file. Throws RunError on every rank if there is none.
  void require_room(double numbers, const std::string& path) const;
  /// Path of the file to which a step is added: a copy, which rename_copy() puts in the place of the file, or the file.
  std::string copy_if_small() const;
  void rename_copy(const std::string& written) const;

  std::string directory_;
  std::string path_;
  Communicator communicator_;
  int dimension_ = 3;
  RowOrder order_;
  XdmfIndex index_;
  bool steps_as_time_ = false;
};

}  // namespace perinox::output
