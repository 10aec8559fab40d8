/// A lattice point whose whole family is inside the body, under uniform strain: its energy is kappa theta^2/2 plus the
/// shear energy up to the error of the quadrature, which is known for each horizon (docs/theory.md, section 11).
#include <gtest/gtest.h>

#include "materials/elastic.hpp"
#include "support/measured.hpp"
#include "support/scenes.hpp"

namespace perinox::test {
namespace {

constexpr double bulk = 67.5e3;
constexpr double shear = 25.9e3;
constexpr double strain = 1e-6;  // small: the quadratic terms of the extension are this much beside the linear ones

/// One particle in the middle of a lattice just large enough for its whole neighbourhood.
struct Middle {
  Middle(deck::Dimension dimension, double ratio, deck::Quadrature quadrature, deck::Influence influence)
      : scene(build(dimension, ratio, quadrature, influence)), point(scene.owned() / 2) {}

  static mechanics::Scene build(deck::Dimension dimension, double ratio, deck::Quadrature quadrature,
                                deck::Influence influence) {
    const int side = 2 * static_cast<int>(ratio + 0.5) + 1;
    deck::Deck deck = lattice_deck(dimension, {side, side, side}, 0.25, ratio);
    deck.quadrature = quadrature;
    deck.influence = influence;
    const materials::ElasticConstants constants{bulk, shear};
    return make_scene(deck,
                      materials_of(std::make_unique<materials::Elastic>(constants.bulk_of(dimension), shear, true)));
  }
  mechanics::Trial under(const Matrix& gradient) const {
    return internal_force(scene, mechanics::Committed(scene), affine_field(scene, gradient)).trial;
  }
  double energy(const Matrix& gradient) const { return under(gradient).stored_energy[point]; }
  /// Shear modulus that the energy stands for, over mu: xy along the lattice, and the same shear turned by 45 degrees.
  double shear_xy() const { return energy({{{1, strain, 0}, {0, 1, 0}, {0, 0, 1}}}) / (0.5 * shear * strain * strain); }
  double shear_turned() const {
    return energy({{{1 + strain / 2, 0, 0}, {0, 1 - strain / 2, 0}, {0, 0, 1}}}) / (0.5 * shear * strain * strain);
  }
  double weighted_volume_ratio() const {
    return scene.bonds().weighted_volume[point] / scene.bonds().continuum_weighted_volume;
  }

  mechanics::Scene scene;
  LocalIndex point;
};

struct Row {
  double ratio;
  int bonds;
  double xy, turned, weighted_volume;
};
// Formulation 5, whole neighbours and linear partial volumes, as many digits as given there.
const Row whole[] = {{2.015, 32, 0.897, 1.154, 0.934},
                     {3.015, 122, 1.110, 0.835, 1.131},
                     {4.015, 256, 1.019, 0.971, 0.911},
                     {5.015, 514, 1.029, 0.956, 0.960},
                     {6.015, 924, 1.039, 0.941, 1.025}};
const Row partial[] = {{2.015, 80, 0.960, 1.060, 1.246},
                       {3.015, 178, 0.988, 1.018, 1.100},
                       {4.015, 388, 1.000, 1.000, 1.048},
                       {5.015, 738, 1.001, 0.999, 1.039},
                       {6.015, 1188, 0.997, 1.005, 1.020}};
constexpr double half_a_digit = 0.5e-3 + 1e-5;

void expect_row(const Row& row, deck::Quadrature quadrature) {
  SCOPED_TRACE(row.ratio);
  const Middle middle(deck::Dimension::three, row.ratio, quadrature, deck::Influence::constant);
  int bonds = 0;  // that count
  for (std::int64_t b = middle.scene.bonds().offset[middle.point]; b < middle.scene.bonds().offset[middle.point + 1];
       ++b)
    bonds += middle.scene.bonds().weight[b] > 0 ? 1 : 0;
  EXPECT_EQ(bonds, row.bonds);
  EXPECT_NEAR(middle.shear_xy(), row.xy, half_a_digit);
  EXPECT_NEAR(middle.shear_turned(), row.turned, half_a_digit);
  EXPECT_NEAR(middle.weighted_volume_ratio(), row.weighted_volume, half_a_digit);
}

TEST(UniformStrain, ShearModulusOfWholeNeighbours) {
  for (const Row& row : whole) expect_row(row, deck::Quadrature::whole);
}

TEST(UniformStrain, ShearModulusOfPartialVolumes) {
  for (const Row& row : partial) expect_row(row, deck::Quadrature::partial_volume);
}

TEST(UniformStrain, HydrostaticEnergyIsExact) {
  for (deck::Dimension dimension :
       {deck::Dimension::three, deck::Dimension::plane_strain, deck::Dimension::plane_stress})
    for (deck::Quadrature quadrature :
         {deck::Quadrature::whole, deck::Quadrature::partial_volume, deck::Quadrature::taper_inside})
      for (deck::Influence influence :
           {deck::Influence::constant, deck::Influence::inverse, deck::Influence::polynomial}) {
        const Middle middle(dimension, 3.015, quadrature, influence);
        const double stretch = 0.01;  // e = stretch xi at any stretch: finite too
        const mechanics::Trial trial = middle.under({{{1 + stretch, 0, 0}, {0, 1 + stretch, 0}, {0, 0, 1 + stretch}}});
        const double theta = deck::unknowns(dimension) * stretch;
        const double kappa = materials::ElasticConstants{bulk, shear}.bulk_of(dimension);
        // Every point, those at faces and corners included.
        double worst = 0;
        for (LocalIndex i = 0; i < middle.scene.owned(); ++i) {
          worst = std::max(worst, std::abs(trial.dilatation[i] / theta - 1));
          worst = std::max(worst, std::abs(trial.stored_energy[i] / (0.5 * kappa * theta * theta) - 1));
        }
        EXPECT_LE(measured("uniform strain: hydrostatic energy and dilatation", worst), 1e-12);  // 9.0e-14
      }
}

TEST(UniformStrain, DilatationIsTheTraceInside) {
  // Cubic symmetry alone makes theta = tr eps exact in small strain, and shear free of dilatation.
  const Middle middle(deck::Dimension::three, 3.015, deck::Quadrature::whole, deck::Influence::inverse);
  const Matrix gradient{
      {{1 + 3 * strain, 5 * strain, -2 * strain}, {0, 1 - strain, strain}, {0, 4 * strain, 1 + 2 * strain}}};
  // Left over: quadratic terms of the extension, of order (5 strain)^2 against 4 strain.
  EXPECT_LE(measured("uniform strain: dilatation against the trace",
                     std::abs(middle.under(gradient).dilatation[middle.point] / (4 * strain) - 1)),
            1e-5);  // 5.0e-6
}

TEST(UniformStrain, TwoDimensionalShearWithinQuadratureError) {
  // Square lattice, partial volumes. No outside value: the bound is that of the 3-D table at 3.015, the next coarser
  // row.
  for (deck::Influence influence : {deck::Influence::constant, deck::Influence::inverse}) {
    const Middle middle(deck::Dimension::plane_stress, 4.015, deck::Quadrature::partial_volume, influence);
    const std::string name = influence == deck::Influence::constant ? "constant" : "inverse";
    EXPECT_LE(measured("uniform strain: 2-D shear xy, " + name, std::abs(middle.shear_xy() - 1)),
              0.02);  // 0.0041, 0.0074
    EXPECT_LE(measured("uniform strain: 2-D shear turned, " + name, std::abs(middle.shear_turned() - 1)),
              0.02);  // 0.0041, 0.0074
  }
}

}  // namespace
}  // namespace perinox::test
