#pragma once
#include "elastic_plastic.hpp"

namespace perinox::materials {

/// Ordinary state-based J2 plasticity in the plane, with the hardening of ElasticPlastic. The families see
/// in-plane extensions only, so the point carries z, its plastic strain out of the plane; docs/theory.md derives it.
/// With Q = alpha sum omega (e_d - e_p)^2 weight, k and mu of the solid and tau its yield stress in shear:
///     plane strain:  y = -z - theta/3, the elastic deviatoric strain out of the plane,
///                    W = k theta^2/2 + 3 mu y^2/2 + Q/2,  tau^2 against T^2 = mu Q + 3 mu^2 y^2
///     plane stress:  P = K2 (theta + z), K2 = 9 k mu/(3k + 4 mu), the in-plane mean stress,
///                    W = K2 (theta + z)^2/2 + Q/2,        tau^2 against T^2 = mu Q + P^2/3
/// Kinematic hardening of modulus H_k, h = H_k/mu: what yields is made of y = -(1 + h) z - theta/3, of
/// P + 3 H_k z in place of P, and of e_d - (1 + h) e_p.
/// Under uniform strain all are classical J2. History: (1 + h) e_p a bond; plastic_multiplier,
/// equivalent_plastic_strain and plastic_strain_zz z a point. Stresses; z is a strain.
class PlanePlastic : public Material {
 public:
  /// parameters: discrete yield, with dilatation.
  PlanePlastic(const ElasticPlastic::Parameters& parameters, deck::Dimension dimension);

  HistoryLayout history() const override;
  using Material::modulus;
  bool takes_fit() const override { return true; }
  bool has_back_stress() const override { return parameters_.kinematic_shear > 0; }
  PointState state(const FamilySums& sums, const double* committed, double* trial) const override;
  double plastic_work(const double* point) const override;
  /// There is no printed form: the consistent one is returned for either.
  PointModulus modulus(const FamilySums& sums, const double* committed, deck::TangentForm form) const override;
  ElasticModuli elastic_moduli(int dimension) const override;
  std::string summary() const override;
  std::string remark() const override { return parameters_.remark(); }

 private:
  /// Everything the return to the yield surface decides for one point.
  struct Return {
    double dilatation = 0;
    double alpha = 0;          ///< 8 mu/m
    double energy = 0;         ///< Q before, of what yields
    double out = 0;            ///< of what yields, before: in plane strain y, in plane stress P
    double shear = 1;          ///< what is left of the in-plane deviator
    double rest = 1;           ///< what is left of `out`
    double plastic_shear = 0;  ///< Delta gamma_p
    double potential = 0;      ///< work of tau over it
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
  bool stress_;         ///< plane stress
  double plane_bulk_;   ///< K2; of plane strain k + mu/3
  double out_modulus_;  ///< K2 + 3 H_k
};

}  // namespace perinox::materials
