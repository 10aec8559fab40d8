/// Random scenes are described in other ways that must not matter (variants.hpp), restarted, and run on 1 to 4 ranks.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "variants.hpp"
#include "workshop.hpp"

namespace perinox::invariance {
namespace {

/// Numbers of two scenes of each sort, or of all; PERINOX_INVARIANCE_SCENES="7 17 27" asks for some.
std::vector<int> numbers() {
  std::vector<int> wanted;
  if (const char* list = std::getenv("PERINOX_INVARIANCE_SCENES")) {
    std::istringstream words(list);
    for (int number; words >> number;) wanted.push_back(number);
    return wanted;
  }
  const int count = everything() ? random_scene_count : 2 * random_scene_sorts;
  for (int number = 0; number < count; ++number) wanted.push_back(number);
  return wanted;
}

std::vector<Variant> variants_of(const RandomScene& scene, const Answer& base, const std::string& folder, int number) {
  Lot lot(static_cast<unsigned>(5000 + number));
  const DeckText deck{scene.yaml, folder};
  const std::string prefix = folder + "/other";
  const Extent extent = extent_of(base);
  std::vector<Variant> all = frames(deck, extent, base.dimension, lot, prefix);
  all.push_back(with_far_body(deck, extent, base.spacing, false, lot, prefix));
  all.push_back(with_far_body(deck, extent, base.spacing, true, lot, prefix));
  if (scene.clouds) all.push_back(turned(deck, base.dimension, lot, prefix));
  if (const auto variant = permuted(deck, lot, prefix)) all.push_back(*variant);
  if (const auto variant = reordered(deck)) all.push_back(*variant);
  if (scene.elastic) {
    all.push_back(with_more_steps(deck, scene.small));
    all.push_back(through_zero(deck));
  }
  all.insert(all.end(), scene.variants.begin(), scene.variants.end());
  for (Variant& variant : all)
    if (scene.round && variant.kind == "axes exchanged") variant.kind += ", round bodies";
  return all;
}

TEST(RandomScenes, NothingElseMatters) {
  const std::vector<int> wanted = numbers();
  const int ranks = ranks_of_world(), rank = rank_of_world();
  Ledger ledger;
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    if (static_cast<int>(k) % ranks != rank) continue;
    const WorkFolder folder;
    const RandomScene scene = random_scene(wanted[k], folder.path());
    const Answer base = answer_of(scene.yaml, folder.path(), MPI_COMM_SELF);
    EXPECT_EQ(base.refused, "") << scene.name << "\n" << scene.yaml;
    EXPECT_EQ(base.stopped, "") << scene.name << "\n" << scene.yaml;
    if (!base.refused.empty() || !base.stopped.empty()) continue;
    for (const Variant& variant : variants_of(scene, base, folder.path(), wanted[k]))
      compare(ledger, scene.name, base, variant, folder.path());
    compare_restarts(ledger, scene.name, scene.yaml, folder.path());
  }
  ledger.judge("random scenes");
}

TEST(RandomScenes, OneToFourRanks) {
  const std::vector<int> wanted = numbers();
  Ledger ledger;
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    const int first = static_cast<int>(k) % ranks_of_world();
    const WorkFolder folder;
    RandomScene scene = random_scene(wanted[k], folder.path());
    Answer base = answer_of(scene.yaml, folder.path(), MPI_COMM_SELF);
    if (k % 2 == 1) {  // with another body that some rank has to itself
      Lot lot(static_cast<unsigned>(9000 + wanted[k]));
      const DeckText deck{scene.yaml, folder.path()};
      scene.yaml = with_far_body(deck, extent_of(base), base.spacing, false, lot, folder.path() + "/far").yaml;
      base = answer_of(scene.yaml, folder.path(), MPI_COMM_SELF);
    }
    compare_ranks(ledger, scene.name, base, scene.yaml, folder.path(), first);
  }
  if (ranks_of_world() > 1) ledger.judge("random scenes on several ranks");
}

}  // namespace
}  // namespace perinox::invariance
