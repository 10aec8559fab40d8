#include "perinox/materials/plane_plastic.hpp"

#include <fmt/format.h>

#include <cmath>

namespace perinox::materials {

namespace {
constexpr double kink = 1e-12;  // as in three dimensions
constexpr int multiplier = 0;
constexpr int equivalent_strain = 1;
constexpr int strain_zz = 2;
const double root3 = std::sqrt(3.0);
}  // namespace

PlanePlastic::PlanePlastic(const ElasticPlastic::Parameters& parameters, deck::Dimension dimension)
    : parameters_(parameters),
      stress_(dimension == deck::Dimension::plane_stress),
      plane_bulk_(ElasticConstants{parameters.bulk, parameters.shear}.bulk_of(dimension)) {}

HistoryLayout PlanePlastic::history() const {
  return {{"plastic_multiplier", "equivalent_plastic_strain", "plastic_strain_zz"}, 1};
}

PlanePlastic::Return PlanePlastic::return_to_yield(const FamilySums& sums, const double* committed) const {
  const double mu = parameters_.shear, m = sums.weighted_volume;
  Return r;
  r.alpha = 8 * mu / m;
  r.dilatation = 2 / m * sums.extension;
  r.energy = r.alpha * sums.square_about(r.dilatation / 2);
  const double z = committed[strain_zz];
  r.out = stress_ ? plane_bulk_ * (r.dilatation + z) : -z - r.dilatation / 3;
  const double hardening = parameters_.hardening_shear;
  r.tau = parameters_.yield_shear + hardening * root3 * committed[equivalent_strain];
  const double trial = std::sqrt(mu * r.energy + (stress_ ? r.out * r.out / 3 : 3 * mu * mu * r.out * r.out));
  if (trial <= r.tau * (1 + kink)) return r;
  r.yielding = true;
  if (stress_)
    flow_in_plane_stress(trial, hardening, r);
  else
    flow_in_plane_strain(trial, hardening, r);
  r.potential = (r.tau + 0.5 * hardening * r.plastic_shear) * r.plastic_shear;
  return r;
}

/// All deviatoric components shrink alike: closed.
void PlanePlastic::flow_in_plane_strain(double trial, double hardening, Return& r) const {
  const double mu = parameters_.shear;
  r.plastic_shear = (trial - r.tau) / (mu + hardening);
  r.shear = r.rest = 1 - mu * r.plastic_shear / trial;
  r.flow = r.alpha * r.alpha * mu / (trial * trial) * (hardening / (mu + hardening) - r.shear);
  r.flow_pressure = -mu * r.out / r.alpha;
}

/// The deviator shrinks by A = 1/(1 + mu D), the mean stress by B = 1/(1 + K2 D/3), D = Delta gamma/T: one equation
/// T(D) (1 - H D) = tau, whose left side falls.
void PlanePlastic::flow_in_plane_stress(double trial, double hardening, Return& r) const {
  const double mu = parameters_.shear, k = plane_bulk_;
  double d = 0, t = trial, slope = 0;
  const auto evaluate = [&] {
    const double a = 1 / (1 + mu * d), b = 1 / (1 + k * d / 3);
    t = std::sqrt(mu * r.energy * a * a + r.out * r.out * b * b / 3);
    const double t_slope = -(mu * mu * r.energy * a * a * a + k * r.out * r.out * b * b * b / 9) / t;
    slope = (1 - hardening * d) * t_slope - hardening * t;
    r.shear = a;
    r.rest = b;
    return t * (1 - hardening * d) - r.tau;
  };
  // Newton from the left, where the curve bends upward: it never passes the root, but by rounding.
  double value = evaluate();
  for (int k_newton = 0; k_newton < 60; ++k_newton) {
    const double step = -value / slope;
    d += step;
    value = evaluate();
    if (std::abs(step) <= 1e-15 * d) break;
  }
  r.plastic_shear = d * t;
  const double scale = mu * r.shear * r.shear * r.alpha;
  r.flow = (1 - hardening * d) / (t * slope) * scale * scale;
  r.flow_pressure = k / 3 * r.rest * r.rest * r.out / scale;
}

PointState PlanePlastic::state(const FamilySums& sums, const double* committed, double* trial) const {
  const double mu = parameters_.shear;
  const Return r = return_to_yield(sums, committed);
  const double out = r.rest * r.out;
  PointState point;
  point.mean = r.dilatation / 2;
  point.shear = r.shear * r.alpha;
  point.pressure = stress_ ? out : parameters_.bulk * r.dilatation - mu * out;
  point.radial = 2 * point.pressure / sums.weighted_volume - point.shear * point.mean;
  point.flow = 1 - r.shear;
  trial[multiplier] = committed[multiplier] + (r.yielding ? (1 / r.shear - 1) / r.alpha : 0);
  trial[equivalent_strain] = committed[equivalent_strain] + r.plastic_shear / root3;
  trial[strain_zz] = committed[strain_zz];
  if (r.yielding) trial[strain_zz] += stress_ ? (out - r.out) / plane_bulk_ : r.out - out;

  PointResponse& response = point.response;
  response.dilatation = r.dilatation;
  const double volumetric =
      stress_ ? out * out / plane_bulk_ : parameters_.bulk * r.dilatation * r.dilatation + 3 * mu * out * out;
  response.stored_energy = 0.5 * (volumetric + r.shear * r.shear * r.energy);
  response.dissipation = r.potential;
  response.hardening_potential = r.potential;
  response.yielding = r.yielding;
  const double z = trial[strain_zz];
  if (stress_)
    response.strain_zz = z - (plane_bulk_ - mu) / (2 * mu) * (r.dilatation + z);
  else
    response.stress_zz = parameters_.bulk * r.dilatation + 2 * mu * out;
  return point;
}

double PlanePlastic::plastic_work(const double* point) const {
  const double plastic_shear = root3 * point[equivalent_strain];
  return (parameters_.yield_shear + 0.5 * parameters_.hardening_shear * plastic_shear) * plastic_shear;
}

PointModulus PlanePlastic::modulus(const FamilySums& sums, const double* committed, deck::TangentForm) const {
  const double m = sums.weighted_volume;
  const Return r = return_to_yield(sums, committed);
  PointModulus point;
  point.shear = r.shear * r.alpha;
  point.bulk = stress_ ? plane_bulk_ * r.rest : parameters_.bulk + r.rest * parameters_.shear / 3;
  point.radial = (4 * point.bulk - point.shear * m) / (m * m);
  point.flow = r.flow;
  point.flow_pressure = r.flow_pressure;
  point.mean = r.dilatation / 2 - 2 * r.flow_pressure / m;
  return point;
}

ElasticModuli PlanePlastic::elastic_moduli(int) const { return {plane_bulk_, parameters_.shear}; }

std::string PlanePlastic::summary() const {
  return fmt::format(
      "elastic-plastic in plane {}, k {:g}, mu {:g}, yield {:g} in shear ({:g} in tension), {}, history: e_p a bond, "
      "lambda, equivalent plastic strain and plastic strain zz a point",
      stress_ ? "stress" : "strain", parameters_.bulk, parameters_.shear, parameters_.yield_shear,
      root3 * parameters_.yield_shear,
      parameters_.hardening_shear > 0 ? fmt::format("hardening {:g} in shear", parameters_.hardening_shear)
                                      : std::string("perfectly plastic"));
}

}  // namespace perinox::materials
