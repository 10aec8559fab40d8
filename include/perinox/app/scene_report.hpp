#pragma once
#include <string>

#include "perinox/body/body.hpp"
#include "perinox/deck/deck.hpp"
#include "perinox/mechanics/scene.hpp"

namespace perinox::app {

/// The scene in words. The same on every rank.
struct SceneReport {
  std::string summary;  ///< particles, bonds, partition: what `run` prints first
  std::string details;  ///< materials, sets, fields and terms carried, memory and cost: what `check` adds
};

/// Collective.
SceneReport describe(const deck::Deck& deck, const mechanics::Scene& scene, const body::PartitionReport& partition);

}  // namespace perinox::app
