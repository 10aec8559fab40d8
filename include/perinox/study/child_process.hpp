#pragma once
#include <string>
#include <vector>

namespace perinox::study {

/// The cost of a run and how it ended.
struct Outcome {
  int status = 0;          ///< exit status; 128 + number of the signal that ended it
  double cpu_seconds = 0;  ///< user and system time of all ranks
  double wall_seconds = 0;
  double peak_megabytes = 0;  ///< of the largest process, resident
};

/// Runs `command`, found through PATH, and waits for it. The process reads nothing, writes to the two files, has no
/// trace of an MPI under which this program was started, and is ended if this program is. Throws RunError if it cannot
/// be started.
Outcome run_child(const std::vector<std::string>& command, const std::string& output_file,
                  const std::string& error_file);

/// The command that starts the program on `ranks` ranks. On one rank it is without mpirun.
std::vector<std::string> on_ranks(int ranks, const std::vector<std::string>& command);

/// The number of ranks of which this program is one, as the environment says; 1 without mpirun.
int ranks_around();
/// True if this program is the first of these ranks.
bool first_rank_around();

/// Path of the running program.
std::string own_path();

}  // namespace perinox::study
