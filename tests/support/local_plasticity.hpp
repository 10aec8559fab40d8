#pragma once
/// Classical J2 plasticity of a point of a solid, written independently of the library: full tensors, the radial return
/// of the textbooks, Prager's back stress, a yield stress of any shape.
#include <array>
#include <cmath>
#include <vector>

#include "support/material_table.hpp"

namespace perinox::test {

/// A symmetric tensor: xx yy zz yz xz xy.
using Tensor = std::array<double, 6>;

inline double contract(const Tensor& a, const Tensor& b) {
  double sum = 0;
  for (int c = 0; c < 6; ++c) sum += (c < 3 ? 1 : 2) * a[c] * b[c];
  return sum;
}
inline Tensor deviator(Tensor a) {
  const double mean = (a[0] + a[1] + a[2]) / 3;
  for (int c = 0; c < 3; ++c) a[c] -= mean;
  return a;
}

/// A point of the solid with the moduli `bulk` and `shear` of the material table.
struct LocalPlasticity {
  /// Yield stress in shear over plastic shear strain. It is straight between rows and has `last_slope` beyond the last
  /// one.
  std::vector<std::array<double, 2>> rows{{0, yield_shear}};
  double last_slope = 0;
  double kinematic = 0;  ///< slope of the back stress in shear over plastic shear strain
  Tensor plastic{};
  double gamma = 0;  ///< plastic shear strain

  double yield_stress(double at) const {
    for (std::size_t k = 0; k + 1 < rows.size(); ++k)
      if (at < rows[k + 1][0])
        return rows[k][1] + (rows[k + 1][1] - rows[k][1]) * (at - rows[k][0]) / (rows[k + 1][0] - rows[k][0]);
    return rows.back()[1] + last_slope * (at - rows.back()[0]);
  }
  /// The stress under a strain, and the next history.
  Tensor stress(const Tensor& strain, LocalPlasticity* next = nullptr) const {
    const double volume = strain[0] + strain[1] + strain[2];
    const Tensor shape = deviator(strain);
    Tensor driving{};
    for (int c = 0; c < 6; ++c) driving[c] = 2 * shear * (shape[c] - plastic[c]) - 2 * kinematic * plastic[c];
    const double trial = std::sqrt(contract(driving, driving) / 2);
    double step = 0;
    if (trial > yield_stress(gamma)) {
      double low = 0, high = trial / (shear + kinematic);
      for (int k = 0; k < 200; ++k) {
        step = (low + high) / 2;
        (trial - (shear + kinematic) * step > yield_stress(gamma + step) ? low : high) = step;
      }
    }
    Tensor flowed = plastic, result{};
    for (int c = 0; c < 6; ++c) {
      if (step > 0) flowed[c] += step * driving[c] / (2 * trial);
      result[c] = 2 * shear * (shape[c] - flowed[c]) + (c < 3 ? bulk * volume : 0);
    }
    if (next) {
      *next = *this;
      next->plastic = flowed;
      next->gamma += step;
    }
    return result;
  }
  /// The energy of a strain with the current history: the elastic energy and that stored by the back stress.
  double stored_energy(const Tensor& strain) const {
    const double volume = strain[0] + strain[1] + strain[2];
    Tensor elastic = deviator(strain);
    for (int c = 0; c < 6; ++c) elastic[c] -= plastic[c];
    return bulk * volume * volume / 2 + shear * contract(elastic, elastic) + kinematic * contract(plastic, plastic);
  }
  /// The strain zz that leaves no stress zz, found by bisection because the stress rises with the strain.
  double free_strain(Tensor strain) const {
    double low = -1, high = 1;
    for (int k = 0; k < 200; ++k) {
      strain[2] = (low + high) / 2;
      (stress(strain)[2] < 0 ? low : high) = strain[2];
    }
    return (low + high) / 2;
  }
};

/// A kind of hardening, for the library and for the classical point.
struct Hardening {
  std::string name;
  double isotropic = 0, kinematic = 0;
  bool table = false;

  /// A table that rises, rests, falls and rises again within the plastic strains of the tests' paths, which end beyond
  /// it.
  static std::vector<std::array<double, 2>> rows() {
    return {{0, yield_shear},
            {0.4 * yield_strain, 1.3 * yield_shear},
            {0.9 * yield_strain, 1.3 * yield_shear},
            {1.7 * yield_strain, 1.1 * yield_shear},
            {4.1 * yield_strain, 1.5 * yield_shear}};
  }
  static materials::HardeningCurve curve() {
    std::vector<materials::HardeningCurve::Row> all;
    for (const auto& [strain, stress] : rows()) all.push_back({strain, stress});
    return materials::HardeningCurve(all);
  }
  materials::ElasticPlastic::Parameters parameters() const {
    materials::ElasticPlastic::Parameters p{bulk, shear, yield_shear, isotropic, false, true, kinematic, {}};
    if (table) p.table = curve();
    return p;
  }
  LocalPlasticity point() const {
    LocalPlasticity point;
    if (table) point.rows = rows();
    point.last_slope = table ? 0 : isotropic;
    point.kinematic = kinematic;
    return point;
  }
};

inline std::vector<Hardening> hardenings() {
  return {{"perfect", 0, 0, false},
          {"isotropic", hardening_shear, 0, false},
          {"kinematic", 0, 0.15 * shear, false},
          {"combined", hardening_shear, 0.15 * shear, false},
          {"table", 0, 0, true},
          {"table_and_kinematic", 0, 0.6 * shear, true}};
}

}  // namespace perinox::test
