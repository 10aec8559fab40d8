#include "perinox/study/study.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "commands.hpp"
#include "perinox/core/error.hpp"
#include "perinox/deck/declared.hpp"
#include "perinox/materials/material.hpp"
#include "perinox/study/child_process.hpp"

namespace perinox::app {

int study(study::Request request) {
  if (const int ranks = study::ranks_around(); ranks > 1)
    throw InputError(
        fmt::format("perinox study was started on {} ranks, but it runs on one and starts its runs by "
                    "itself; leave mpirun out, and sweep the key ranks to run decks on several",
                    ranks));
  if (request.output.empty())
    request.output =
        (std::filesystem::path("results") / "studies" / std::filesystem::path(request.file).stem()).string();
  return study::conduct(request, materials::full_schema());
}

int study_keys(const Communicator& communicator) {
  if (communicator.is_root()) fmt::print("{}", deck::key_table(study::declare_study()));
  return 0;
}

}  // namespace perinox::app
