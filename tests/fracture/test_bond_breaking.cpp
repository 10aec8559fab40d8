/// Which bonds break: the worst first, those alike by symmetry together, none of an unbreakable set.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "perinox/fracture/bond_breaking.hpp"
#include "support/broken.hpp"
#include "support/fracture.hpp"
#include "support/measured.hpp"

namespace perinox::test {
namespace {

using test::measured;

/// Stretch that grows to the right.
std::array<double, 2> uneven(double x, double y) { return {0.001 * x * x * (1 + 0.01 * y), 1e-4 * y * (1 + 0.1 * x)}; }

TEST(BondBreaking, TheWorstBreakFirst) {
  Plate plate(square_plate("critical_stretch: 0.01"));
  plate.move(uneven);
  std::vector<double> stretches;
  for (const auto& bond : test::all_bonds(plate.scene))
    stretches.push_back(plate.stretch({plate.scene.body().id[bond[0]], plate.scene.body().id[bond[1]]}));
  std::sort(stretches.begin(), stretches.end(), std::greater<>());
  const auto critical = std::count_if(stretches.begin(), stretches.end(), [](double s) { return s >= 0.01; });
  fracture::BondBreaking breaking(plate.deck, plate.scene);
  EXPECT_EQ(breaking.bonds(), static_cast<long long>(stretches.size()));
  const auto found = breaking.break_worst(plate.committed, 20);
  EXPECT_EQ(found.critical, critical);
  EXPECT_NEAR(found.worst, stretches.front() / 0.01, 1e-12 * found.worst);
  EXPECT_EQ(found.broken, 20);
  EXPECT_EQ(breaking.broken(), 20);
  ASSERT_EQ(plate.scene.broken().size(), 20u);
  double least = 1;
  for (const auto& ids : plate.scene.broken()) least = std::min(least, plate.stretch(ids));
  EXPECT_NEAR(least, stretches[19], 1e-14);
  // The rest in one go, and then none is left.
  EXPECT_EQ(breaking.break_worst(plate.committed, 1000000).broken, critical - 20);
  const auto after = breaking.break_worst(plate.committed, 1000000);
  EXPECT_EQ(after.broken, 0);
  EXPECT_LT(after.worst, 1);
}

TEST(BondBreaking, BondsAlikeBreakTogether) {
  // Uniform tension: all bonds along x are alike but for rounding, and more than `most` of them break.
  Plate plate(square_plate("critical_stretch: 0.01"));
  plate.move([](double x, double y) -> std::array<double, 2> { return {0.011 * x + 1.7, -0.003 * y + 0.3}; });
  fracture::BondBreaking breaking(plate.deck, plate.scene);
  const auto found = breaking.break_worst(plate.committed, 1);
  EXPECT_EQ(found.broken, 12 * (11 + 10 + 9));
  for (const auto& ids : plate.scene.broken())
    EXPECT_EQ(plate.scene.body().position(static_cast<LocalIndex>(ids[0]))[1],
              plate.scene.body().position(static_cast<LocalIndex>(ids[1]))[1]);
}

TEST(BondBreaking, UnbreakableSetsKeepTheirBonds) {
  Plate plate(square_plate("critical_stretch: 0.01", "fracture: {unbreakable: [left, bottom]}"));
  plate.move([](double x, double y) -> std::array<double, 2> { return {0.02 * x, 0.02 * y}; });
  fracture::BondBreaking breaking(plate.deck, plate.scene);
  const auto bonds = test::all_bonds(plate.scene);
  const auto kept = std::count_if(bonds.begin(), bonds.end(), [&](const mechanics::BondEnds& bond) {
    return std::any_of(bond.begin(), bond.end(), [&](LocalIndex i) {
      return plate.scene.body().position(i)[0] < 3 || plate.scene.body().position(i)[1] < 3;
    });
  });
  EXPECT_EQ(breaking.break_worst(plate.committed, 1).broken, static_cast<long long>(bonds.size()) - kept);
  EXPECT_EQ(static_cast<long long>(test::all_bonds(plate.scene).size()), kept);
}

TEST(BondBreaking, CompressionBreaksNothing) {
  for (const char* law : {"critical_stretch: 1e-6", "critical_bond_energy: 1e-9"}) {
    Plate plate(square_plate(law));
    plate.move([](double x, double y) -> std::array<double, 2> { return {-0.01 * x, -0.01 * y}; });
    fracture::BondBreaking breaking(plate.deck, plate.scene);
    EXPECT_EQ(breaking.break_worst(plate.committed, 1000).broken, 0);
  }
}

TEST(BondBreaking, TheWeakerEndDecides) {
  Plate plate(R"(
dimension: plane-stress
body:
  - {name: weak, shape: {box: {min: [0, 0], max: [6, 6]}}, spacing: 1, material: weak}
  - {name: strong, shape: {box: {min: [6, 0], max: [12, 6]}}, spacing: 1, material: strong}
  - {name: eternal, shape: {box: {min: [12, 0], max: [18, 6]}}, spacing: 1, material: eternal}
horizon: {ratio: 3.015}
quadrature: whole
materials:
  weak: {model: elastic, young_modulus: 1000, poisson_ratio: 0.3, damage: {critical_stretch: 0.01}}
  strong: {model: elastic, young_modulus: 1000, poisson_ratio: 0.3, damage: {critical_stretch: 0.02}}
  eternal: {model: elastic, young_modulus: 1000, poisson_ratio: 0.3}
boundary: [{set: weak, displacement: {x: 0, y: 0}}]
)");
  plate.move([](double x, double y) -> std::array<double, 2> { return {0.015 * x, 0.015 * y}; });
  fracture::BondBreaking breaking(plate.deck, plate.scene);
  breaking.break_worst(plate.committed, 1000000);
  for (const auto& ids : plate.scene.broken())
    EXPECT_TRUE(plate.scene.body().material[ids[0]] == 0 || plate.scene.body().material[ids[1]] == 0);
  for (const auto& bond : test::all_bonds(plate.scene))
    EXPECT_TRUE(plate.scene.body().material[bond[0]] != 0 && plate.scene.body().material[bond[1]] != 0);
  // Twice that, and only the bonds between two ends that never break are left.
  plate.move([](double x, double y) -> std::array<double, 2> { return {0.03 * x, 0.03 * y}; });
  breaking.break_worst(plate.committed, 1000000);
  for (const auto& bond : test::all_bonds(plate.scene))
    EXPECT_TRUE(plate.scene.body().material[bond[0]] == 2 && plate.scene.body().material[bond[1]] == 2);
}

TEST(BondBreaking, ABondsEnergyIsWhatTheStoredEnergyLoses) {
  // One bond of a family of 28: to first order in its share.
  for (const char* quadrature : {"whole", "position-aware"}) {
    std::string yaml = square_plate("critical_bond_energy: 1e-6");
    yaml.replace(yaml.find("quadrature: whole"), 17, std::string("quadrature: ") + quadrature);
    Plate plate(yaml);
    // The worst bond is an inner one.
    plate.move([](double x, double y) -> std::array<double, 2> {
      const double r = std::hypot(x - 6.2, y - 5.9);
      return {0.02 * std::tanh(x - 6.1) * std::exp(-r * r / 16) + 0.002 * x, 0.001 * y};
    });
    fracture::BondBreaking breaking(plate.deck, plate.scene);
    const auto found = breaking.break_worst(plate.committed, 1);
    ASSERT_EQ(found.broken, 1);
    const double lost = plate.stored - plate.stored_now(), said = found.worst * 1e-6;
    std::printf("energy of the worst bond: %.4g said, %.4g lost\n", said, lost);
    EXPECT_LE(measured("bond energy: said over lost, off by", std::abs(said / lost - 1)), 0.02);  // 4.9e-3
  }
}

}  // namespace
}  // namespace perinox::test
