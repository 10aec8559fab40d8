#pragma once
/// Runs that leave a checkpoint after every step, and runs that go on from one.
#include <unistd.h>

#include <filesystem>
#include <functional>
#include <string>
#include <type_traits>
#include <vector>

#include "perinox/output/checkpoint.hpp"
#include "support/runs.hpp"

namespace perinox::test {

/// A folder for checkpoints. It is the same on all ranks of a communicator and is gone at the end.
class CheckpointFolder {
 public:
  explicit CheckpointFolder(const Communicator& ranks) : ranks_(ranks) {
    static int count = 0;
    int words[2] = {static_cast<int>(::getpid()), count++};
    MPI_Bcast(words, 2, MPI_INT, 0, ranks.mpi());
    path_ = (std::filesystem::temp_directory_path() / fmt::format("perinox_checkpoints_{}_{}", words[0], words[1]))
                .string();
    if (ranks.is_root()) std::filesystem::create_directories(path_);
    ranks.barrier();
  }
  ~CheckpointFolder() {
    ranks_.barrier();
    std::error_code ignored;
    if (ranks_.is_root()) std::filesystem::remove_all(path_, ignored);
  }
  CheckpointFolder(const CheckpointFolder&) = delete;
  CheckpointFolder& operator=(const CheckpointFolder&) = delete;
  std::string of_step(int step) const { return fmt::format("{}/{}.h5", path_, step); }
  /// Path of a checkpoint within a step. They are numbered in their order; `passes` has the last step committed before
  /// each.
  std::string of_pass(int number) const { return fmt::format("{}/within_{}.h5", path_, number); }
  mutable std::vector<int> passes;
  const std::string& path() const { return path_; }

