#pragma once
/// Point formulas that are exact under uniform strain whatever the family looks like (docs/theory.md, section 8).
///
/// With M and eps = M^-1 sum w xi N e of bonds/moment.hpp, an extension is e = xi N . eps + rest, where the rest is
/// w-orthogonal to all xi N. The point's energy is kappa tr(eps)^2/2 + mu dev eps : dev eps + alpha/2 sum w rest^2.
/// Where M is isotropic this is the linear peridynamic solid. At surfaces and in clouds it is the same solid with its
/// missing or surplus stiffness made good. The energy is a sum of squares with positive weights, so it adds no mode
/// without energy.
#include "perinox/bonds/moment.hpp"

namespace perinox::materials {

using bonds::Mandel;

/// The results of the fit of one family, where y = e - e_p.
struct StrainFit {
  double dilatation = 0;  ///< theta = tr eps(e)
  double square = 0;      ///< stands for sum w (e_d - e_p)^2: 2m/(d(d+2)) |dev eps(y)|^2 + sum w rest(y)^2
  Mandel slope{};         ///< g: half the derivative of `square` by e is w (y + xi N . g)
  // The following two are those of y = e. They are filled only for a material with a back stress.
  double total = 0;
  Mandel total_slope{};
};
/// Fits the strain of one family. extension, plastic: sum w xi N e and sum w xi N e_p. square: sum w (e - e_p - shift
/// xi)^2, with the shift near theta/d.
StrainFit fit(const bonds::Moment& moment, const Mandel& extension, const Mandel& plastic, double square, double shift);
/// Fills total and total_slope of a fit. total: sum w (e - shift xi)^2.
void fit_total(const bonds::Moment& moment, const Mandel& extension, double total, double shift, StrainFit& fit);

/// The tensor M^-1 I. The force state of a pressure p = kappa theta is p w xi N . M^-1 I.
Mandel volumetric(const bonds::Moment& moment);
/// The tensor A, row-major, of the linearised force state: where t = w (shear (y + xi N . g) + p xi N . M^-1 I), dt = w
/// (shear de + xi N . A sum w xi N de). bulk: dp/dtheta.
std::array<double, 36> strain_modulus(const bonds::Moment& moment, double bulk, double shear);

}  // namespace perinox::materials
