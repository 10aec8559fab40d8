/// Plasticity in the plane against classical J2 plasticity of the solid under the same strain: full tensors, the radial
/// return of the textbooks, the strain out of the plane zero (plane strain) or sought so that its stress vanishes.
#include <gtest/gtest.h>

#include "support/material_table.hpp"
#include "support/measured.hpp"

namespace perinox::test {
namespace {

/// xx yy zz and xy.
using Tensor = std::array<double, 4>;

struct Solid {
  double hardening = 0;
  Tensor plastic{};
  double gamma = 0;

  /// Stress and next history under strains xx yy zz xy.
  Tensor stress(const Tensor& strain, Solid* next) const {
    const double volume = strain[0] + strain[1] + strain[2];
    Tensor deviator{};
    double square = 0;
    for (int c = 0; c < 4; ++c) {
      deviator[c] = 2 * shear * (strain[c] - (c < 3 ? volume / 3 : 0) - plastic[c]);
      square += (c < 3 ? 1 : 2) * deviator[c] * deviator[c];
    }
    const double trial = std::sqrt(square / 2), tau = yield_shear + hardening * gamma;
    double scale = 1;
    if (next) *next = *this;
    if (trial > tau) {
      const double step = (trial - tau) / (shear + hardening);
      scale = 1 - shear * step / trial;
      if (next) next->gamma += step;
    }
    Tensor stress{};
    for (int c = 0; c < 4; ++c) {
      if (next) next->plastic[c] += (1 - scale) * deviator[c] / (2 * shear);
      stress[c] = scale * deviator[c] + (c < 3 ? bulk * volume : 0);
    }
    return stress;
  }
  /// The strain zz that leaves no stress zz: a bisection, as it rises with the strain.
  double free_strain(Tensor strain) const {
    double low = -1, high = 1;
    for (int k = 0; k < 200; ++k) {
      strain[2] = (low + high) / 2;
      (stress(strain, nullptr)[2] < 0 ? low : high) = strain[2];
    }
    return (low + high) / 2;
  }
};

/// A family of a lattice, every bond's direction in sight.
struct Disc {
  explicit Disc(double radius) {
    for (int y = -4; y <= 4; ++y)
      for (int x = -4; x <= 4; ++x) {
        const double r = std::hypot(x, y);
        if (r == 0 || r > radius) continue;
        direction.push_back({x / r, y / r});
        const double fourth = std::pow(x / r, 4) + std::pow(y / r, 4) - 0.75;
        family.length.push_back(r);
        family.weight.push_back(1);
        family.influence.push_back(fourth);  // for now
      }
    double first = 0, second = 0;
    for (std::size_t j = 0; j < direction.size(); ++j) {
      first += family.length[j] * family.length[j] * family.influence[j];
      second += std::pow(family.length[j] * family.influence[j], 2);
    }
    for (double& influence : family.influence) influence = 1 - first / second * influence;  // isotropic moments
    family.dimension = 2;
    for (std::size_t j = 0; j < direction.size(); ++j)
      family.weighted_volume += family.influence[j] * family.length[j] * family.length[j];
    family.continuum_weighted_volume = family.weighted_volume;
  }
  Vector extension(const Tensor& strain) const {
    Vector e;
    for (std::size_t j = 0; j < direction.size(); ++j) {
      const auto [x, y] = direction[j];
      e.push_back(family.length[j] * (strain[0] * x * x + strain[1] * y * y + 2 * strain[3] * x * y));
    }
    return e;
  }
  /// Collapsed stress: sum t xi n n weight.
  Tensor stress(const Vector& force_state) const {
    Tensor sum{};
    for (std::size_t j = 0; j < direction.size(); ++j) {
      const auto [x, y] = direction[j];
      const double pull = force_state[j] * family.length[j] * family.weight[j];
      sum[0] += pull * x * x;
      sum[1] += pull * y * y;
      sum[3] += pull * x * y;
    }
    return sum;
  }

  RandomFamily family;
  std::vector<std::array<double, 2>> direction;
};

/// In-plane strains in yield strains, one after the other: tension, shear, confined tension, turning, back.
const std::vector<std::vector<Tensor>> paths{
    {{0.5, 0, 0, 0}, {3, 0, 0, 0}, {6, 0, 0, 0}, {2, 0, 0, 0}, {-5, 0, 0, 0}},
    {{0, 0, 0, 0.4}, {0, 0, 0, 2}, {0, 0, 0, 5}, {0, 0, 0, -4}},
    {{2, 2, 0, 0}, {5, 5, 0, 0}, {4, 4, 0, 0}},
    {{4, -1, 0, 0}, {4, -1, 0, 3}, {1, 2, 0, 3}, {-3, 2, 0, -1}},
};

TEST(PlanePlasticity, IsClassicalUnderUniformStrain) {
  const Disc disc(3.015);
  for (const deck::Dimension dimension : {deck::Dimension::plane_strain, deck::Dimension::plane_stress})
    for (const double hardening : {0.0, hardening_shear})
      for (const auto& path : paths) {
        const materials::PlanePlastic material({bulk, shear, yield_shear, hardening, false, true}, dimension);
        MaterialPoint point(material, disc.family);
        Solid solid;
        solid.hardening = hardening;
        for (Tensor strain : path) {
          for (double& value : strain) value *= yield_strain;
          if (dimension == deck::Dimension::plane_stress) strain[2] = solid.free_strain(strain);
          Solid next;
          const Tensor expected = solid.stress(strain, &next);
          const Evaluation now = point.evaluate(disc.extension(strain));
          const Tensor found = disc.stress(now.force_state);
          for (const int c : {0, 1, 3})
            EXPECT_LE(measured("plane plasticity: stress against J2", std::abs(found[c] - expected[c]) / yield_shear),
                      1e-12);
          const double scale = std::max(1.0, next.gamma / yield_strain) * yield_strain;
          EXPECT_LE(measured("plane plasticity: gamma_p against J2",
                             std::abs(std::sqrt(3.0) * now.point_history[1] - next.gamma) / scale),
                    1e-12);
          EXPECT_LE(measured("plane plasticity: plastic strain zz against J2",
                             std::abs(now.point_history[2] - next.plastic[2]) / scale),
                    1e-12);
          point.commit(now);
          solid = next;
        }
      }
}

}  // namespace
}  // namespace perinox::test
