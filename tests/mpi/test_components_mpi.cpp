/// Compares pieces, free motions and the profile on several ranks with one rank alone.
#include <cmath>
#include <map>

#include "perinox/bonds/components.hpp"
#include "perinox/loads/rigid_modes.hpp"
#include "support/bodies.hpp"

namespace perinox::bonds {
namespace {

using namespace body::fixture;

std::map<std::string, deck::Deck> scenes() {
  std::map<std::string, deck::Deck> all;
  all["cube"] = cube(7);
  all["row"] = deck_of(deck::Box{{0, 0, 0}, {40, 1, 1}});
  all["ring"] = deck_of(deck::Difference{{shape_of(deck::Sphere{{0, 0, 0}, 12}), shape_of(deck::Sphere{{0, 0, 0}, 9})}},
                        deck::Dimension::plane_strain);
  all["split ring"] = all["ring"];
  add_crack(all["split ring"], deck::CrackSegment{{-20, 0.2, 0}, {20, 0.3, 0}});
  all["two bodies"] = deck_of(deck::Box{{0, 0, 0}, {10, 4, 4}});
  add_body(all["two bodies"], "lid", deck::Box{{0, 0, 4}, {10, 4, 6}});
  all["two bodies"].bond_bodies = false;
  all["three particles"] = deck_of(deck::Box{{0, 0, 0}, {3, 1, 1}});
  return all;
}

TEST(ComponentsOnRanks, AreThoseOfOneRank) {
  const Communicator world(MPI_COMM_WORLD), alone(MPI_COMM_SELF);
  for (const auto& [name, deck] : scenes()) {
    SCOPED_TRACE(name);
    const auto whole = build_bonds(deck, alone), part = build_bonds(deck, world);
    const Components one = connected_components(whole.body, bond_graph(whole.bonds));
    const Components many = connected_components(part.body, bond_graph(part.bonds));
    EXPECT_EQ(one.count(), name == "split ring" || name == "two bodies" ? 2 : 1);
    EXPECT_EQ(many.first, one.first);
    EXPECT_EQ(many.particles, one.particles);
    ASSERT_EQ(many.of.size(), static_cast<std::size_t>(part.body.local()));
    for (LocalIndex i = 0; i < part.body.local(); ++i)
      EXPECT_EQ(many.of[i], one.of[static_cast<std::size_t>(part.body.id[i])]);
  }
}

TEST(RigidModesOnRanks, AreThoseOfOneRank) {
  const Communicator world(MPI_COMM_WORLD), alone(MPI_COMM_SELF);
  for (const auto& [name, deck] : scenes()) {
    SCOPED_TRACE(name);
    const auto free_pieces = [&, &scene = deck](const Communicator& ranks) {
      const auto [body, bonds] = build_bonds(scene, ranks);
      std::vector<char> prescribed(static_cast<std::size_t>(body.local() * body.dimension), 0);
      for (LocalIndex i = 0; i < body.local(); ++i) {
        if (body.id[i] == 1) prescribed[i * body.dimension] = 1;
        if (body.id[i] == body.total - 1) prescribed[i * body.dimension + 1] = 1;
      }
      return loads::find_free_pieces(body, connected_components(body, bond_graph(bonds)), prescribed);
    };
    const std::vector<loads::FreePiece> one = free_pieces(alone), many = free_pieces(world);
    ASSERT_EQ(many.size(), one.size());
    for (std::size_t k = 0; k < one.size(); ++k) {
      EXPECT_EQ(many[k].component, one[k].component);
      EXPECT_EQ(many[k].touched, one[k].touched);
      EXPECT_EQ(many[k].motions, one[k].motions);
    }
  }
}

TEST(ProfileOnRanks, TheSlowestRankIsTold) {
  const Communicator world(MPI_COMM_WORLD);
  ProfileReading mine;
  mine.seconds[0] = world.rank();
  mine.seconds[2] = -world.rank();
  mine.count[0] = 3;
  mine.wall = 10 + world.rank();
  const ProfileReading slowest = world.slowest(mine);
  EXPECT_EQ(slowest.seconds[0], world.size() - 1);
  EXPECT_EQ(slowest.seconds[2], 0);
  EXPECT_EQ(slowest.count[0], 3);
  EXPECT_EQ(slowest.wall, 9 + world.size());
}

TEST(ProfileOnRanks, TheHaloIsTimed) {
  const Communicator world(MPI_COMM_WORLD);
  const body::Body body = build_body(cube(6), world);
  const ProfileReading before = world.profile().read();
  std::vector<double> values(static_cast<std::size_t>(body.local()), 1);
  body.halo.update_ghosts(values.data(), 1);
  body.halo.add_to_owners(values.data(), 1);
  const ProfileReading between = world.profile().read() - before;
  EXPECT_EQ(between.count_of(Section::halo), 2);
  EXPECT_GT(between.seconds_of(Section::halo), 0);
}

}  // namespace
}  // namespace perinox::bonds
