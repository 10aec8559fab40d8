/// Tests the decks of inputs/ in other frames, units and orders, with a body far away, restarted, and on 1 to 4 ranks.
/// Decks in which bonds break are run up to the step before the first one does, because what breaks next may depend on
/// rounding.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>

#include "shipped_decks.hpp"
#include "variants.hpp"
#include "workshop.hpp"

namespace perinox::invariance {
namespace {

/// The normal test run takes the first steps of the decks that are done in a few seconds.
/// PERINOX_INVARIANCE_DECKS="cyclic_cube l_panel" asks for some decks, PERINOX_INVARIANCE_STEPS=5 for a number of
/// steps.
constexpr int sample_steps = 2;
const std::vector<std::string> long_ones{"branching_plate",  "cracked_block", "fragmenting_ring",
                                         "kalthoff_winkler", "tension_block", "thick_sphere"};

std::vector<std::string> sample() {
  std::vector<std::string> names;
  for (const std::string& name : shipped_names())
    if (std::find(long_ones.begin(), long_ones.end(), name) == long_ones.end()) names.push_back(name);
  return names;
}

std::vector<std::string> wanted() {
  if (const char* list = std::getenv("PERINOX_INVARIANCE_DECKS")) {
    std::vector<std::string> names;
    std::istringstream words(list);
    for (std::string name; words >> name;) names.push_back(name);
    return names;
  }
  return everything() ? shipped_names() : sample();
}

int most_steps() {
  if (const char* steps = std::getenv("PERINOX_INVARIANCE_STEPS")) return std::atoi(steps);
  return everything() ? 1000000 : sample_steps;
}

/// A deck, shortened so that no bond breaks in it, and its answer.
struct Calm {
  DeckText deck;
  Answer answer;
  bool any = false;  ///< false: the first step breaks bonds already
};

Calm calm(const std::string& name) {
  Calm made{shipped(name), {}};
  made.deck.yaml = shortened(made.deck.yaml, most_steps());
  made.answer = answer_of(made.deck.yaml, made.deck.folder, MPI_COMM_SELF);
  const auto& rows = made.answer.rows;
  const auto first =
      std::find_if(rows.begin(), rows.end(), [](const Answer::Row& row) { return row.broken_bonds > 0; });
  made.any = first != rows.begin() || rows.empty();
  if (first == rows.end() || !made.any) return made;
  made.deck.yaml = shortened(made.deck.yaml, static_cast<int>(first - rows.begin()));
  made.answer = answer_of(made.deck.yaml, made.deck.folder, MPI_COMM_SELF);
  return made;
}

std::vector<Variant> variants_of(const Calm& base, const std::string& folder) {
  Lot lot(77);
  const std::string prefix = folder + "/other";
  const Extent extent = extent_of(base.answer);
  std::vector<Variant> all = frames(base.deck, extent, base.answer.dimension, lot, prefix);
  all.push_back(with_far_body(base.deck, extent, base.answer.spacing, false, lot, prefix));
  all.push_back(with_far_body(base.deck, extent, base.answer.spacing, true, lot, prefix));
  if (!names_particles(base.deck.yaml))
    if (const auto variant = permuted(base.deck, lot, prefix)) all.push_back(*variant);
  if (const auto variant = reordered(base.deck)) all.push_back(*variant);
  const auto names = [&](const char* shape) { return base.deck.yaml.find(shape) != std::string::npos; };
  for (Variant& variant : all) {
    if (variant.kind == "axes exchanged" && (names("sphere:") || names("cylinder:") || names("plate_with_hole:")))
      variant.kind += ", round bodies";
    if (variant.kind == "moved by 1e5 body lengths" && names("contact:")) variant.kind += ", contact";
  }
  return all;
}

TEST(ShippedDecks, NothingElseMatters) {
  const std::vector<std::string> names = wanted();
  Ledger ledger;
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (static_cast<int>(k) % ranks_of_world() != rank_of_world()) continue;
    const WorkFolder folder;
    const Calm base = calm(names[k]);
    EXPECT_EQ(base.answer.refused, "") << names[k];
    if (!base.any || !base.answer.refused.empty()) continue;
    for (const Variant& variant : variants_of(base, folder.path()))
      compare(ledger, names[k], base.answer, variant, base.deck.folder);
  }
  ledger.judge("shipped decks");
}

TEST(ShippedDecks, RestartAfterEveryStep) {
  const std::vector<std::string> names = wanted();
  Ledger ledger;
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (static_cast<int>(k) % ranks_of_world() != rank_of_world()) continue;
    const DeckText deck = shipped(names[k]);
    if (follows_a_path(deck.yaml)) continue;  // it writes no checkpoint (docs/restart.md)
    // This takes one step more than the sample has, so that there are two to go on from.
    compare_restarts(ledger, names[k], shortened(deck.yaml, most_steps() + 1), deck.folder);
  }
  ledger.judge("shipped decks");
}

TEST(ShippedDecks, OneToFourRanks) {
  const std::vector<std::string> names = wanted();
  Ledger ledger;
  for (std::size_t k = 0; k < names.size(); ++k) {
    const int first = static_cast<int>(k) % ranks_of_world();
    int steps = 0;
    Calm base;
    if (first == rank_of_world()) {
      base = calm(names[k]);
      steps = base.any ? std::max(1, steps_of(base.deck.yaml)) : 0;
    }
    MPI_Bcast(&steps, 1, MPI_INT, first, MPI_COMM_WORLD);
    if (steps == 0) continue;
    const DeckText deck = shipped(names[k]);
    const std::string yaml = shortened(shortened(deck.yaml, most_steps()), steps);
    compare_ranks(ledger, names[k], base.answer, yaml, deck.folder, first);
  }
  if (ranks_of_world() > 1) ledger.judge("shipped decks on several ranks");
}

}  // namespace
}  // namespace perinox::invariance
