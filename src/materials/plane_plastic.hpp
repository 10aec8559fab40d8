#pragma once
#include "elastic_plastic.hpp"

namespace perinox::materials {

/// Ordinary state-based J2 plasticity in the plane, with the hardening of ElasticPlastic (docs/theory.md, section 3).
/// The families see in-plane extensions only, so the point carries z, its plastic strain out of the plane. With Q =
/// alpha sum omega (e_d - e_p)^2 weight, k and mu of the solid and tau its yield stress in shear:
///     plane strain:  y = -z - theta/3, the elastic deviatoric strain out of the plane,
///                    W = k theta^2/2 + 3 mu y^2/2 + Q/2,  tau^2 against T^2 = mu Q + 3 mu^2 y^2
///     plane stress:  P = K2 (theta + z), K2 = 9 k mu/(3k + 4 mu), the in-plane mean stress,
///                    W = K2 (theta + z)^2/2 + Q/2,        tau^2 against T^2 = mu Q + P^2/3
/// With kinematic hardening of modulus H_k and h = H_k/mu, the part that yields is made of y = -(1 + h) z - theta/3, of
/// P + 3 H_k z in place of P, and of e_d - (1 + h) e_p. Under uniform strain all of these are classical J2 plasticity.
/// The history of a bond is (1 + h) e_p. The history of a point is plastic_multiplier, equivalent_plastic_strain and
/// plastic_strain_zz (z). Moduli are stresses; z is a strain.
class PlanePlastic : public Material {
 public:
  /// parameters: with discrete yield and with dilatation.
  PlanePlastic(const ElasticPlastic::Parameters& parameters, deck::Dimension dimension);

  HistoryLayout history() const override;
  using Material::modulus;
  bool takes_fit() const override { return true; }
  bool has_back_stress() const override { return parameters_.kinematic_shear > 0; }
  PointState state(const FamilySums& sums, const double* committed, double* trial) const override;
  double plastic_work(const double* point) const override;
  /// There is no printed form. The consistent one is returned for either.
  PointModulus modulus(const FamilySums& sums, const double* committed, deck::TangentForm form) const override;
  ElasticModuli elastic_moduli(int dimension) const override;
  std::string summary() const override;
  std::string remark() const override { return parameters_.remark(); }

 private:
  /// The quantities that the return to the yield surface decides for one point.
  struct Return {
    double dilatation = 0;
    double alpha = 0;   ///< 8 mu/m
    double energy = 0;  ///< Q of the part that yields, before the return
    /// Out-of-plane quantity of the part that yields, before the return: y in plane strain, P in plane stress.
    double out = 0;
    double shear = 1;          ///< share of the in-plane deviator that is left
    double rest = 1;           ///< share of `out` that is left
    double plastic_shear = 0;  ///< Delta gamma_p
    double potential = 0;      ///< work of tau over that flow
    double flow = 0;           ///< coefficient of q (q . de), q = omega (e_d - e_p) + flow_pressure d theta/d e
    double flow_pressure = 0;
    bool yielding = false;
  };
  Return return_to_yield(const FamilySums& sums, const double* committed) const;
  void flow_in_plane_strain(double trial, double plastic_shear, Return& r) const;
  void flow_in_plane_stress(double trial, double plastic_shear, Return& r) const;
  double meet_in_plane_stress(double trial, double stress, double slope, Return& r) const;

  ElasticPlastic::Parameters parameters_;
  HardeningCurve curve_;
  double overlay_;      ///< h = H_k/mu
  bool stress_;         ///< true in plane stress
  double plane_bulk_;   ///< K2 in plane stress, k + mu/3 in plane strain
  double out_modulus_;  ///< K2 + 3 H_k
};

}  // namespace perinox::materials
