/// Compares plasticity in the plane, with every kind of hardening, with classical J2 plasticity of the solid under the
/// same strain. The strain out of the plane is zero (plane strain) or sought so that its stress vanishes (plane
/// stress).
#include <gtest/gtest.h>

#include "support/isotropic_family.hpp"
#include "support/measured.hpp"

namespace perinox::test {
namespace {

/// In-plane strains in yield strains, one after the other: tension, shear, confined tension, turning, back.
const std::vector<std::vector<Tensor>> paths{
    {{0.5, 0, 0, 0, 0, 0}, {3, 0, 0, 0, 0, 0}, {6, 0, 0, 0, 0, 0}, {2, 0, 0, 0, 0, 0}, {-5, 0, 0, 0, 0, 0}},
    {{0, 0, 0, 0, 0, 0.4}, {0, 0, 0, 0, 0, 2}, {0, 0, 0, 0, 0, 5}, {0, 0, 0, 0, 0, -4}},
    {{2, 2, 0, 0, 0, 0}, {5, 5, 0, 0, 0, 0}, {4, 4, 0, 0, 0, 0}},
    {{4, -1, 0, 0, 0, 0}, {4, -1, 0, 0, 0, 3}, {1, 2, 0, 0, 0, 3}, {-3, 2, 0, 0, 0, -1}},
};

TEST(PlanePlasticity, IsClassicalUnderUniformStrain) {
  const IsotropicFamily disc(2, 3.015);
  for (const deck::Dimension dimension : {deck::Dimension::plane_strain, deck::Dimension::plane_stress})
    for (const Hardening& hardening : hardenings())
      for (const auto& path : paths) {
        SCOPED_TRACE(hardening.name);
        const materials::PlanePlastic material(hardening.parameters(), dimension);
        MaterialPoint point(material, disc.family);
        LocalPlasticity solid = hardening.point();
        for (Tensor strain : path) {
          for (double& value : strain) value *= yield_strain;
          if (dimension == deck::Dimension::plane_stress) strain[2] = solid.free_strain(strain);
          LocalPlasticity next;
          const Tensor expected = solid.stress(strain, &next);
          const Evaluation now = point.evaluate(disc.extension(strain));
          const Tensor found = disc.stress(now.force_state);
          for (const int c : {0, 1, 5})
            EXPECT_LE(measured("plane plasticity: stress against J2", std::abs(found[c] - expected[c]) / yield_shear),
                      1e-12);  // 3.1e-14
          const double scale = std::max(1.0, next.gamma / yield_strain) * yield_strain;
          EXPECT_LE(measured("plane plasticity: gamma_p against J2",
                             std::abs(std::sqrt(3.0) * now.point_history[1] - next.gamma) / scale),
                    1e-12);  // 1.7e-15
          EXPECT_LE(measured("plane plasticity: plastic strain zz against J2",
                             std::abs(now.point_history[2] - next.plastic[2]) / scale),
                    1e-12);  // 9.2e-16
          EXPECT_LE(measured("plane plasticity: stored energy against J2",
                             std::abs(now.response.stored_energy / next.stored_energy(strain) - 1)),
                    1e-12);  // 5.8e-15
          point.commit(now);
          solid = next;
        }
      }
}

}  // namespace
}  // namespace perinox::test
