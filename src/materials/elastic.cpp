#include "elastic.hpp"

#include <fmt/format.h>

namespace perinox::materials {

Elastic::Elastic(double bulk, double shear, bool with_dilatation, deck::Dimension dimension)
    : bulk_(bulk), shear_(shear), with_dilatation_(with_dilatation), dimension_(dimension) {}

PointState Elastic::state(const FamilySums& sums, const double*, double*) const {
  const double d = sums.dimension;
  const double m = sums.weighted_volume;
  const double alpha = d * (d + 2) * shear_ / sums.deviatoric_volume();
  PointState point;
  const double theta = with_dilatation_ ? d / m * sums.extension : 0;
  point.mean = theta / d;
  point.shear = alpha;
  point.pressure = bulk_ * theta;
  point.radial = d * point.pressure / m - alpha * point.mean;
  point.response.dilatation = theta;
  // Out of the plane, sigma = lambda theta in plane strain and eps = -lambda/(lambda + 2 mu) theta in plane stress. The
  // plane bulk moduli are lambda + mu, and lambda + mu less lambda^2/(lambda + 2 mu).
  if (dimension_ == deck::Dimension::plane_strain) point.response.stress_zz = (bulk_ - shear_) * theta;
  if (dimension_ == deck::Dimension::plane_stress) point.response.strain_zz = -(bulk_ - shear_) / (2 * shear_) * theta;
  point.response.unflowed_energy = point.response.stored_energy =
      0.5 * (bulk_ * theta * theta + alpha * sums.square_about(point.mean));
  return point;
}

PointModulus Elastic::modulus(const FamilySums& sums, const double*, deck::TangentForm) const {
  const double d = sums.dimension;
  const double m = sums.weighted_volume;
  PointModulus point;
  point.shear = d * (d + 2) * shear_ / sums.deviatoric_volume();
  if (!with_dilatation_) return point;
  point.mean = sums.extension / m;
  point.bulk = bulk_;
  point.radial = (d * d * bulk_ - point.shear * m) / (m * m);  // (26)
  return point;
}

ElasticModuli Elastic::elastic_moduli(int dimension) const {
  // Without the dilatation term W = alpha/2 sum omega e^2, which is (d+2) mu theta^2/(2d) for e = xi theta/d.
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
                                   material.parameters.at("dilatation").boolean(), dimension);
}

PERINOX_REGISTER_MATERIAL(
    elastic,
    (Model{{"elastic", "Linear peridynamic solid (Mitchell 2011, Eq. 24-26) in 3-D, plane strain and plane stress.",
            elastic_keys()},
           make_elastic}));

}  // namespace

}  // namespace perinox::materials
