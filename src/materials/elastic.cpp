#include "perinox/materials/elastic.hpp"

#include <fmt/format.h>

namespace perinox::materials {

Elastic::Elastic(double bulk, double shear, bool with_dilatation)
    : bulk_(bulk), shear_(shear), with_dilatation_(with_dilatation) {}

PointResponse Elastic::respond(const Family& family, const double* extension, CommittedHistory, double* force_state,
                               TrialHistory) const {
  const double d = family.dimension;
  const double m = family.weighted_volume;
  const double alpha = d * (d + 2) * shear_ / m;
  double theta = 0;
  if (with_dilatation_) {
    for (int j = 0; j < family.count; ++j)
      theta += family.influence[j] * family.length[j] * extension[j] * family.weight[j];
    theta *= d / m;
  }
  const double pressure = d * bulk_ * theta / m;
  double strain_square = 0;
  for (int j = 0; j < family.count; ++j) {
    const double deviatoric = extension[j] - theta * family.length[j] / d;
    force_state[j] = family.influence[j] * (pressure * family.length[j] + alpha * deviatoric);
    strain_square += family.influence[j] * deviatoric * deviatoric * family.weight[j];
  }
  PointResponse response;
  response.dilatation = theta;
  response.stored_energy = 0.5 * (bulk_ * theta * theta + alpha * strain_square);
  return response;
}

void Elastic::modulus(const Family& family, const double*, CommittedHistory, deck::TangentForm,
                      ModulusState& modulus) const {
  const double d = family.dimension;
  const double m = family.weighted_volume;
  const double alpha = d * (d + 2) * shear_ / m;
  modulus.reset(family.count);
  double* diagonal = modulus.diagonal();
  for (int j = 0; j < family.count; ++j) diagonal[j] = alpha * family.influence[j];
  if (with_dilatation_) modulus.add_radial((d * d * bulk_ - alpha * m) / (m * m));  // (26)
}

ElasticModuli Elastic::elastic_moduli(int dimension) const {
  // Without the dilatation term W = alpha/2 sum omega e^2, which at e = xi theta/d is (d+2) mu theta^2/(2d).
  return {with_dilatation_ ? bulk_ : (dimension + 2) * shear_ / dimension, shear_};
}

std::string Elastic::summary() const {
  return fmt::format("linear peridynamic solid, kappa {:g}, mu {:g}, no history{}", bulk_, shear_,
                     with_dilatation_ ? "" : ", dilatation off");
}

namespace {

std::unique_ptr<Material> make_elastic(const deck::Material& material, deck::Dimension dimension) {
  const ElasticConstants constants = elastic_constants(material);
  return std::make_unique<Elastic>(constants.bulk_of(dimension), constants.shear,
                                   material.parameters.at("dilatation").boolean());
}

PERINOX_REGISTER_MATERIAL(
    elastic,
    (Model{{"elastic", "Linear peridynamic solid (Mitchell 2011, Eq. 24-26) in 3-D, plane strain and plane stress.",
            elastic_keys()},
           make_elastic}));

}  // namespace

}  // namespace perinox::materials
