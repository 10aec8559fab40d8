#pragma once
#include <optional>

#include "elastic_constants.hpp"
#include "hardening_curve.hpp"
#include "perinox/materials/material.hpp"

namespace perinox::materials {

/// Tilt of the deviatoric plastic part. The e_p of a family that has lost bonds need not be deviatoric: half the
/// gradient of sums.square_about(theta/d) is then omega (e - (theta/d - tilt) xi - e_p). The tilt is 0 for a whole
/// family. It is also 0 where the strain is fitted, because the fit accounts for it.
inline double tilt(const FamilySums& sums) { return sums.fitted ? 0 : sums.plastic / sums.weighted_volume; }

/// Ordinary state-based plasticity in 3-D, Mitchell 2011 Eq. 27-45, 51-57, 63-65 with its errata corrected, for every
/// influence function (norm with the weight 1/omega; docs/theory.md, section 3). It is perfect, has isotropic hardening
/// (linear or a table), linear kinematic hardening (Prager), or both. PlanePlastic is the 2-D form. Kinematic hardening
/// of modulus H_k is the solid in parallel with an elastic one: with h = H_k/mu,
///     W = kappa theta^2/2 + alpha/(2(1 + h)) (sum omega (e_d - z)^2 weight + h sum omega e_d^2 weight),
/// and alpha (e_d - z) is what yields. The history of a bond is z = (1 + h) e_p, which is e_p without kinematic
/// hardening. The history of a point is plastic_multiplier (lambda) and equivalent_plastic_strain (the tension
/// measure).
class ElasticPlastic : public Material {
 public:
  struct Parameters {
    double bulk = 0;               ///< k, stress
    double shear = 0;              ///< mu, stress
    double yield_shear = 0;        ///< tau_y: yield stress in pure shear
    double hardening_shear = 0;    ///< d tau_y / d gamma_p
    bool continuum_yield = false;  ///< psi0 from the continuum m (Eq. 51) instead of each point's own
    bool with_dilatation = true;
    double kinematic_shear = 0;             ///< H_k: slope of the back stress in shear over plastic shear strain
    std::optional<HardeningCurve> table{};  ///< takes the place of yield_shear and hardening_shear
    deck::Location yield_location{};        ///< place of the yield stress or of its table in the deck, for remark()

    HardeningCurve curve() const { return table ? *table : HardeningCurve(yield_shear, hardening_shear); }
    std::string hardening() const;  ///< the hardening in words, for summary()
    std::string remark() const;
  };
  explicit ElasticPlastic(const Parameters& parameters);

  HistoryLayout history() const override;
  using Material::modulus;
  bool takes_fit() const override { return parameters_.with_dilatation; }
  bool has_back_stress() const override { return parameters_.kinematic_shear > 0; }
  PointState state(const FamilySums& sums, const double* committed, double* trial) const override;
  double plastic_work(const double* point) const override;
  PointModulus modulus(const FamilySums& sums, const double* committed, deck::TangentForm form) const override;
  ElasticModuli elastic_moduli(int dimension) const override;
  std::string summary() const override;
  std::string remark() const override { return parameters_.remark(); }

 private:
  /// The quantities that the radial return decides for one point.
  struct Return {
    double dilatation = 0;
    double alpha = 0;          ///< d(d+2) mu/m
    double strain_square = 0;  ///< sum omega (e_d - z^n)^2 weight
    double trial_norm = 0;     ///< N (Eq. 40, weighted)
    double yield_scale = 0;    ///< c: beta = c tau
    double scale = 1;          ///< s = beta/N; 1 where elastic
    double beta = 0;           ///< at the end of the step
    double beta_slope = 0;     ///< d beta/d N
    double plastic_shear = 0;  ///< Delta gamma_p
    double potential = 0;      ///< work of tau over Delta gamma_p
    bool yielding = false;
  };
  Return radial_return(const FamilySums& sums, const double* committed) const;

  Parameters parameters_;
  HardeningCurve curve_;
  double overlay_;  ///< h = H_k/mu
  double inner_;    ///< 1/(1 + h), share of the stiffness that yields
};

}  // namespace perinox::materials
