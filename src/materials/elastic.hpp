#pragma once
#include "elastic_constants.hpp"
#include "perinox/materials/material.hpp"

namespace perinox::materials {

/// The linear peridynamic solid, Mitchell 2011 Eq. 24-26, in 3-D, plane strain and plane stress (docs/theory.md,
/// section 2).
class Elastic : public Material {
 public:
  /// bulk: kappa of the dimension at hand. If with_dilatation is false, theta is taken as zero and each bond stands
  /// alone.
  Elastic(double bulk, double shear, bool with_dilatation, deck::Dimension dimension = deck::Dimension::three);

  using Material::modulus;
  bool takes_fit() const override { return with_dilatation_; }
  PointState state(const FamilySums& sums, const double* committed, double* trial) const override;
  PointModulus modulus(const FamilySums& sums, const double* committed, deck::TangentForm form) const override;
  ElasticModuli elastic_moduli(int dimension) const override;
  std::string summary() const override;

 private:
  double bulk_;
  double shear_;
  bool with_dilatation_;
  deck::Dimension dimension_;
};

}  // namespace perinox::materials
