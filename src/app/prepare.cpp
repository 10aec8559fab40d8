#include <fmt/format.h>

#include "perinox/app/scene_report.hpp"

namespace perinox::app {

Problem prepare(const Options& options, const Communicator& communicator) {
  return prepare(read_deck(options, communicator), communicator);
}

Problem prepare(deck::Deck deck, const Communicator& communicator) {
  body::PartitionReport partition;
  mechanics::Scene scene = mechanics::build_scene(deck, communicator, &partition);
  SceneReport report = describe(deck, scene, partition);
  return {std::move(deck), std::move(scene), std::move(report)};
}

void say_remarks(const solve::Boundary& boundary, const Communicator& communicator) {
  if (!communicator.is_root()) return;
  for (const std::string& remark : boundary.remarks()) fmt::print(stderr, "note: {}\n", remark);
}

}  // namespace perinox::app
