/// What breaking has left without support: particles that hang on too little, pieces that touch no support.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "perinox/fracture/loose_pieces.hpp"
#include "support/broken.hpp"
#include "support/fracture.hpp"

namespace perinox::test {
namespace {

using ::testing::HasSubstr;

struct Loose : Plate {
  explicit Loose(const std::string& yaml = square_plate("critical_stretch: 0.01"))
      : Plate(yaml), boundary(deck, scene), zero(scene.owned_unknowns(), 0.0) {}
  LocalIndex at(double x, double y) const {
    for (LocalIndex i = 0; i < scene.owned(); ++i)
      if (std::hypot(scene.body().position(i)[0] - x, scene.body().position(i)[1] - y) < 0.1) return i;
    throw std::runtime_error("no particle there");
  }
  /// Breaks all bonds that the predicate of two positions asks for.
  template <class Predicate>
  void cut(const Predicate& predicate) {
    std::vector<mechanics::BondEnds> ends;
    for (const auto& bond : test::all_bonds(scene))
      if (predicate(scene.body().position(bond[0]), scene.body().position(bond[1]))) ends.push_back(bond);
    scene.break_bonds(ends);
  }
  long long count(const fracture::LoosePieces& found) const {
    return std::count(found.loose.begin(), found.loose.end(), static_cast<char>(1));
  }
  loads::Boundary boundary;
  std::vector<double> zero;
  fracture::PiecesLoads no_loads{zero, zero};
};

TEST(LoosePieces, NothingIsLooseBeforeAnythingBreaks) {
  Loose plate;
  const fracture::LoosePieces found = fracture::find_loose(plate.scene, plate.boundary, {}, plate.no_loads);
  EXPECT_EQ(plate.count(found), 0);
  EXPECT_EQ(found.broken, 0);
  EXPECT_TRUE(found.sentences.empty());
}

TEST(LoosePieces, AParticleWithoutBonds) {
  Loose plate;
  const LocalIndex lone = plate.at(5.5, 8.5);
  plate.scene.break_bonds(test::bonds_of(plate.scene, lone));
  const fracture::LoosePieces found = fracture::find_loose(plate.scene, plate.boundary, {}, plate.no_loads);
  EXPECT_EQ(plate.count(found), 1);
  EXPECT_TRUE(found.loose[lone]);
  EXPECT_EQ(found.broken, 0);
  ASSERT_EQ(found.sentences.size(), 1u);
  EXPECT_THAT(found.sentences[0], HasSubstr("1 single particles have lost all their bonds"));
  // Once let go it is told no more.
  plate.boundary.let_go(found.loose);
  const fracture::LoosePieces again = fracture::find_loose(plate.scene, plate.boundary, {}, plate.no_loads);
  EXPECT_EQ(plate.count(again), 0);
  EXPECT_TRUE(again.sentences.empty());
}

TEST(LoosePieces, AParticleThatHangsOnOneLine) {
  Loose plate;
  const LocalIndex hanging = plate.at(5.5, 8.5);
  plate.cut([&](const double* a, const double* b) {
    const bool of_it = a == plate.scene.body().position(hanging) || b == plate.scene.body().position(hanging);
    return of_it && a[1] != b[1];  // six bonds along x are left
  });
  ASSERT_EQ(plate.scene.families().size[hanging], 6);
  const fracture::LoosePieces found = fracture::find_loose(plate.scene, plate.boundary, {}, plate.no_loads);
  EXPECT_EQ(found.broken, 6);
  EXPECT_EQ(plate.scene.families().size[hanging], 0);
  EXPECT_EQ(plate.count(found), 1);
  EXPECT_TRUE(found.loose[hanging]);
}

TEST(LoosePieces, AFragment) {
  Loose plate;
  const auto inside = [](const double* x) { return x[0] > 4 && x[0] < 8 && x[1] > 6 && x[1] < 9; };
  plate.cut([&](const double* a, const double* b) { return inside(a) != inside(b); });
  const fracture::LoosePieces found = fracture::find_loose(plate.scene, plate.boundary, {}, plate.no_loads);
  EXPECT_EQ(plate.count(found), 12);
  EXPECT_EQ(found.broken, 0);
  for (LocalIndex i = 0; i < plate.scene.owned(); ++i)
    EXPECT_EQ(found.loose[i] != 0, inside(plate.scene.body().position(i)));
  ASSERT_EQ(found.sentences.size(), 1u);
  EXPECT_THAT(found.sentences[0], HasSubstr("a piece of 12 particles"));
}

// Only its last particle in the row is joined to the rest, by bonds in all directions: the piece can turn about it.
TEST(LoosePieces, APieceOnAHingeStays) {
  Loose plate;
  const LocalIndex hinge = plate.at(5.5, 5.5);
  const double* middle = plate.scene.body().position(hinge);
  plate.cut([&](const double* a, const double* b) { return (a[1] < 6) != (b[1] < 6) && a != middle && b != middle; });
  const fracture::LoosePieces found = fracture::find_loose(plate.scene, plate.boundary, {}, plate.no_loads);
  EXPECT_EQ(plate.count(found), 0);
  EXPECT_EQ(found.broken, 0);
}

TEST(LoosePieces, APieceThatIsHeldPartlyStays) {
  std::string yaml = square_plate("critical_stretch: 0.01");
  const std::string held = "boundary: [";
  yaml.insert(yaml.find(held) + held.size(), "{set: top, displacement: {y: 0.1}}, ");
  Loose plate;
  plate.deck = deck_of(yaml);
  const loads::Boundary boundary(plate.deck, plate.scene);
  plate.cut([](const double* a, const double* b) { return (a[1] < 6) != (b[1] < 6); });
  EXPECT_EQ(plate.count(fracture::find_loose(plate.scene, boundary, {}, plate.no_loads)), 0);  // free along x, but held along y
}

/// The plate in two, its upper half held along y and loaded as given; what of it is loose.
fracture::LoosePieces half_under(const std::string& load, const std::string& deformation, const std::string& held,
                                 bool in_contact = false) {
  std::string yaml = square_plate("critical_stretch: 0.01", "deformation: " + deformation);
  const std::string begin = "boundary: [";
  yaml.insert(yaml.find(begin) + begin.size(), "{set: top, displacement: {" + held + "}}, {set: top, " + load + "}, ");
  Loose plate(yaml);
  std::vector<double> given(plate.scene.owned_unknowns());
  plate.boundary.external_force(1, given.data());
  std::vector<double> all = given;
  if (in_contact) all[2 * plate.at(5.5, 6.5)] -= 1;
  // Before the cut the lower half holds all of it.
  EXPECT_EQ(plate.count(fracture::find_loose(plate.scene, plate.boundary, {}, {given, all})), 0);
  plate.cut([](const double* a, const double* b) { return (a[1] < 6) != (b[1] < 6); });
  fracture::LoosePieces found = fracture::find_loose(plate.scene, plate.boundary, {}, {given, all});
  for (LocalIndex i = 0; i < plate.scene.owned(); ++i)
    EXPECT_EQ(found.loose[i] != 0, !found.sentences.empty() && plate.scene.body().position(i)[1] > 6);
  return found;
}

TEST(LoosePieces, APieceThatIsHeldPartlyAndPushedIsLoose) {
  for (const char* deformation : {"finite", "small"}) {
    const fracture::LoosePieces found = half_under("force: {x: 3}", deformation, "y: 0.1");
    ASSERT_EQ(found.sentences.size(), 1u);
    EXPECT_EQ(found.sentences[0],
              "a piece of 72 particles, the first of them 72, is held in part only: it can move along x, and its loads "
              "push it that way; it counts as loose and is held where it is");
  }
  EXPECT_TRUE(half_under("force: {y: 3}", "small", "y: 0.1").sentences.empty());             // held against that
  EXPECT_TRUE(half_under("body_force: {x: \"x-6\"}", "small", "y: 0.1").sentences.empty());  // in balance
  EXPECT_TRUE(half_under("force: {x: 3}", "small", "y: 0.1", true).sentences.empty());  // held by a contact, perhaps
}

// Held along x it can move along y and not turn; held along x in one row only it can turn as well.
TEST(LoosePieces, ATurnIsARestlessMotionInSmallDeformationOnly) {
  const auto hinged = [](const std::string& deformation) {
    std::string deck = square_plate("critical_stretch: 0.01", "deformation: " + deformation);
    const std::string begin = "boundary: [", sets = "sets: {";
    deck.insert(deck.find(begin) + begin.size(),
                "{set: pin, displacement: {x: 0, y: 0}}, {set: left, force: {x: 2}}, ");
    deck.insert(deck.find(sets) + sets.size(), "pin: {where: \"abs(x-6)<0.6 && abs(y-9.5)<0.1 && x<6\"}, ");
    Loose plate(deck);
    std::vector<double> given(plate.scene.owned_unknowns());
    plate.boundary.external_force(1, given.data());
    plate.cut([](const double* a, const double* b) { return (a[1] < 6) != (b[1] < 6); });
    return fracture::find_loose(plate.scene, plate.boundary, {}, {given, given}).sentences;
  };
  const std::vector<std::string> turning = hinged("small");
  ASSERT_EQ(turning.size(), 1u);
  EXPECT_THAT(turning[0], HasSubstr("it can rotate about (5.5, 9.5), and its loads push it that way"));
  EXPECT_TRUE(hinged("finite").empty());  // it may swing to where it rests
}

}  // namespace
}  // namespace perinox::test