 private:
  Communicator ranks_;
  std::string path_;
};

/// Runs a stepper from the start or from a checkpoint. If there is a folder it leaves checkpoints in it: one of every
/// step, and one of every third moment within a step at which there may be one.
template <class Stepper>
RunResult run_stepper(Stepper& stepper, const mechanics::Scene& scene, const std::string& restart,
                      const CheckpointFolder* folder) {
  if (!restart.empty()) {
    output::read_checkpoint_head(restart, scene.body().communicator);
    output::CheckpointReader reader(restart, scene.body());
    stepper.restore(reader);
  }
  const auto leave = [&](const std::string& path, int step, double t) {
    output::CheckpointWriter writer(path, scene.body());
    writer.write({step, t}, [&](StateWriter& to) { stepper.save(to); });
  };
  int moments = 0;
  if (folder != nullptr) {
    stepper.on_commit([&](const StepRecord& record) { leave(folder->of_step(record.step), record.step, record.t); });
    stepper.on_passing([&](int step, double t) {
      if (moments++ % 3 != 1) return;
      leave(folder->of_pass(static_cast<int>(folder->passes.size())), step, t);
      folder->passes.push_back(step);
    });
  }
  return run_with(stepper);
}

/// Makes a run from the start (restart empty) or from a checkpoint. If there is a folder, checkpoints are left in it.
inline RunResult run_with_checkpoints(const deck::Deck& deck, MPI_Comm comm, const std::string& restart,
                                      const CheckpointFolder* folder) {
  mechanics::Scene scene = mechanics::build_scene(deck, Communicator(comm));
  if (deck.dynamics == deck::Dynamics::explicit_) {
    stepping::TimeStepper stepper(deck, scene);
    RunResult run = run_stepper(stepper, scene, restart, folder);
    keep(scene, stepper.motion().committed().displacement(), stepper.motion().force(), run);
    run.motion = stepper.energies();
    return run;
  }
  stepping::LoadStepper stepper(deck, scene);
  RunResult run = run_stepper(stepper, scene, restart, folder);
  keep(scene, stepper.committed().displacement(), stepper.force(), run);
  run.energies = stepper.energies();
  return run;
}

/// The numbers of a step's row that a restart must reproduce.
inline std::vector<double> numbers_of(const StepRecord& row) {
  std::vector<double> all{static_cast<double>(row.step),
                          row.t,
                          row.stored_energy,
                          row.dissipated_energy,
                          row.external_work,
                          static_cast<double>(row.newton_iterations),
                          static_cast<double>(row.linear_iterations)};
  all.insert(all.end(), row.history.begin(), row.history.end());
  if (row.fracture)
    all.insert(all.end(), {static_cast<double>(row.fracture->passes), static_cast<double>(row.fracture->broken_bonds),
                           row.fracture->released_energy, row.fracture->relaxed_energy});
  if (row.motion)
    all.insert(all.end(),
               {row.motion->time, static_cast<double>(row.motion->time_steps), row.motion->kinetic_energy,
                row.motion->damped_energy, row.motion->contact_energy, static_cast<double>(row.motion->phases),
                static_cast<double>(row.motion->cause), row.motion->phase_time, row.motion->phase_energy});
  return all;
}

/// The largest difference of two runs' rows from `first_step` on, without iteration counts, relative to the largest
/// value in the column.
inline double history_difference(const RunResult& whole, const RunResult& part, int first_step) {
  if (static_cast<std::size_t>(first_step) - 1 + part.records.steps.size() != whole.records.steps.size()) return 1;
  const auto values = [](const StepRecord& row) {
    std::vector<double> all = numbers_of(row);
    all.erase(all.begin() + 5, all.begin() + 7);
    return all;
  };
  std::vector<double> scale = values(whole.records.steps.front());
  for (const auto& row : whole.records.steps) {
    const std::vector<double> numbers = values(row);
    for (std::size_t k = 0; k < scale.size(); ++k) scale[k] = std::max(std::abs(scale[k]), std::abs(numbers[k]));
  }
  double largest = 0;
  for (std::size_t s = 0; s < part.records.steps.size(); ++s) {
    const std::vector<double> a = values(part.records.steps[s]);
    const std::vector<double> b = values(whole.records.steps[static_cast<std::size_t>(first_step) - 1 + s]);
    for (std::size_t k = 0; k < a.size(); ++k)
      if (scale[k] > 0) largest = std::max(largest, std::abs(a[k] - b[k]) / scale[k]);
  }
  return largest;
}

/// Breaks a run off after every step, and once within each step that goes through time. It goes on every time from its
/// own checkpoint in a program that knows nothing else. pieces: the number of parts.
template <class Stepper>
RunResult run_in_pieces_of(const deck::Deck& deck, int& pieces) {
  const CheckpointFolder folder{Communicator(MPI_COMM_SELF)};
  const std::string file = folder.of_step(0);
  RunResult all;
  int within = 0;  // the step that has been broken off within
  for (pieces = 1;; ++pieces) {
    mechanics::Scene scene = mechanics::build_scene(deck, Communicator(MPI_COMM_SELF));
    Stepper stepper(deck, scene);
    if (pieces > 1) {
      output::read_checkpoint_head(file, scene.body().communicator);
      output::CheckpointReader reader(file, scene.body());
      stepper.restore(reader);
    }
    const auto leave = [&](int step, double t) {
      output::CheckpointWriter writer(file, scene.body());
      writer.write({step, t}, [&](StateWriter& to) { stepper.save(to); });
      throw RunError("broken off");
    };
    stepper.on_commit([&](const StepRecord& record) {
      if (!record.last) leave(record.step, record.t);
    });
    int moments = 0;
    stepper.on_passing([&](int step, double t) {
      if (step + 1 == within || ++moments < 5) return;
      within = step + 1;
      leave(step, t);
    });
    const RunResult piece = run_with(stepper);
    all.records.steps.insert(all.records.steps.end(), piece.records.steps.begin(), piece.records.steps.end());
    if (piece.stopped == "broken off") continue;
    all.stopped = piece.stopped;
    if constexpr (std::is_same_v<Stepper, stepping::LoadStepper>)
      keep(scene, stepper.committed().displacement(), stepper.force(), all);
    else
      keep(scene, stepper.motion().committed().displacement(), stepper.motion().force(), all);
    return all;
  }
}

inline RunResult run_in_pieces(const deck::Deck& deck, int& pieces) {
  return deck.dynamics == deck::Dynamics::explicit_ ? run_in_pieces_of<stepping::TimeStepper>(deck, pieces)
                                                    : run_in_pieces_of<stepping::LoadStepper>(deck, pieces);
}

}  // namespace perinox::test
