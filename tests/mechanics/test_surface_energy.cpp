/// Quadrature surface-energy: the energy of uniform strain is right on average over all shears, at every point.
#include <gtest/gtest.h>

#include "materials/elastic.hpp"
#include "materials/elastic_plastic.hpp"
#include "support/measured.hpp"
#include "support/scenes.hpp"

namespace perinox::test {
namespace {

constexpr double bulk = 67.5e3, shear = 25.9e3;

deck::Deck corrected_deck(deck::Dimension dimension, const std::array<int, 3>& counts) {
  deck::Deck deck = lattice_deck(dimension, counts, 0.25, 3.015);
  deck.quadrature = deck::Quadrature::surface_energy;
  deck.small_strain = true;
  return deck;
}

/// A basis of the strains without change of volume, each of size 1e-3.
std::vector<Matrix> deviators(int dimension) {
  std::vector<Matrix> all;
  for (int a = 0; a < dimension; ++a)
    for (int b = a + 1; b < dimension; ++b) {
      Matrix across{};
      across[a][b] = across[b][a] = 1e-3 / std::sqrt(2.0);
      all.push_back(across);
    }
  Matrix along{};
  along[0][0] = 1e-3 / std::sqrt(2.0);
  along[1][1] = -along[0][0];
  all.push_back(along);
  if (dimension == 2) return all;
  Matrix third{};
  third[0][0] = third[1][1] = 1e-3 / std::sqrt(6.0);
  third[2][2] = -2 * third[0][0];
  all.push_back(third);
  return all;
}

Matrix gradient_of(Matrix strain) {
  for (int c = 0; c < 3; ++c) strain[c][c] += 1;
  return strain;
}

TEST(SurfaceEnergy, OfShearIsRightOnAverageAndOfExpansionAlways) {
  for (const auto dimension : {deck::Dimension::three, deck::Dimension::plane_strain}) {
    const bool solid = dimension == deck::Dimension::three;
    const double kappa = materials::ElasticConstants{bulk, shear}.bulk_of(dimension);
    const mechanics::Scene scene =
        make_scene(corrected_deck(dimension, solid ? std::array<int, 3>{8, 7, 6} : std::array<int, 3>{12, 9, 1}),
                   materials_of(std::make_unique<materials::Elastic>(kappa, shear, true)));
    const auto energies = [&](const Matrix& strain) {
      return internal_force(scene, mechanics::Committed(scene), affine_field(scene, gradient_of(strain)))
          .trial.stored_energy;
    };
    const int d = solid ? 3 : 2;
    std::vector<double> mean(static_cast<std::size_t>(scene.owned()), 0.0);
    const std::vector<Matrix> shears = deviators(d);
    for (const Matrix& strain : shears) {
      const std::vector<double> found = energies(strain);
      // A shear of a cut family also changes its dilatation, whose own energy is not the correction's business.
      const mechanics::Trial trial =
          internal_force(scene, mechanics::Committed(scene), affine_field(scene, gradient_of(strain))).trial;
      for (std::size_t i = 0; i < mean.size(); ++i)
        mean[i] +=
            (found[i] - kappa * trial.dilatation[i] * trial.dilatation[i] / 2) / static_cast<double>(shears.size());
    }
    double worst = 0;
    for (const double value : mean) worst = std::max(worst, std::abs(value / (shear * 1e-6) - 1));
    EXPECT_LE(measured("surface-energy: mean energy of shear", worst), 1e-10);  // 4e-13
    Matrix expansion{};
    for (int c = 0; c < d; ++c) expansion[c][c] = 1e-3;
    double off = 0;
    for (const double value : energies(expansion))
      off = std::max(off, std::abs(value / (kappa * d * d * 1e-6 / 2) - 1));
    EXPECT_LE(measured("surface-energy: energy of expansion", off), 1e-10);  // 7e-13
  }
}

TEST(SurfaceEnergy, TangentIsTheDerivativeOfTheForceInBothLayouts) {
  materials::ElasticPlastic::Parameters p;
  p.bulk = bulk;
  p.shear = shear;
  p.yield_shear = 117.3;
  Vector products[2];
  for (const auto layout : {mechanics::Layout::automatic, mechanics::Layout::pairs}) {
    const mechanics::Scene scene = make_scene(corrected_deck(deck::Dimension::three, {6, 6, 5}),
                                              materials_of(std::make_unique<materials::ElasticPlastic>(p)), layout);
    Matrix strain{};
    strain[0][0] = 4e-3;
    strain[0][1] = strain[1][0] = 3e-3;
    const mechanics::Committed committed(scene);
    const Vector here = affine_field(scene, gradient_of(strain));
    const auto tangent = mechanics::make_tangent(scene, deck::TangentForm::consistent);
    tangent->linearise(committed, here.data(), deck::TangentForm::consistent);
    const Vector direction = random_field(scene, 1, 5);
    EXPECT_LE(measured("surface-energy: tangent against differences",
                       tangent_error(scene, committed, here, direction, *tangent)),
              1e-8);  // 5e-11
    EXPECT_LE(asymmetry(*tangent, direction, random_field(scene, 1, 6)), 1e-13);
    products[layout == mechanics::Layout::pairs ? 1 : 0] = times(*tangent, direction);
  }
  EXPECT_LE(measured("surface-energy: layouts", norm(sum(products[0], -1, products[1])) / norm(products[0])),
            1e-12);  // 2e-16
}

}  // namespace
}  // namespace perinox::test
