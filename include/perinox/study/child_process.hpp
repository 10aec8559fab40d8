#pragma once
#include <string>
#include <vector>

namespace perinox::study {

/// What a run cost and how it ended.
struct Outcome {
  int status = 0;          ///< exit status; 128 + number of the signal that ended it
  double cpu_seconds = 0;  ///< user and system time of all ranks
  double wall_seconds = 0;
  double peak_megabytes = 0;  ///< of the largest process, resident
};

/// Runs `command`, found through PATH, and waits for it. It reads nothing, writes to the two files, has no trace of an
/// MPI that this program was started under, and is ended if this program is. Throws RunError if it cannot be started.
Outcome run_child(const std::vector<std::string>& command, const std::string& output_file,
                  const std::string& error_file);

/// Command that starts the program on `ranks` ranks; on one without mpirun.
std::vector<std::string> on_ranks(int ranks, const std::vector<std::string>& command);

/// Number of ranks that the environment says this program is one of; 1 without mpirun.
int ranks_around();
/// True if this program is the first of them.
bool first_rank_around();

/// Path of the running program.
std::string own_path();

}  // namespace perinox::study
