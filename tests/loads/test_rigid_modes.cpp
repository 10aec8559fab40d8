/// Which rigid motions supports leave free, in space and in the plane, of full bodies, sheets, rows and pairs.
#include <gmock/gmock.h>

#include "perinox/loads/rigid_modes.hpp"
#include "support/bodies.hpp"

namespace perinox::loads {
namespace {

using namespace body::fixture;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// A particle's id and the components that are prescribed there: {12, "xz"}.
using Supports = std::vector<std::pair<GlobalId, std::string>>;

std::vector<FreePiece> free_pieces(const deck::Deck& deck, const Supports& supports) {
  const auto [body, bonds] = build_bonds(deck, Communicator(MPI_COMM_SELF));
  const auto d = static_cast<std::size_t>(body.dimension);
  std::vector<char> prescribed(static_cast<std::size_t>(body.local()) * d, 0);
  for (const auto& [id, components] : supports)
    for (const char c : components) prescribed[static_cast<std::size_t>(id) * d + (c - 'x')] = 1;
  return find_free_pieces(body, bonds::connected_components(body, bonds::bond_graph(bonds)), prescribed);
}

/// Of a deck with one piece.
std::vector<std::string> motions(const deck::Deck& deck, const Supports& supports) {
  const std::vector<FreePiece> pieces = free_pieces(deck, supports);
  EXPECT_LE(pieces.size(), 1u);
  return pieces.empty() ? std::vector<std::string>() : pieces.front().motions;
}

deck::Deck box(double x, double y, double z) { return deck_of(deck::Box{{0, 0, 0}, {x, y, z}}); }

TEST(RigidModes, ABodyInSpaceHasSix) {
  EXPECT_THAT(
      motions(cube(4), {}),
      ElementsAre("rotate about the axis through (2, 2, 2) along x", "rotate about the axis through (2, 2, 2) along y",
                  "rotate about the axis through (2, 2, 2) along z", "move along x", "move along y", "move along z"));
  EXPECT_FALSE(free_pieces(cube(4), {}).front().touched);
}

TEST(RigidModes, AreHeldByAnySixThatDoNotRepeatEachOther) {
  EXPECT_THAT(motions(cube(4), {{0, "xyz"}, {3, "yz"}, {12, "z"}}), IsEmpty());  // three, two and one, as in textbooks
  EXPECT_THAT(motions(cube(4), {{0, "xyz"}, {3, "xyz"}, {60, "xyz"}}), IsEmpty());
  // Six again, but the last repeats what holds already: along the line from 0 to 3 both resist x.
  EXPECT_THAT(motions(cube(4), {{0, "xyz"}, {3, "xyz"}}),
              ElementsAre("rotate about the axis through (2, 0.5, 0.5) along x"));
}

TEST(RigidModes, ABallJointAHingeAndASlide) {
  // Each axis is named by its point nearest to the centre (2, 2, 2): all three meet in the held particle.
  EXPECT_THAT(motions(cube(4), {{0, "xyz"}}), ElementsAre("rotate about the axis through (2, 0.5, 0.5) along x",
                                                          "rotate about the axis through (0.5, 2, 0.5) along y",
                                                          "rotate about the axis through (0.5, 0.5, 2) along z"));
  EXPECT_THAT(motions(cube(4), {{0, "xy"}, {48, "xy"}, {63, "y"}}), ElementsAre("move along z"));
  EXPECT_THAT(motions(cube(4), {{0, "xyz"}, {63, "xyz"}}),
              ElementsAre("rotate about the axis through (2, 2, 2) along (0.57735, 0.57735, 0.57735)"));
}

TEST(RigidModes, OfAPlaneBodyAreThree) {
  EXPECT_THAT(motions(square(4), {}), ElementsAre("rotate about (2, 2)", "move along x", "move along y"));
  EXPECT_THAT(motions(square(4), {{5, "xy"}}), ElementsAre("rotate about (1.5, 1.5)"));
  EXPECT_THAT(motions(square(4), {{0, "y"}, {3, "y"}}), ElementsAre("move along x"));
  EXPECT_THAT(motions(square(4), {{0, "xy"}, {3, "x"}}), ElementsAre("rotate about (0.5, 0.5)"));
  EXPECT_THAT(motions(square(4), {{0, "xy"}, {3, "y"}}), IsEmpty());
}

TEST(RigidModes, ASheetInSpaceIsJudgedInItsPlaneOnly) {
  EXPECT_THAT(motions(box(4, 1, 4), {}),
              ElementsAre("rotate about the axis through (2, 0.5, 2) along y", "move along x", "move along z"));
  EXPECT_THAT(motions(box(4, 1, 4), {{0, "xz"}, {3, "z"}}), IsEmpty());
}

TEST(RigidModes, ARowIsJudgedAlongItsLineOnly) {
  EXPECT_THAT(motions(box(5, 1, 1), {{4, "x"}}), IsEmpty());
  EXPECT_THAT(motions(box(5, 1, 1), {{0, "yz"}, {4, "yz"}}), ElementsAre("move along x"));
  const deck::Deck flat = deck_of(deck::Box{{0, 0, 0}, {1, 5, 0}}, deck::Dimension::plane_strain);
  EXPECT_THAT(motions(flat, {{0, "y"}}), IsEmpty());
  EXPECT_THAT(motions(flat, {{0, "x"}}), ElementsAre("move along y"));
}

TEST(RigidModes, TwoParticles) {
  EXPECT_THAT(motions(box(2, 1, 1), {{0, "xyz"}, {1, "xyz"}}), IsEmpty());
  EXPECT_THAT(motions(box(2, 1, 1), {{0, "xyz"}}), IsEmpty());
  EXPECT_THAT(motions(box(2, 1, 1), {{0, "y"}}), ElementsAre("move along x"));
  // A bond across the axes: held in x alone it still slides away along y.
  const body::fixture::TextFile pair("pair.csv", "x,y,z,volume\n0,0,0,1\n1,1,0,1\n");
  deck::Deck oblique = deck_of(deck::CloudFile{pair.path()}, deck::Dimension::three, 0);
  oblique.horizon = {{}, std::nullopt, 1.5};
  EXPECT_EQ(motions(oblique, {{0, "x"}}).size(), 1u);
  EXPECT_THAT(motions(oblique, {{0, "xy"}}), IsEmpty());
}

TEST(RigidModes, AreFoundWhateverTheUnitAndTheOrigin) {
  for (const double spacing : {1e-9, 1.0, 1e6})
    for (const double away : {0.0, 1e4}) {
      const double low = away * spacing, high = (away + 6) * spacing;
      const deck::Deck deck = deck_of(deck::Box{{low, low, low}, {high, high, high}}, deck::Dimension::three, spacing);
      EXPECT_THAT(motions(deck, {{0, "xyz"}, {1, "yz"}, {6, "z"}}), IsEmpty()) << spacing << " " << away;
      EXPECT_EQ(motions(deck, {{0, "xyz"}, {1, "xyz"}, {5, "yz"}}).size(), 1u) << spacing << " " << away;
      EXPECT_EQ(motions(deck, {{0, "z"}, {1, "z"}, {6, "z"}}).size(), 3u) << spacing << " " << away;
    }
}

TEST(RigidModes, AShortLeverAtTheEndOfALongBarHolds) {
  EXPECT_THAT(motions(box(2000, 2, 1), {{0, "xy"}, {1, "y"}}), IsEmpty());  // a sheet: in its plane
  EXPECT_THAT(motions(box(800, 2, 2), {{0, "xyz"}, {1, "yz"}, {800, "z"}}), IsEmpty());
  EXPECT_EQ(motions(box(800, 2, 2), {{0, "xyz"}, {1, "yz"}}).size(), 1u);
}

TEST(RigidModes, EachPieceIsJudgedByItself) {
  deck::Deck deck = cube(4);
  add_crack(deck, deck::CrackRectangle{{-1, -1, 2}, {9, 0, 0}, {0, 9, 0}});
  const std::vector<FreePiece> pieces = free_pieces(deck, {{0, "xyz"}, {3, "yz"}, {12, "z"}, {60, "xy"}});
  ASSERT_EQ(pieces.size(), 1u);
  EXPECT_EQ(pieces[0].component, 1);
  EXPECT_TRUE(pieces[0].touched);
  EXPECT_THAT(pieces[0].motions, ::testing::SizeIs(4));
  EXPECT_EQ(pieces[0].center, (deck::Point{2, 2, 3}));
}

}  // namespace
}  // namespace perinox::loads
