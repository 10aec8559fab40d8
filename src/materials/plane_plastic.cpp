#include "plane_plastic.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace perinox::materials {

namespace {
constexpr double kink = 1e-12;  // the same margin as in three dimensions
constexpr int multiplier = 0;
constexpr int equivalent_strain = 1;
constexpr int strain_zz = 2;
const double root3 = std::sqrt(3.0);
}  // namespace

PlanePlastic::PlanePlastic(const ElasticPlastic::Parameters& parameters, deck::Dimension dimension)
    : parameters_(parameters),
      curve_(parameters.curve()),
      overlay_(parameters.kinematic_shear / parameters.shear),
      stress_(dimension == deck::Dimension::plane_stress),
      plane_bulk_(ElasticConstants{parameters.bulk, parameters.shear}.bulk_of(dimension)),
      out_modulus_(plane_bulk_ + 3 * parameters.kinematic_shear) {}

HistoryLayout PlanePlastic::history() const {
  return {{"plastic_multiplier", "equivalent_plastic_strain", "plastic_strain_zz"}, 1};
}

PlanePlastic::Return PlanePlastic::return_to_yield(const FamilySums& sums, const double* committed) const {
  const double mu = parameters_.shear, m = sums.weighted_volume;
  Return r;
  r.alpha = 8 * mu / sums.deviatoric_volume();
  r.dilatation = 2 / m * sums.extension;
  r.energy = r.alpha * sums.square_about(r.dilatation / 2);
  const double z = committed[strain_zz];
  r.out = stress_ ? plane_bulk_ * r.dilatation + out_modulus_ * z : -(1 + overlay_) * z - r.dilatation / 3;
  const double plastic_shear = root3 * committed[equivalent_strain];
  const double trial = std::sqrt(mu * r.energy + (stress_ ? r.out * r.out / 3 : 3 * mu * mu * r.out * r.out));
  if (trial <= curve_.stress(plastic_shear) * (1 + kink)) return r;
  r.yielding = true;
  if (stress_)
    flow_in_plane_stress(trial, plastic_shear, r);
  else
    flow_in_plane_strain(trial, plastic_shear, r);
  return r;
}

/// The return in plane strain. All deviatoric components shrink alike, so it has a closed form.
void PlanePlastic::flow_in_plane_strain(double trial, double plastic_shear, Return& r) const {
  const double mu = parameters_.shear, falls = (1 + overlay_) * mu;
  const HardeningCurve::Flow flow =
      curve_.flow(plastic_shear, [&](double stress, double slope) { return (trial - stress) / (falls + slope); });
  r.plastic_shear = flow.strain;
  r.potential = flow.work;
  r.shear = r.rest = 1 - falls * flow.strain / trial;
  r.flow = r.alpha * r.alpha * mu / (trial * trial * (1 + overlay_)) * (flow.slope / (falls + flow.slope) - r.shear);
  r.flow_pressure = -mu * r.out / r.alpha;
}

void PlanePlastic::flow_in_plane_stress(double trial, double plastic_shear, Return& r) const {
  const HardeningCurve::Flow flow = curve_.flow(
      plastic_shear, [&](double stress, double slope) { return meet_in_plane_stress(trial, stress, slope, r); });
  r.plastic_shear = flow.strain;
  r.potential = flow.work;
}

/// Solves the return in plane stress on one line of the hardening curve. The deviator shrinks by A = 1/(1 + (1 + h) mu
/// D) and the mean stress by B = 1/(1 + (K2 + 3 H_k) D/3), where D = Delta gamma/T. This leaves the one equation F =
/// T(D) (1 - slope D) - stress = 0, whose left side falls.
double PlanePlastic::meet_in_plane_stress(double trial, double stress, double slope, Return& r) const {
  const double mu = parameters_.shear, falls = (1 + overlay_) * mu, k = out_modulus_;
  double d = 0, t = trial, derivative = 0;
  const auto evaluate = [&] {
    const double a = 1 / (1 + falls * d), b = 1 / (1 + k * d / 3);
    t = std::sqrt(mu * r.energy * a * a + r.out * r.out * b * b / 3);
    const double t_slope = -(mu * falls * r.energy * a * a * a + k * r.out * r.out * b * b * b / 9) / t;
    derivative = (1 - slope * d) * t_slope - slope * t;
    r.shear = a;
    r.rest = b;
    return t * (1 - slope * d) - stress;
  };
  // With slope >= 0 Newton comes from the left, where the curve bends upward, and passes the root by rounding at most.
  // A falling line, or one that crosses zero stress before this yield strain, needs the bracket.
  double value = evaluate(), low = 0, high = std::numeric_limits<double>::infinity();
  for (int k_newton = 0; k_newton < 100; ++k_newton) {
    (value > 0 ? low : high) = d;
    double next = d - value / derivative;
    if (!(next >= low && next <= high))
      next = high < std::numeric_limits<double>::infinity() ? (low + high) / 2 : 2 * d;
    const double step = next - d;
    d = next;
    value = evaluate();
    if (std::abs(step) <= 1e-15 * d) break;
  }
  const double scale = mu * r.shear * r.shear * r.alpha;
  r.flow = (1 - slope * d) / (t * derivative) * scale * scale;
  r.flow_pressure = plane_bulk_ / 3 * r.rest * r.rest * r.out / scale;
  return d * t;
}

