#pragma once
#include <string>

#include "commands.hpp"
#include "perinox/body/body.hpp"
#include "perinox/deck/deck.hpp"
#include "perinox/loads/boundary.hpp"
#include "perinox/mechanics/scene.hpp"

namespace perinox::app {

/// The scene in words. It is the same on every rank.
struct SceneReport {
  std::string summary;  ///< particles, bonds and partition, which `run` prints first
  std::string details;  ///< materials, sets, fields and terms carried, memory and cost, which `check` adds
};

/// Describes the scene. Collective.
SceneReport describe(const deck::Deck& deck, const mechanics::Scene& scene, const body::PartitionReport& partition);

/// What run, check and verify start from.
struct Problem {
  deck::Deck deck;
  mechanics::Scene scene;
  SceneReport report;
};

/// Reads the deck, builds the scene and describes it. Collective. Throws InputError.
Problem prepare(const Options& options, const Communicator& communicator);
Problem prepare(deck::Deck deck, const Communicator& communicator);

/// Prints the remarks on the deck, its materials and its boundary on rank 0, as notes on standard error, even if quiet.
void say_remarks(const Problem& problem, const loads::Boundary& boundary, const Communicator& communicator);

}  // namespace perinox::app
