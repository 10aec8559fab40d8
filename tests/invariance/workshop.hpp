#pragma once
/// Runs scenes: folders for their files, the comparisons of one scene, and the ranks that share the work.
#include <mpi.h>

#include <functional>
#include <string>

#include "ledger.hpp"
#include "random_scenes.hpp"

namespace perinox::invariance {

/// A folder of this rank that is gone at the end.
class WorkFolder {
 public:
  WorkFolder();
  ~WorkFolder();
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

int rank_of_world();
int ranks_of_world();

/// Runs a variant on this rank alone and notes how far its answer is from that of the scene.
void compare(Ledger& ledger, const std::string& scene, const Answer& base, const Variant& variant,
             const std::string& folder);

/// Runs the scene with a checkpoint after every step, goes on from each of them, and notes how far the ends are apart.
void compare_restarts(Ledger& ledger, const std::string& scene, const std::string& yaml, const std::string& folder);

/// Runs the scene on 2, 3 and 4 ranks, as far as there are, beginning with rank `first`. `base` is its answer on one
/// rank. Collective over all ranks of the program.
void compare_ranks(Ledger& ledger, const std::string& scene, const Answer& base, const std::string& yaml,
                   const std::string& folder, int first);

}  // namespace perinox::invariance
