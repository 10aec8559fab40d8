/// Stress and strain fields: exact under uniform strain at every point, elastic and yielding, in 3-D and in the plane.
#include <gtest/gtest.h>

#include "materials/elastic.hpp"
#include "materials/elastic_plastic.hpp"
#include "materials/plane_plastic.hpp"
#include "perinox/mechanics/stress.hpp"
#include "support/measured.hpp"
#include "support/scenes.hpp"

namespace perinox::test {
namespace {

constexpr double bulk = 67.5e3, shear = 25.9e3, yield = 117.3;
constexpr double lame = bulk - 2 * shear / 3;
using Tensor = std::array<double, 6>;  // xx xy xz yy yz zz

double worst_difference(const std::vector<double>& found, const Tensor& exact) {
  double worst = 0, scale = 0;
  for (const double value : exact) scale = std::max(scale, std::abs(value));
  for (std::size_t k = 0; k < found.size(); ++k) worst = std::max(worst, std::abs(found[k] - exact[k % 6]));
  return worst / scale;
}

Matrix gradient_of(const Matrix& strain) {
  Matrix gradient = strain;
  for (int c = 0; c < 3; ++c) gradient[c][c] += 1;
  return gradient;
}

deck::Deck fitted_deck(deck::Dimension dimension, const std::array<int, 3>& counts) {
  deck::Deck deck = lattice_deck(dimension, counts, 0.25, 3.015);
  deck.quadrature = deck::Quadrature::position_aware;
  deck.small_strain = true;
  return deck;
}

/// strain out of the plane included.
Tensor elastic_stress(const Tensor& e) {
  const double pressure = lame * (e[0] + e[3] + e[5]);
  return {pressure + 2 * shear * e[0], 2 * shear * e[1], 2 * shear * e[2],
          pressure + 2 * shear * e[3], 2 * shear * e[4], pressure + 2 * shear * e[5]};
}

TEST(Stress, UniformElasticStrainInEveryDimension) {
  for (const auto layout : {mechanics::Layout::automatic, mechanics::Layout::pairs})
    for (const auto dimension :
         {deck::Dimension::three, deck::Dimension::plane_strain, deck::Dimension::plane_stress}) {
      const bool solid = dimension == deck::Dimension::three;
      const materials::ElasticConstants constants{bulk, shear};
      const mechanics::Scene scene = make_scene(
          fitted_deck(dimension, solid ? std::array<int, 3>{8, 7, 6} : std::array<int, 3>{12, 9, 1}),
          materials_of(std::make_unique<materials::Elastic>(constants.bulk_of(dimension), shear, true, dimension)),
          layout);
      Matrix strain{{{1e-3, 4e-4, 0}, {4e-4, -7e-4, 0}, {0, 0, 0}}};
      Tensor exact{1e-3, 4e-4, 0, -7e-4, 0, 0};
      if (solid) {
        strain[0][2] = strain[2][0] = exact[2] = -3e-4;
        strain[1][2] = strain[2][1] = exact[4] = 2e-4;
        strain[2][2] = exact[5] = 5e-4;
      }
      if (dimension == deck::Dimension::plane_stress) exact[5] = -lame / (lame + 2 * shear) * (exact[0] + exact[3]);
      mechanics::Stress stress(scene);
      stress.evaluate(committed_after(scene, {affine_field(scene, gradient_of(strain))}));
      EXPECT_LE(measured("stress: elastic strain", worst_difference(stress.strain(), exact)), 1e-10);
      EXPECT_LE(measured("stress: elastic stress", worst_difference(stress.stress(), elastic_stress(exact))), 1e-10);
    }
}

TEST(Stress, WholeNeighboursOnALatticeAreOffByTheirModulus) {
  // Inside: the strain is right, the stress in shear that of a wrong shear modulus (theory.md section 11).
  deck::Deck deck = fitted_deck(deck::Dimension::three, {9, 9, 9});
  deck.quadrature = deck::Quadrature::whole;
  const mechanics::Scene scene =
      make_scene(deck, materials_of(std::make_unique<materials::Elastic>(bulk, shear, true)));
  Matrix strain{};
  strain[0][1] = strain[1][0] = 5e-4;
  mechanics::Stress stress(scene);
  stress.evaluate(committed_after(scene, {affine_field(scene, gradient_of(strain))}));
  const std::size_t middle = 4 + 9 * 4 + 81 * 4;
  EXPECT_NEAR(stress.strain()[6 * middle + 1] / 5e-4, 1, 1e-10);
  const double ratio = measured("stress: whole neighbours, shear", stress.stress()[6 * middle + 1] / (shear * 1e-3));
  EXPECT_GT(std::abs(ratio - 1), 0.05);
  EXPECT_LT(std::abs(ratio - 1), 0.2);
}

TEST(Stress, VonMisesOfAYieldingBodyIsTheYieldStress) {
  materials::ElasticPlastic::Parameters p;
  p.bulk = bulk;
  p.shear = shear;
  p.yield_shear = yield;
  for (const auto dimension : {deck::Dimension::three, deck::Dimension::plane_strain, deck::Dimension::plane_stress}) {
    const bool solid = dimension == deck::Dimension::three;
    std::unique_ptr<materials::Material> material;
    if (solid)
      material = std::make_unique<materials::ElasticPlastic>(p);
    else
      material = std::make_unique<materials::PlanePlastic>(p, dimension);
    const mechanics::Scene scene =
        make_scene(fitted_deck(dimension, solid ? std::array<int, 3>{7, 7, 7} : std::array<int, 3>{12, 9, 1}),
                   materials_of(std::move(material)));
    std::vector<Vector> path;
    for (int k = 1; k <= 4; ++k) {
      Matrix strain{};
      strain[0][0] = 2e-3 * k;
      strain[1][1] = -1e-3 * k;
      strain[0][1] = strain[1][0] = 1e-3 * k;
      path.push_back(affine_field(scene, gradient_of(strain)));
    }
    mechanics::Stress stress(scene);
    const mechanics::Committed committed = committed_after(scene, path);
    stress.evaluate(committed);
    double worst = 0, work = 0;
    for (LocalIndex i = 0; i < scene.owned(); ++i) {
      worst = std::max(worst, std::abs(stress.von_mises()[i] / (std::sqrt(3.0) * yield) - 1));
      const double* history = committed.point_history(scene, i);
      // Perfect plasticity: the yield stress over the equivalent plastic strain.
      const double exact = std::sqrt(3.0) * yield * history[1];
      work = std::max(work, std::abs(scene.material(i).plastic_work(history) / exact - 1));
    }
    EXPECT_LE(measured("stress: von Mises of a yielding body", worst), 1e-10);
    EXPECT_LE(measured("stress: plastic work", work), 1e-12);
  }
}

}  // namespace
}  // namespace perinox::test
