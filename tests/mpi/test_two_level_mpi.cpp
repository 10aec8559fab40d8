/// The two-level preconditioner must not depend on the partition: compares its iterations on one rank and on several.
#include <gtest/gtest.h>

#include "support/linear_problem.hpp"

namespace perinox::test {
namespace {

void compare(const char* name, const std::string& yaml, const linear::TwoLevel::Settings& settings = {}) {
  const LinearProblem alone(yaml, MPI_COMM_SELF), together(yaml, MPI_COMM_WORLD);
  const auto one = alone.two_level(settings), many = together.two_level(settings);
  EXPECT_EQ(one->coarse_solver()->unknowns(), many->coarse_solver()->unknowns()) << name;
  const int count_alone = alone.iterations(*one), count_together = together.iterations(*many);
  if (together.scene.body().communicator.is_root())
    std::printf("%s: %d iterations on one rank, %d on %d\n", name, count_alone, count_together,
                together.scene.body().communicator.size());
  EXPECT_LE(std::abs(count_alone - count_together), 1) << name;
}

TEST(TwoLevelRanks, Cube) { compare("cube", held_cube(12)); }

TEST(TwoLevelRanks, VCycle) {
  linear::TwoLevel::Settings settings;
  settings.factorised_up_to = 0;
  compare("cube, V-cycle", held_cube(16), settings);
}

TEST(TwoLevelRanks, NestedGridsPartAtCracks) {
  // There are three grids, of which the smallest is factorised. The crack runs across the ranks.
  linear::TwoLevel::Settings settings;
  settings.factorised_up_to = 100;
  compare("crack, nested grids", held_cube(16, 0.33, half_crack(16)), settings);
}

TEST(TwoLevelRanks, Crack) {
  // The number of copies of the nodes on the crack is the same too, because pieces are found across ranks.
  compare("crack", held_cube(12, 0.33, half_crack(12)));
}

TEST(TwoLevelRanks, BodiesNotBonded) {
  compare("bodies not bonded", held_cube(12, 0.33, "bond_bodies: false\n",
                                         "  - {name: one, shape: {box: {min: [0, 0, 0], max: [5, 12, 12]}}, spacing: "
                                         "1, material: hard}\n"
                                         "  - {name: two, shape: {box: {min: [5, 0, 0], max: [12, 12, 12]}}, spacing: "
                                         "1, material: soft}\n"));
}

}  // namespace
}  // namespace perinox::test
