#include <fmt/format.h>

#include "perinox/app/commands.hpp"
#include "perinox/app/scene_report.hpp"
#include "perinox/deck/read.hpp"
#include "perinox/solve/boundary.hpp"

namespace perinox::app {

int check(const Options& options, const Communicator& communicator) {
  const deck::Deck deck = read_deck(options, communicator);
  body::PartitionReport partition;
  const mechanics::Scene scene = mechanics::build_scene(deck, communicator, &partition);
  const solve::Boundary boundary(deck, scene);
  const SceneReport report = describe(deck, scene, partition);
  if (!communicator.is_root()) return 0;
  for (const std::string& remark : boundary.remarks()) fmt::print(stderr, "note: {}\n", remark);
  if (options.quiet) return 0;
  fmt::print("{}{}", report.summary, report.details);
  fmt::print("boundary\n  {} unknowns prescribed, {} free\n", boundary.prescribed_count(), boundary.free_count());
  fmt::print("\n# the resolved deck\n{}", deck::write_resolved(deck));
  fmt::print("# {} is a valid deck\n", options.deck);
  return 0;
}

}  // namespace perinox::app
