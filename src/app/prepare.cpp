#include <fmt/format.h>

#include "perinox/deck/remarks.hpp"
#include "scene_report.hpp"

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

void say_remarks(const Problem& problem, const loads::Boundary& boundary, const Communicator& communicator) {
  if (!communicator.is_root()) return;
  std::vector<std::string> all = deck::remarks(problem.deck);
  for (const auto& material : problem.scene.materials())
    if (const std::string remark = material->remark(); !remark.empty()) all.push_back(remark);
  all.insert(all.end(), boundary.remarks().begin(), boundary.remarks().end());
  for (const std::string& remark : all) fmt::print(stderr, "note: {}\n", remark);
}

}  // namespace perinox::app
