/// A bond that breaks on one rank is a new state of the bonds on all of them: otherwise one rank would take its strains
/// for known while the others exchange theirs.
#include <gtest/gtest.h>
#include <mpi.h>

#include <cmath>
#include <vector>

#include "perinox/mechanics/internal_force.hpp"
#include "support/runs.hpp"

namespace perinox::test {
namespace {

TEST(BrokenBondsRanks, ABreakOnOneRankIsANewStateOnAll) {
  const Communicator ranks(MPI_COMM_WORLD);
  const deck::Deck deck = deck_of(pulled_cube(6, 0.01, 1));
  mechanics::Scene scene = mechanics::build_scene(deck, ranks);
  const mechanics::Committed committed(scene);
  mechanics::Evaluation evaluation(scene);
  std::vector<double> u(scene.owned_unknowns()), before(u.size()), after(u.size());
  for (std::size_t k = 0; k < u.size(); ++k) u[k] = 1e-4 * scene.body().reference[k] * (k % 3 == 2 ? 1 : 0);
  const medium::At at = u.data();
  mechanics::Trial trial;
  mechanics::internal_force(evaluation, committed, at, trial, before.data());

  std::vector<mechanics::BondEnds> ends;
  if (ranks.is_root()) {
    std::vector<LocalIndex> neighbors;
    scene.bond_graph()(0, neighbors);
    for (const LocalIndex j : neighbors)
      if (ends.empty() && j < scene.owned()) ends.push_back({0, j});
    ASSERT_EQ(ends.size(), 1U);
  }
  const std::uint64_t version = scene.bonds_version();
  scene.break_bonds(ends);
  EXPECT_NE(scene.bonds_version(), version);
  if (ranks.any(scene.bonds_version() == version)) return;  // the next evaluation would wait for ever
  mechanics::internal_force(evaluation, committed, at, trial, after.data());
  double change = 0;
  for (std::size_t k = 0; k < u.size(); ++k) change = std::max(change, std::abs(after[k] - before[k]));
  EXPECT_GT(ranks.max(change), 0);
}

}  // namespace
}  // namespace perinox::test
