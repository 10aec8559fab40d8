/// The point formulas spread over the bonds of one family.
#include <stdexcept>

#include "perinox/materials/material.hpp"

namespace perinox::materials {

namespace {

FamilySums sums_of(const Family& family, const double* extension, const double* plastic) {
  FamilySums sums;
  sums.dimension = family.dimension;
  sums.weighted_volume = family.weighted_volume;
  sums.continuum_weighted_volume = family.continuum_weighted_volume;
  for (int j = 0; j < family.count; ++j) {
    const double radial = family.influence[j] * family.length[j] * family.weight[j];
    sums.extension += radial * extension[j];
    if (plastic) sums.plastic += radial * plastic[j];
  }
  sums.shift = sums.extension / sums.weighted_volume;
  for (int j = 0; j < family.count; ++j) {
    const double elastic = extension[j] - sums.shift * family.length[j] - (plastic ? plastic[j] : 0);
    sums.square += family.influence[j] * elastic * elastic * family.weight[j];
  }
  return sums;
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
  const PointState point = state(sums_of(family, extension, plastic), committed.point, trial.point);
  for (int j = 0; j < family.count; ++j) {
    const double e_p = plastic ? plastic[j] : 0;
    force_state[j] = family.influence[j] * (point.radial * family.length[j] + point.shear * (extension[j] - e_p));
    if (plastic) trial.bond[j] = e_p + point.flow * (extension[j] - point.mean * family.length[j] - e_p);
  }
  return point.response;
}

void Material::modulus(const Family& family, const double* extension, CommittedHistory committed,
                       deck::TangentForm form, ModulusState& result) const {
  const double* plastic = history().per_bond > 0 ? committed.bond : nullptr;
  const PointModulus point = modulus(sums_of(family, extension, plastic), committed.point, form);
  result.reset(family.count);
  double* diagonal = result.diagonal();
  for (int j = 0; j < family.count; ++j) diagonal[j] = point.shear * family.influence[j];
  if (point.radial != 0) result.add_radial(point.radial);
  if (point.flow == 0) return;
  double* flowing = point.diagonal_only ? nullptr : result.add_symmetric(point.flow);
  for (int j = 0; j < family.count; ++j) {
    const double elastic = extension[j] - point.mean * family.length[j] - (plastic ? plastic[j] : 0);
    const double q = family.influence[j] * elastic;
    if (flowing)
      flowing[j] = q;
    else
      diagonal[j] += point.flow * family.influence[j] * q * q * family.weight[j];
  }
}

}  // namespace perinox::materials
