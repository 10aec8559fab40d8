#pragma once
#include <array>
#include <string>
#include <vector>

#include "perinox/materials/strain_fit.hpp"

namespace perinox::materials {

/// The bonds of one point as the point formulas see them. Arrays have `count` entries and are not owned.
struct Family {
  int dimension = 3;                     ///< d of the formulas: 3 or 2
  int count = 0;                         ///< bonds
  const double* length = nullptr;        ///< xi, length
  const double* influence = nullptr;     ///< omega(xi)
  const double* weight = nullptr;        ///< neighbour's volume times its quadrature share, volume
  double weighted_volume = 0;            ///< m = sum omega xi^2 weight (Eq. 8)
  double deviatoric_volume = 0;          ///< takes the place of m in alpha and in the yield value; 0: m itself
  double continuum_weighted_volume = 0;  ///< m of a full continuous neighbourhood
  double broken_volume = 0;              ///< share of m that belongs to broken bonds
  bonds::BrokenExtension broken_extension;
  bonds::BrokenElastic broken_elastic;
  /// Moment of a point whose strain is fitted; null where the plain formulas are used.
  const bonds::Moment* moment = nullptr;
  const double* basis = nullptr;  ///< [count * mandel_size] xi N, length; only with a moment
};

/// The sums over a family that an ordinary material's point formulas need, where a . b = sum a b weight. A broken bond
/// has lost its elastic extension and no more, so it stays in the sums with the e = e_p that it broke with.
struct FamilySums {
  double extension = 0;  ///< (omega xi) . e
  double plastic = 0;    ///< (omega xi) . e_p
  double square = 0;     ///< sum omega (e - e_p - shift xi)^2 weight
  double total = 0;      ///< sum omega (e - shift xi)^2 weight; only for a material with a back stress
  double shift = 0;      ///< any number near theta/d; the nearer it is, the less cancels
  double weighted_volume = 0;
  double corrected_volume = 0;  ///< see deviatoric_volume()
  double continuum_weighted_volume = 0;
  int dimension = 3;
  bool fitted = false;  ///< extension is m theta/d, square and total are those of StrainFit, which need no mean

  /// Adds broken bonds to the sums of the others. volume: their share of m. The sums of a fit do not need this, because
  /// broken bonds are added to them before the fit.
  void add_broken(double volume, const bonds::BrokenExtension& all, const bonds::BrokenElastic& elastic) {
    double whole = 0, part = 0;  // traces
    for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k) {
      whole += all.fit[k];
      part += elastic.fit[k];
    }
    extension += whole;
    plastic += whole - part;
    square += shift * shift * volume - 2 * shift * part + elastic.square;
    total += shift * shift * volume - 2 * shift * whole + all.square;
  }

  /// The volume that stands for m in alpha = d(d+2) mu/m and in the yield value. It is m, unless a surface correction
  /// gives another one.
  double deviatoric_volume() const { return corrected_volume > 0 ? corrected_volume : weighted_volume; }
  /// sum omega (e - e_p - mean xi)^2 weight, or what takes its place where the strain is fitted.
  double square_about(double mean) const { return moved(square, extension - plastic, mean); }
  /// sum omega (e - mean xi)^2 weight, or what takes its place where the strain is fitted.
  double total_about(double mean) const { return moved(total, extension, mean); }

 private:
  double moved(double about_shift, double first, double mean) const {
    if (fitted) return about_shift;
    const double away = mean - shift;
    const double value = about_shift - 2 * away * (first - shift * weighted_volume) + away * away * weighted_volume;
    return value > 0 ? value : 0;
  }
};

/// History of one point at the last converged step. It is read-only.
struct CommittedHistory {
  const double* point = nullptr;  ///< [HistoryLayout::point.size()]
  const double* bond = nullptr;   ///< [count * HistoryLayout::per_bond], bond-major
};

/// History of the same point in the state under trial.
struct TrialHistory {
  double* point = nullptr;
  double* bond = nullptr;
};

