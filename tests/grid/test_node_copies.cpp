/// A background grid copies its nodes where a crack parts the body.
#include <gtest/gtest.h>

#include <array>
#include <set>

#include "support/linear_problem.hpp"

namespace perinox::test {
namespace {

/// The background grid of a held cube of 12^3 particles, with cells of 3 x 3 x 3 particles.
struct Pieces {
  explicit Pieces(const std::string& more)
      : deck(deck_of(held_cube(12, 0.33, more))),
        scene(mechanics::build_scene(deck, Communicator(MPI_COMM_SELF))),
        prescribed(static_cast<std::size_t>(scene.local()) * 3, 0),
        grid(scene.body(), prescribed, scene.families().damage, scene.bond_graph(), 3.0) {}

  /// Nodes used by particles below, or above, half the height. It also checks that the functions sum to 1 at each of
  /// them.
  std::set<LocalIndex> nodes(bool above) const {
    std::set<LocalIndex> found;
    for (const grid::GridElement& element : grid.elements())
      for (LocalIndex k = element.begin; k < element.end; ++k) {
        const double* x = scene.body().position(grid.particle(k));
        std::array<double, 8> shape{};
        grid.shape_values(element, x, shape.data());
        double sum = 0;
        for (const double value : shape) sum += value;
        EXPECT_NEAR(sum, 1, 1e-14);
        if ((x[2] > 6) == above) found.insert(element.node.begin(), element.node.end());
      }
    return found;
  }
  std::vector<LocalIndex> shared() const {
    const std::set<LocalIndex> below = nodes(false), above = nodes(true);
    std::vector<LocalIndex> both;
    for (const LocalIndex node : below)
      if (above.count(node) > 0) both.push_back(node);
    return both;
  }

  deck::Deck deck;
  mechanics::Scene scene;
  std::vector<char> prescribed;
  grid::BackgroundGrid grid;
};

constexpr std::size_t full_grid = 5 * 5 * 5, plane = 5 * 5;

TEST(NodeCopies, UncutBodyHasOneCopyOfANode) {
  const Pieces pieces("");
  EXPECT_EQ(pieces.grid.node_ids().size(), full_grid);
  EXPECT_EQ(pieces.shared().size(), plane);
}

TEST(NodeCopies, CrackThroughTheBodySharesNoNode) {
  const Pieces pieces("cracks: [{rectangle: {corner: [-1, -1, 6.01], edge1: [14, 0, 0], edge2: [0, 14, 0]}}]\n");
  EXPECT_EQ(pieces.grid.node_ids().size(), full_grid + plane);
  EXPECT_TRUE(pieces.shared().empty());
}

TEST(NodeCopies, HalfACrackCopiesNodesOfItsPlaneOnly) {
  const Pieces pieces(half_crack(12));
  const std::size_t copies = pieces.grid.node_ids().size() - full_grid;
  EXPECT_GT(copies, 0u);
  EXPECT_LT(copies, plane);
  EXPECT_EQ(pieces.shared().size(), plane - copies);
  for (const LocalIndex node : pieces.shared())  // the crack ends at x = 6
    EXPECT_GE(pieces.grid.node_positions()[static_cast<std::size_t>(node) * 3], 3.0);
}

}  // namespace
}  // namespace perinox::test
