/// Quadrature position-aware: at every point of a lattice, of a jittered cloud and of what a crack leaves, uniform
/// strain has its exact dilatation and energy, and a point yields at the yield stress whatever the direction of shear.
#include <gtest/gtest.h>

#include "perinox/mechanics/stress.hpp"
#include "support/local_plasticity.hpp"
#include "support/measured.hpp"
#include "support/scenes.hpp"

namespace perinox::test {
namespace {

constexpr double yield = 117.3;
const double pi = std::acos(-1.0);

std::vector<std::array<double, 4>> jittered(int n) {
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> jitter(-0.2, 0.2);
  std::vector<std::array<double, 4>> points;
  for (int k = 0; k < n * n * n; ++k)
    points.push_back({k % n + jitter(generator), k / n % n + jitter(generator), k / n / n + jitter(generator), 1});
  return points;
}

struct Shape {
  std::string name;
  deck::Deck deck;
};

std::vector<Shape> shapes() {
  std::vector<Shape> all;
  all.push_back({"lattice", lattice_deck(deck::Dimension::three, {9, 8, 7}, 0.25, 3.015)});
  all.push_back({"plate", lattice_deck(deck::Dimension::plane_strain, {15, 11, 1}, 0.25, 3.015)});
  all.push_back({"plane stress", lattice_deck(deck::Dimension::plane_stress, {15, 11, 1}, 0.25, 3.015)});
  all.push_back({"short horizon", lattice_deck(deck::Dimension::three, {6, 6, 6}, 0.25, 2.015)});
  all.push_back({"cracked", lattice_deck(deck::Dimension::three, {9, 8, 8}, 0.25, 3.015)});
  deck::Crack crack;
  crack.form = deck::CrackRectangle{{-1, -1, 1}, {2, 0, 0}, {0, 9, 0}};
  all.back().deck.cracks.push_back(crack);
  all.push_back({"cloud", cloud_deck(jittered(8), 3.015)});
  for (const auto influence : {deck::Influence::inverse, deck::Influence::polynomial}) {
    all.push_back({influence == deck::Influence::inverse ? "inverse" : "polynomial",
                   lattice_deck(deck::Dimension::three, {8, 7, 6}, 0.25, 3.015)});
    all.back().deck.influence = influence;
  }
  for (Shape& shape : all) {
    shape.deck.quadrature = deck::Quadrature::position_aware;
    shape.deck.small_strain = true;  // an extension linear in the strain: exact to rounding
  }
  return all;
}

/// Strains with every component, hydrostatic, and shears along and across the axes.
std::vector<Matrix> strains(int dimension) {
  std::vector<Matrix> all{{{{1e-3, 4e-4, -3e-4}, {4e-4, -7e-4, 2e-4}, {-3e-4, 2e-4, 5e-4}}},
                          {{{1e-3, 0, 0}, {0, 1e-3, 0}, {0, 0, 1e-3}}}};
  for (int a = 0; a < dimension; ++a)
    for (int b = a + 1; b < dimension; ++b) {
      Matrix across{}, along{};
      across[a][b] = across[b][a] = 5e-4;
      along[a][a] = 5e-4;
      along[b][b] = -5e-4;
      all.push_back(across);
      all.push_back(along);
    }
  return all;
}

Matrix gradient_of(const Matrix& strain) {
  Matrix gradient = strain;
  for (int c = 0; c < 3; ++c) gradient[c][c] += 1;
  return gradient;
}

TEST(PositionAware, UniformStrainIsExactEverywhere) {
  for (const Shape& shape : shapes()) {
    SCOPED_TRACE(shape.name);
    const int d = deck::unknowns(shape.deck.dimension);
    const materials::ElasticConstants constants{bulk, shear};
    const double kappa = constants.bulk_of(shape.deck.dimension);
    const mechanics::Scene scene =
        make_scene(shape.deck, materials_of(std::make_unique<materials::Elastic>(kappa, shear, true)));
    ASSERT_FALSE(scene.families().moments.empty());
    for (const Matrix& strain : strains(d)) {
      double trace = 0, square = 0;
      for (int a = 0; a < d; ++a) trace += strain[a][a];
      for (int a = 0; a < d; ++a)
        for (int b = 0; b < d; ++b) square += std::pow(strain[a][b] - (a == b ? trace / d : 0), 2);
      const double energy = kappa * trace * trace / 2 + shear * square;
      const mechanics::Trial trial =
          internal_force(scene, mechanics::Committed(scene), affine_field(scene, gradient_of(strain))).trial;
      double worst = 0, dilatation = 0;
      for (LocalIndex i = 0; i < scene.owned(); ++i) {
        worst = std::max(worst, std::abs(trial.stored_energy[i] / energy - 1));
        dilatation = std::max(dilatation, std::abs(trial.dilatation[i] - trace) / 1e-3);
      }
      EXPECT_LE(measured("position-aware: dilatation, " + shape.name, dilatation), 1e-10);
      EXPECT_LE(measured("position-aware: energy, " + shape.name, worst), 1e-10);
    }
    if (shape.name == "cloud") remove_cloud(shape.deck);
  }
}

TEST(PositionAware, CountsFamiliesThatCannotTellStrainsApart) {
  deck::Deck deck = lattice_deck(deck::Dimension::three, {8, 8, 1}, 0.25, 3.015);
  deck.quadrature = deck::Quadrature::position_aware;
  const mechanics::Scene plate =
      make_scene(deck, materials_of(std::make_unique<materials::Elastic>(bulk, shear, true)));
  EXPECT_EQ(plate.families().deficient, 64);
  EXPECT_TRUE(plate.families().moments.empty());
}

TEST(PositionAware, PlainFormulasInside) {
  deck::Deck deck = lattice_deck(deck::Dimension::three, {11, 11, 11}, 0.25, 3.015);
  deck.quadrature = deck::Quadrature::position_aware;
  const mechanics::Scene scene =
      make_scene(deck, materials_of(std::make_unique<materials::Elastic>(bulk, shear, true)));
  EXPECT_EQ(scene.families().moments.size(), 11U * 11 * 11 - 5 * 5 * 5);
  for (LocalIndex i = 0; i < scene.owned(); ++i) {
    bool inside = true;
    for (int c = 0; c < 3; ++c) inside = inside && std::abs(scene.body().position(i)[c] - 1.375) < 0.51;
    EXPECT_EQ(scene.families().moment(i) == nullptr, inside);
  }
}

/// Largest difference of the stress field, over the yield stress, and of the strain field, over the yield strain.
double fields_off(const mechanics::Scene& scene, const mechanics::Committed& committed, const LocalPlasticity& solid,
                  const Tensor& strain) {
  constexpr std::size_t place[6] = {0, 5, 4, 1, 3, 2};  // of xx xy xz yy yz zz
  const Tensor stress = solid.stress(strain);
  mechanics::Stress fields(scene);
  fields.evaluate(committed);
  double worst = 0;
  for (std::size_t k = 0; k < fields.stress().size(); ++k) {
    worst = std::max(worst, std::abs(fields.stress()[k] - stress[place[k % 6]]) / yield_shear);
    worst = std::max(worst, std::abs(fields.strain()[k] - strain[place[k % 6]]) / yield_strain);
  }
  return worst;
}

/// With every kind of hardening every point is classical J2 plasticity, along a path that loads, turns and comes back;
/// surfaces, corners, cracks and clouds included.
TEST(PositionAware, HardensAsTheLocalSolidEverywhere) {
  const std::vector<Tensor> path{
      {1, 0.4, 0, 0, 0, 2}, {4, -1, 0, 0, 0, 3}, {-3, 2, 0, 0, 0, -1}, {-3, 1.9, 0, 0, 0, -0.9}, {5, 1, 0, 0, 0, -4}};
  for (const Shape& shape : shapes()) {
    SCOPED_TRACE(shape.name);
    const deck::Dimension dimension = shape.deck.dimension;
    for (const Hardening& hardening : hardenings()) {
      SCOPED_TRACE(hardening.name);
      std::unique_ptr<materials::Material> material;
      if (dimension == deck::Dimension::three)
        material = std::make_unique<materials::ElasticPlastic>(hardening.parameters());
      else
        material = std::make_unique<materials::PlanePlastic>(hardening.parameters(), dimension);
      const mechanics::Scene scene = make_scene(shape.deck, materials_of(std::move(material)));
      ASSERT_FALSE(scene.families().moments.empty());
      mechanics::Committed committed(scene);
      LocalPlasticity solid = hardening.point();
      for (Tensor strain : path) {
        for (double& value : strain) value *= yield_strain;
        if (dimension == deck::Dimension::three) strain[2] = strain[3] = strain[4] = 0.7 * strain[0];
        if (dimension == deck::Dimension::plane_stress) strain[2] = solid.free_strain(strain);
        const Matrix gradient{{{1 + strain[0], strain[5], strain[4]},
                               {strain[5], 1 + strain[1], strain[3]},
                               {strain[4], strain[3], 1 + strain[2]}}};
        LocalPlasticity next;
        solid.stress(strain, &next);
        mechanics::Trial trial = internal_force(scene, committed, affine_field(scene, gradient)).trial;
        const double energy = next.stored_energy(strain);
        double worst = 0, flow = 0;
        for (LocalIndex i = 0; i < scene.owned(); ++i) {
          worst = std::max(worst, std::abs(trial.stored_energy[i] / energy - 1));
          const double gamma =
              std::sqrt(3.0) * trial.point_history[static_cast<std::size_t>(scene.point_history()[i]) + 1];
          flow = std::max(flow, std::abs(gamma - next.gamma) / yield_strain);
        }
        EXPECT_LE(measured("position-aware: stored energy against J2", worst), 1e-10);  // 2.6e-13
        EXPECT_LE(measured("position-aware: gamma_p against J2", flow), 1e-10);         // 8.4e-13
        commit(scene, committed, std::move(trial));
        solid = next;
        EXPECT_LE(measured("position-aware: stress and strain fields against J2",
                           fields_off(scene, committed, solid, strain)),
                  1e-10);  // 7.6e-13
      }
    }
    if (shape.name == "cloud") remove_cloud(shape.deck);
  }
}

TEST(PositionAware, YieldsAtTheYieldStressInEveryDirection) {
  for (const Shape& shape : shapes()) {
    if (shape.name == "cloud") remove_cloud(shape.deck);
    if (deck::unknowns(shape.deck.dimension) == 2 || shape.name == "cloud") continue;
    SCOPED_TRACE(shape.name);
    materials::ElasticPlastic::Parameters p;
    p.bulk = bulk;
    p.shear = shear;
    p.yield_shear = yield;
    const mechanics::Scene scene = make_scene(shape.deck, materials_of(std::make_unique<materials::ElasticPlastic>(p)));
    for (int k = 0; k < 12; ++k) {
      // Simple shear of the yield strain in plane (a, b), turned in that plane.
      const int a = k % 3, b = (a + 1) % 3;
      const double angle = pi / 2 * (k / 3) / 4;
      for (const double factor : {1 - 1e-8, 1 + 1e-8}) {
        const double half = factor * yield / shear / 2;
        Matrix strain{};
        strain[a][a] = half * std::sin(2 * angle);
        strain[b][b] = -strain[a][a];
        strain[a][b] = strain[b][a] = half * std::cos(2 * angle);
        const mechanics::Trial trial =
            internal_force(scene, mechanics::Committed(scene), affine_field(scene, gradient_of(strain))).trial;
        EXPECT_EQ(trial.yielding, factor > 1 ? scene.owned() : 0);
      }
    }
  }
}

}  // namespace
}  // namespace perinox::test