/// The history variables that a material carries. An elastic material carries none.
struct HistoryLayout {
  std::vector<std::string> point;  ///< names of the point variables, which are also output fields
  int per_bond = 0;
};

/// The results of one evaluation of a point besides its force state.
struct PointResponse {
  double dilatation = 0;           ///< theta (Eq. 9), dimensionless
  double stored_energy = 0;        ///< recoverable energy a volume, W
  double unflowed_energy = 0;      ///< the stored energy if nothing had flowed in this step
  double dissipation = 0;          ///< plastic work of this step, the yield stress over its flow, energy a volume, >= 0
  double hardening_potential = 0;  ///< work of the yield value over the step's flow; W plus this is the potential of t
  bool yielding = false;           ///< plastic flow in this step
  double stress_zz = 0;            ///< 2-D: stress out of the plane
  double strain_zz = 0;            ///< 2-D: strain out of the plane
};

/// The force state of one point, t<xi> = omega (radial xi + shear (e - e_p) + back e_p), and what follows from it.
struct PointState {
  PointResponse response;
  double radial = 0;
  double shear = 0;
  double back = 0;      ///< 0 except for a material with a back stress
  double pressure = 0;  ///< kappa theta, which takes the place of `radial` where the strain is fitted
  double mean = 0;      ///< theta/d
  double flow = 0;      ///< e_p grows by flow (e - mean xi - e_p) when the state is committed
};

/// The tensor H of a fitted point, whose force state is omega (shear (e - e_p) + back e_p + xi N . H) (docs/theory.md,
/// section 8).
Mandel force_of_fit(const bonds::Moment& moment, const StrainFit& fit, const PointState& point);

/// The linearisation of a point's force state, dt<xi> = omega shear de + radial (omega xi)(omega xi . de) + flow q (q .
/// de), with q = omega (e - mean xi - e_p) (docs/theory.md, section 5). Where the strain is fitted,
/// strain_modulus(bulk, shear) takes the place of `radial`, and q is omega (e - e_p + xi N . (g + flow_pressure M^-1
/// I)).
struct PointModulus {
  double shear = 0;
  double radial = 0;
  double bulk = 0;  ///< kappa
  double flow = 0;
  double flow_pressure = 0;  ///< share of theta's derivative in q; mean is theta/d - d flow_pressure/m
  double mean = 0;
  bool diagonal_only = false;  ///< only the diagonal of the last term counts, as the source paper prints it
};

/// The tensor that takes the place of -mean in q of a fitted point: g + flow_pressure M^-1 I.
Mandel slope_of_fit(const bonds::Moment& moment, const StrainFit& fit, const PointModulus& point);

/// The linearisation of one point's scalar force state,
///     dt<zeta> = D<zeta> de<zeta> + sum_r c_r p_r<zeta> (q_r . de),     a . b = sum a b weight.
/// A material fills it and the loops over bonds read it. They know nothing else of a material (docs/theory.md, section
/// 5).
class ModulusState {
 public:
  static constexpr int max_rank = 8;
  /// One rank-one term. The radial term has p = q = omega xi and needs no arrays.
  struct Term {
    double coefficient = 0;
    bool radial = false;
    const double* p = nullptr;  ///< [count], unless radial
    const double* q = nullptr;  ///< [count]; may be p
  };

  /// Forgets the last point and makes room for `count` bonds.
  void reset(int count);
  double* diagonal() { return diagonal_.data(); }
  const double* diagonal() const { return diagonal_.data(); }
  /// Adds the term c (omega xi) (omega xi . de).
  void add_radial(double coefficient);
  /// Adds the term c p (p . de) and returns p, [count], which the caller fills.
  double* add_symmetric(double coefficient);

  int rank() const { return rank_; }
  const Term& term(int r) const { return terms_[static_cast<std::size_t>(r)]; }

 private:
  int count_ = 0;
  int rank_ = 0;
  std::vector<double> diagonal_;
  std::array<std::vector<double>, max_rank> storage_;
  std::array<Term, max_rank> terms_;
};

}  // namespace perinox::materials
