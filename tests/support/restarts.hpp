#pragma once
/// Runs that leave a checkpoint after every step, and runs that go on from one.
#include <unistd.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "perinox/output/checkpoint.hpp"
#include "support/runs.hpp"

namespace perinox::testing {

/// A folder for checkpoints, the same on all ranks of a communicator, gone at the end.
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
  const std::string& path() const { return path_; }

 private:
  Communicator ranks_;
  std::string path_;
};

/// A run from the start (restart empty) or from a checkpoint; with a folder, a checkpoint of every step is left in it.
inline RunResult run_with_checkpoints(const deck::Deck& deck, MPI_Comm comm, const std::string& restart,
                                      const CheckpointFolder* folder) {
  const Communicator ranks(comm);
  mechanics::Scene scene = mechanics::build_scene(deck, ranks);
  solve::LoadStepper stepper(deck, scene);
  if (!restart.empty()) {
    output::read_checkpoint_head(restart, ranks);
    output::CheckpointReader reader(restart, scene.body());
    stepper.restore(reader);
  }
  stepper.on_commit([&](const solve::StepRecord& record) {
    if (folder == nullptr) return;
    output::CheckpointWriter writer(folder->of_step(record.step), scene.body());
    writer.write({record.step, record.t}, [&](StateWriter& to) { stepper.save(to); });
  });
  RunResult run;
  try {
    stepper.run(run.records);
  } catch (const RunError& error) {
    run.stopped = error.what();
  }
  const int d = scene.dimension();
  for (LocalIndex i = 0; i < scene.owned(); ++i)
    for (int c = 0; c < d; ++c) {
      const auto u = static_cast<std::size_t>(i) * d + c;
      run.displacement[scene.body().id[i]].push_back(stepper.committed().displacement()[u]);
      run.force[scene.body().id[i]].push_back(stepper.force()[u]);
    }
  run.energies = stepper.energies();
  return run;
}

/// The numbers of a step's row that a restart must give again.
inline std::vector<double> numbers_of(const solve::StepRecord& row) {
  std::vector<double> all{static_cast<double>(row.step),
                          row.t,
                          row.stored_energy,
                          row.dissipated_energy,
                          row.external_work,
                          static_cast<double>(row.newton_iterations),
                          static_cast<double>(row.linear_iterations)};
  all.insert(all.end(), row.history.begin(), row.history.end());
  return all;
}

/// The largest difference of two runs' rows from `first_step` on, iteration counts left out, relative to the largest
/// value in the column.
inline double history_difference(const RunResult& whole, const RunResult& part, int first_step) {
  if (static_cast<std::size_t>(first_step) - 1 + part.records.steps.size() != whole.records.steps.size()) return 1;
  const auto values = [](const solve::StepRecord& row) {
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

}  // namespace perinox::testing