PointState PlanePlastic::state(const FamilySums& sums, const double* committed, double* trial) const {
  const double mu = parameters_.shear, h = overlay_, theta3 = sums.extension * 2 / (3 * sums.weighted_volume);
  const Return r = return_to_yield(sums, committed);
  const double out = r.rest * r.out;
  trial[multiplier] = committed[multiplier] + (r.yielding ? (1 / r.shear - 1) / ((1 + h) * r.alpha) : 0);
  trial[equivalent_strain] = committed[equivalent_strain] + r.plastic_shear / root3;
  trial[strain_zz] = committed[strain_zz];
  if (r.yielding) trial[strain_zz] += stress_ ? (out - r.out) / out_modulus_ : (r.out - out) / (1 + h);

  PointState point;
  point.mean = r.dilatation / 2;
  point.shear = (r.shear + h) / (1 + h) * r.alpha;
  point.back = h / (1 + h) * r.alpha;
  const double z = trial[strain_zz];
  point.pressure = stress_ ? (h > 0 ? plane_bulk_ * (r.dilatation + z) : out)
                           : parameters_.bulk * r.dilatation - mu * (out - h * theta3) / (1 + h);
  point.radial =
      2 * point.pressure / sums.weighted_volume - point.shear * point.mean + (point.shear - point.back) * tilt(sums);
  point.flow = 1 - r.shear;

  PointResponse& response = point.response;
  response.dilatation = r.dilatation;
  const double total = h > 0 ? h * r.alpha * sums.total_about(point.mean) : 0;
  const auto energy = [&](double shear, double out_of_plane, double plastic_zz) {
    const double deviatoric = (shear * shear * r.energy + total) / (1 + h);
    if (!stress_)
      return 0.5 * (deviatoric + parameters_.bulk * r.dilatation * r.dilatation +
                    3 * mu * (out_of_plane * out_of_plane + h * theta3 * theta3) / (1 + h));
    const double elastic = r.dilatation + plastic_zz;
    return 0.5 *
           (deviatoric + plane_bulk_ * elastic * elastic + 3 * parameters_.kinematic_shear * plastic_zz * plastic_zz);
  };
  response.stored_energy = energy(r.shear, out, z);
  response.unflowed_energy = energy(1, r.out, committed[strain_zz]);
  response.dissipation = r.potential;
  response.hardening_potential = r.potential;
  response.yielding = r.yielding;
  if (stress_)
    response.strain_zz = z - (plane_bulk_ - mu) / (2 * mu) * (r.dilatation + z);
  else
    response.stress_zz = parameters_.bulk * r.dilatation - 2 * mu * (theta3 + z);
  return point;
}

double PlanePlastic::plastic_work(const double* point) const { return curve_.work(root3 * point[equivalent_strain]); }

PointModulus PlanePlastic::modulus(const FamilySums& sums, const double* committed, deck::TangentForm) const {
  const double m = sums.weighted_volume, h = overlay_;
  const Return r = return_to_yield(sums, committed);
  PointModulus point;
  point.shear = (r.shear + h) / (1 + h) * r.alpha;
  point.bulk = stress_ ? plane_bulk_ * (plane_bulk_ * r.rest + 3 * parameters_.kinematic_shear) / out_modulus_
                       : parameters_.bulk + (r.rest + h) / (1 + h) * parameters_.shear / 3;
  point.radial = (4 * point.bulk - point.shear * m) / (m * m);
  point.flow = r.flow;
  point.flow_pressure = r.flow_pressure;
  point.mean = r.dilatation / 2 - tilt(sums) - 2 * r.flow_pressure / m;
  return point;
}

ElasticModuli PlanePlastic::elastic_moduli(int) const { return {plane_bulk_, parameters_.shear}; }

std::string PlanePlastic::summary() const {
  return fmt::format(
      "elastic-plastic in plane {}, k {:g}, mu {:g}, yield {:g} in shear ({:g} in tension), {}, history: e_p a bond, "
      "lambda, equivalent plastic strain and plastic strain zz a point",
      stress_ ? "stress" : "strain", parameters_.bulk, parameters_.shear, curve_.stress(0), root3 * curve_.stress(0),
      parameters_.hardening());
}

}  // namespace perinox::materials
