#include <fmt/format.h>

#include "perinox/app/commands.hpp"
#include "perinox/app/scene_report.hpp"
#include "perinox/deck/read.hpp"
#include "perinox/solve/boundary.hpp"

namespace perinox::app {

int check(const Options& options, const Communicator& communicator) {
  const Problem problem = prepare(options, communicator);
  const solve::Boundary boundary(problem.deck, problem.scene);
  say_remarks(boundary, communicator);
  if (!communicator.is_root() || options.quiet) return 0;
  fmt::print("{}{}", problem.report.summary, problem.report.details);
  fmt::print("boundary\n  {} unknowns prescribed, {} free\n", boundary.prescribed_count(), boundary.free_count());
  fmt::print("\n# the resolved deck\n{}", deck::write_resolved(problem.deck));
  fmt::print("# {} is a valid deck\n", options.deck);
  return 0;
}

}  // namespace perinox::app
