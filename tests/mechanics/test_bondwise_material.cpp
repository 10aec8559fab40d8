/// A material that is no law of sums: the solid of docs/adding_a_material.md, whose bonds stiffen one by one. Its
/// scenes take the loops over stored bonds; the tangent is the derivative of the force there too, and the program runs
/// it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "materials/elastic.hpp"
#include "support/load_states.hpp"
#include "support/measured.hpp"

namespace perinox::materials {
namespace {

/// Elastic solid whose bonds stiffen as they are sheared: with b = `stiffening`,
///     W = kappa theta^2/2 + alpha sum omega phi(e_d) weight,   phi = e_d^2/2 + b e_d^4/(4 xi^2).
/// b = 0 is the linear peridynamic solid.
class Stiffening : public Material {
 public:
  Stiffening(double bulk, double shear, double stiffening) : bulk_(bulk), shear_(shear), stiffening_(stiffening) {}

  bool from_sums() const override { return false; }  // phi' is no linear function of the extension
  using Material::modulus;
  PointResponse respond(const Family& family, const double* extension, CommittedHistory committed, double* force_state,
                        TrialHistory trial) const override;
  void modulus(const Family& family, const double* extension, CommittedHistory committed, deck::TangentForm form,
               ModulusState& modulus) const override;
  ElasticModuli elastic_moduli(int) const override { return {bulk_, shear_}; }
  std::string summary() const override;

 private:
  double dilatation(const Family& family, const double* extension) const;

  double bulk_;
  double shear_;
  double stiffening_;
};

double Stiffening::dilatation(const Family& family, const double* extension) const {
  double sum = 0;
  for (int j = 0; j < family.count; ++j)
    sum += family.influence[j] * family.length[j] * extension[j] * family.weight[j];
  return family.dimension * sum / family.weighted_volume;
}

PointResponse Stiffening::respond(const Family& family, const double* extension, CommittedHistory, double* force_state,
                                  TrialHistory) const {
  const double d = family.dimension;
  const double m = family.weighted_volume;
  const double alpha = d * (d + 2) * shear_ / m;
  PointResponse response;
  response.dilatation = dilatation(family, extension);
  // t = d kappa theta/m omega xi + alpha omega (phi' - xi P/m), P = sum omega xi phi' weight
  double projection = 0;
  double potential = 0;
  for (int j = 0; j < family.count; ++j) {
    const double xi = family.length[j];
    const double deviatoric = extension[j] - response.dilatation * xi / d;
    const double quartic = stiffening_ * deviatoric * deviatoric / (xi * xi);
    force_state[j] = deviatoric * (1 + quartic);  // phi'
    projection += family.influence[j] * xi * force_state[j] * family.weight[j];
    potential += family.influence[j] * deviatoric * deviatoric * (0.5 + 0.25 * quartic) * family.weight[j];
  }
  for (int j = 0; j < family.count; ++j) {
    const double xi = family.length[j];
    force_state[j] = family.influence[j] *
                     (d * bulk_ * response.dilatation / m * xi + alpha * (force_state[j] - xi * projection / m));
  }
  response.stored_energy = 0.5 * bulk_ * response.dilatation * response.dilatation + alpha * potential;
  return response;
}

void Stiffening::modulus(const Family& family, const double* extension, CommittedHistory, deck::TangentForm,
                         ModulusState& modulus) const {
  const double d = family.dimension;
  const double m = family.weighted_volume;
  const double alpha = d * (d + 2) * shear_ / m;
  const double theta = dilatation(family, extension);
  // With r = omega xi, g = omega xi phi'' and S = sum omega xi^2 phi'' weight:
  //     dt = alpha omega phi'' de + (d^2 kappa + alpha S)/m^2 r (r . de) - alpha/m (g (r . de) + r (g . de)),
  // and g r + r g = ((g + r)(g + r) - (g - r)(g - r))/2 is a sum of two symmetric terms.
  modulus.reset(family.count);
  std::vector<double> curvature(static_cast<std::size_t>(family.count));
  double sum = 0;
  for (int j = 0; j < family.count; ++j) {
    const double xi = family.length[j];
    const double deviatoric = extension[j] - theta * xi / d;
    curvature[static_cast<std::size_t>(j)] = 1 + 3 * stiffening_ * deviatoric * deviatoric / (xi * xi);  // phi''
    modulus.diagonal()[j] = alpha * family.influence[j] * curvature[static_cast<std::size_t>(j)];
    sum += family.influence[j] * xi * xi * curvature[static_cast<std::size_t>(j)] * family.weight[j];
  }
  modulus.add_radial((d * d * bulk_ + alpha * sum) / (m * m));
  for (const double sign : {1.0, -1.0}) {
    double* p = modulus.add_symmetric(-sign * alpha / (2 * m));
    for (int j = 0; j < family.count; ++j)
      p[j] = family.influence[j] * family.length[j] * (curvature[static_cast<std::size_t>(j)] + sign);
  }
}

std::string Stiffening::summary() const {
  return fmt::format("stiffening elastic solid, kappa {:g}, mu {:g}, b {:g}, no history", bulk_, shear_, stiffening_);
}

}  // namespace
}  // namespace perinox::materials

namespace perinox::test {
namespace {

mechanics::Scene stiffening_scene(double stiffening) {
  const deck::Deck deck = lattice_deck(deck::Dimension::three, {5, 4, 4}, 0.4, 2.2);
  return make_scene(deck, materials_of(std::make_unique<materials::Stiffening>(bulk, shear, stiffening)));
}

TEST(BondwiseMaterial, TangentIsTheDerivativeOfTheForce) {
  const mechanics::Scene scene = stiffening_scene(1e4);
  ASSERT_FALSE(scene.from_sums());
  const mechanics::Committed committed(scene);
  const auto tangent = mechanics::make_tangent(scene, deck::TangentForm::consistent);
  for (const LoadState::Stop& stop : {LoadState::Stop{2.0}, LoadState::Stop{20.0, 35}}) {
    const Vector here = field_of(scene, stop);
    tangent->linearise(committed, here.data(), deck::TangentForm::consistent);
    const Vector direction = random_field(scene, 1, 17);
    EXPECT_LE(measured("bondwise material: tangent against differences",
                       tangent_error(scene, committed, here, direction, *tangent)),
              1e-8);  // 3e-10
    EXPECT_LE(asymmetry(*tangent, direction, random_field(scene, 1, 18)), 1e-14);
  }
}

TEST(BondwiseMaterial, WithoutStiffeningIsTheLinearSolid) {
  const mechanics::Scene bondwise = stiffening_scene(0);
  const deck::Deck deck = lattice_deck(deck::Dimension::three, {5, 4, 4}, 0.4, 2.2);
  const mechanics::Scene linear =
      make_scene(deck, materials_of(std::make_unique<materials::Elastic>(bulk, shear, true)));
  const Vector here = field_of(linear, {5.0, 20});
  const Answer one = internal_force(bondwise, mechanics::Committed(bondwise), here);
  const Answer other = internal_force(linear, mechanics::Committed(linear), here);
  EXPECT_LE(measured("bondwise material: force of the linear solid", relative_difference(one.force, other.force)),
            1e-12);  // 4e-14
  EXPECT_NEAR(one.trial.stored / other.trial.stored, 1, 1e-12);
}

}  // namespace
}  // namespace perinox::test
