/// One state is evaluated once: the tangent finds the strains of the internal force, and nothing else does.
#include <gtest/gtest.h>

#include "materials/elastic.hpp"
#include "support/scenes.hpp"

namespace perinox::test {
namespace {

mechanics::Scene cube() {
  return make_scene(lattice_deck(deck::Dimension::three, {4, 4, 4}, 1, 3.015),
                    materials_of(std::make_unique<materials::Elastic>(100.0, 50.0, true)));
}

/// The displacement is overwritten behind the number's back, so that a sweep that looks at it again gives itself away.
TEST(Evaluation, AStateWithTheSameNumberIsNotSweptAgain) {
  const mechanics::Scene scene = cube();
  const mechanics::Committed committed(scene);
  const auto evaluation = std::make_shared<mechanics::Evaluation>(scene);
  Vector u = random_field(scene, 0.01, 1), force(u.size());
  mechanics::Trial trial;
  const std::uint64_t number = medium::new_version();
  mechanics::internal_force(*evaluation, committed, {u.data(), number}, trial, force.data());
  const Vector first = force;
  EXPECT_GT(norm(first), 0);

  std::fill(u.begin(), u.end(), 0.0);
  mechanics::internal_force(*evaluation, committed, {u.data(), number}, trial, force.data());
  EXPECT_EQ(force, first);
  mechanics::internal_force(*evaluation, committed, u.data(), trial, force.data());
  EXPECT_EQ(norm(force), 0);
}

TEST(Evaluation, BrokenBondsAreANewState) {
  mechanics::Scene scene = cube();
  const mechanics::Committed committed(scene);
  mechanics::Evaluation evaluation(scene);
  const Vector u = random_field(scene, 0.01, 1);
  Vector before(u.size()), after(u.size());
  mechanics::Trial trial;
  const medium::At at = u.data();
  mechanics::internal_force(evaluation, committed, at, trial, before.data());
  std::vector<LocalIndex> neighbors;
  scene.bond_graph()(0, neighbors);
  scene.break_bonds({{0, neighbors.front()}});
  mechanics::internal_force(evaluation, committed, at, trial, after.data());
  EXPECT_NE(after, before);
}

}  // namespace
}  // namespace perinox::test
