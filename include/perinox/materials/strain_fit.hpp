#pragma once
/// Point formulas that are exact under uniform strain whatever the family looks like.
///
/// With M and eps = M^-1 sum w xi N e of bonds/moment.hpp, an extension is e = xi N . eps + rest, the rest w-orthogonal
/// to all xi N, and the point's energy is kappa tr(eps)^2/2 + mu dev eps : dev eps + alpha/2 sum w rest^2. Where M is
/// isotropic this is the linear peridynamic solid; at surfaces and in clouds it is the same solid with its missing or
/// surplus stiffness made good. A sum of squares with positive weights: it adds no mode without energy.
#include "perinox/bonds/moment.hpp"

namespace perinox::materials {

using bonds::Mandel;

/// What the sums over a fitted family say; y = e - e_p.
struct StrainFit {
  double dilatation = 0;  ///< theta = tr eps(e)
  double square = 0;      ///< stands for sum w (e_d - e_p)^2: 2m/(d(d+2)) |dev eps(y)|^2 + sum w rest(y)^2
  Mandel slope{};         ///< g: half the derivative of `square` by e is w (y + xi N . g)
  // The same of y = e, only for a material with a back stress.
  double total = 0;
  Mandel total_slope{};
};
/// extension, plastic: sum w xi N e and e_p. square: sum w (e - e_p - shift xi)^2, the shift near theta/d.
StrainFit fit(const bonds::Moment& moment, const Mandel& extension, const Mandel& plastic, double square, double shift);
/// Fills total and total_slope; total: sum w (e - shift xi)^2.
void fit_total(const bonds::Moment& moment, const Mandel& extension, double total, double shift, StrainFit& fit);

/// M^-1 I: the force state of a pressure p = kappa theta is p w xi N . M^-1 I.
Mandel volumetric(const bonds::Moment& moment);
/// A, row-major: where t = w (shear (y + xi N . g) + p xi N . M^-1 I), dt = w (shear de + xi N . A sum w xi N de);
/// bulk: dp/dtheta.
std::array<double, 36> strain_modulus(const bonds::Moment& moment, double bulk, double shear);

}  // namespace perinox::materials
