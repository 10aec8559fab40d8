/// The bond-by-bond forms of the point formulas: they spread coefficients over the bonds of one family.
#include <Eigen/Eigenvalues>
#include <stdexcept>

#include "perinox/materials/material.hpp"

namespace perinox::materials {

namespace {

FamilySums sums_of(const Family& family, const double* extension, const double* plastic) {
  FamilySums sums;
  sums.dimension = family.dimension;
  sums.weighted_volume = family.weighted_volume;
  sums.corrected_volume = family.deviatoric_volume;
  sums.continuum_weighted_volume = family.continuum_weighted_volume;
  for (int j = 0; j < family.count; ++j) {
    const double radial = family.influence[j] * family.length[j] * family.weight[j];
    sums.extension += radial * extension[j];
    if (plastic) sums.plastic += radial * plastic[j];
  }
  sums.shift = sums.extension / sums.weighted_volume;
  for (int j = 0; j < family.count; ++j) {
    const double elastic = extension[j] - sums.shift * family.length[j] - (plastic ? plastic[j] : 0);
    const double all = extension[j] - sums.shift * family.length[j];
    sums.square += family.influence[j] * elastic * elastic * family.weight[j];
    sums.total += family.influence[j] * all * all * family.weight[j];
  }
  sums.add_broken(family.broken_volume, family.broken_extension, family.broken_elastic);
  return sums;
}

/// The sums of a fitted family together with its fit.
struct FittedSums {
  FamilySums sums;
  StrainFit fit;
};
FittedSums fitted_sums_of(const Family& family, const double* extension, const double* plastic) {
  FittedSums all;
  all.sums = sums_of(family, extension, plastic);
  if (!family.moment) return all;
  const int n = bonds::mandel_size(family.dimension);
  Mandel strain = family.broken_extension.fit, flowed = family.broken_extension.fit;
  for (std::size_t k = 0; k < flowed.size(); ++k) flowed[k] -= family.broken_elastic.fit[k];
  for (int j = 0; j < family.count; ++j)
    for (int k = 0; k < n; ++k) {
      const double share = family.influence[j] * family.weight[j] * family.basis[j * n + k];
      strain[k] += share * extension[j];
      if (plastic) flowed[k] += share * plastic[j];
    }
  all.fit = fit(*family.moment, strain, flowed, all.sums.square, all.sums.shift);
  fit_total(*family.moment, strain, all.sums.total, all.sums.shift, all.fit);
  all.sums.fitted = true;
  all.sums.extension = all.sums.weighted_volume * all.fit.dilatation / family.dimension;
  all.sums.square = all.fit.square;
  all.sums.total = all.fit.total;
  return all;
}

/// The number xi N . h of bond j.
double along(const Family& family, int j, const Mandel& h) {
  const int n = bonds::mandel_size(family.dimension);
  double sum = 0;
  for (int k = 0; k < n; ++k) sum += family.basis[j * n + k] * h[k];
  return sum;
}

/// Adds xi N . A sum w xi N de as rank-one terms, one for each eigenvector of A.
void add_strain_modulus(const Family& family, const PointModulus& point, ModulusState& result) {
  const int n = bonds::mandel_size(family.dimension);
  const std::array<double, 36> modulus = strain_modulus(*family.moment, point.bulk, point.shear);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> values(Eigen::Map<const Eigen::MatrixXd>(modulus.data(), n, n));
  for (int r = 0; r < n; ++r) {
    double* p = result.add_symmetric(values.eigenvalues()[r]);
    Mandel vector{};
    for (int k = 0; k < n; ++k) vector[k] = values.eigenvectors()(k, r);
    for (int j = 0; j < family.count; ++j) p[j] = family.influence[j] * along(family, j, vector);
  }
}

}  // namespace

PointState Material::state(const FamilySums&, const double*, double*) const {
  throw std::logic_error("this material has no point formulas of its family's sums");
}

PointModulus Material::modulus(const FamilySums&, const double*, deck::TangentForm) const {
  throw std::logic_error("this material has no point formulas of its family's sums");
}

PointResponse Material::respond(const Family& family, const double* extension, CommittedHistory committed,
                                double* force_state, TrialHistory trial) const {
  const double* plastic = history().per_bond > 0 ? committed.bond : nullptr;
  const FittedSums all = fitted_sums_of(family, extension, plastic);
  const PointState point = state(all.sums, committed.point, trial.point);
  Mandel h{};
  if (family.moment) h = force_of_fit(*family.moment, all.fit, point);
  for (int j = 0; j < family.count; ++j) {
    const double e_p = plastic ? plastic[j] : 0;
    const double strain = family.moment ? along(family, j, h) : point.radial * family.length[j];
    force_state[j] = family.influence[j] * (strain + point.shear * (extension[j] - e_p) + point.back * e_p);
    if (plastic) trial.bond[j] = e_p + point.flow * (extension[j] - point.mean * family.length[j] - e_p);
  }
  return point.response;
}

void Material::modulus(const Family& family, const double* extension, CommittedHistory committed,
                       deck::TangentForm form, ModulusState& result) const {
  const double* plastic = history().per_bond > 0 ? committed.bond : nullptr;
  const FittedSums all = fitted_sums_of(family, extension, plastic);
  const PointModulus point = modulus(all.sums, committed.point, form);
  result.reset(family.count);
  double* diagonal = result.diagonal();
  for (int j = 0; j < family.count; ++j) diagonal[j] = point.shear * family.influence[j];
  if (family.moment)
    add_strain_modulus(family, point, result);
  else if (point.radial != 0)
    result.add_radial(point.radial);
  if (point.flow == 0) return;
  const Mandel slope = family.moment ? slope_of_fit(*family.moment, all.fit, point) : Mandel{};
  double* flowing = point.diagonal_only ? nullptr : result.add_symmetric(point.flow);
  for (int j = 0; j < family.count; ++j) {
    const double strain = family.moment ? along(family, j, slope) : -point.mean * family.length[j];
    const double q = family.influence[j] * (extension[j] - (plastic ? plastic[j] : 0) + strain);
    if (flowing)
      flowing[j] = q;
    else
      diagonal[j] += point.flow * family.influence[j] * q * q * family.weight[j];
  }
}

}  // namespace perinox::materials
