/// The internal force as mechanics demands it: balanced, blind to rigid motion, and minus the gradient of the stored
/// energy where nothing flows.
#include <gtest/gtest.h>

#include "support/load_states.hpp"
#include "support/measured.hpp"

namespace perinox::test {
namespace {

using Moment = std::array<double, 3>;

Moment cross(const double* a, const double* b, int d) {
  const double az = d == 3 ? a[2] : 0, bz = d == 3 ? b[2] : 0;
  return {a[1] * bz - az * b[1], az * b[0] - a[0] * bz, a[0] * b[1] - a[1] * b[0]};
}

struct Total {
  double force = 0;   ///< |sum f| over sum |f|
  double moment = 0;  ///< |sum y x f| over sum |y x f|
};

Total total(const mechanics::Scene& scene, const Vector& displacement, const Vector& force) {
  const int d = scene.dimension();
  Moment sum{}, moment{};
  double force_size = 0, moment_size = 0;
  for (LocalIndex i = 0; i < scene.owned(); ++i) {
    double place[3] = {};
    const double* f = &force[static_cast<std::size_t>(i) * d];
    for (int c = 0; c < d; ++c) {
      place[c] = scene.body().position(i)[c] + displacement[static_cast<std::size_t>(i) * d + c];
      sum[c] += f[c];
      force_size += std::abs(f[c]);
    }
    const Moment one = cross(place, f, d);
    for (int c = 0; c < 3; ++c) {
      moment[c] += one[c];
      moment_size += std::abs(one[c]);
    }
  }
  const auto size = [](const Moment& m) { return std::sqrt(m[0] * m[0] + m[1] * m[1] + m[2] * m[2]); };
  return {size(sum) / force_size, size(moment) / moment_size};
}

TEST(InternalForce, IsInBalance) {
  for (const MaterialRow& row : material_table())
    for (const LoadState& state : load_states())
      for (deck::Quadrature quadrature :
           {deck::Quadrature::whole, deck::Quadrature::partial_volume, deck::Quadrature::taper_inside}) {
        if (state.needs_plasticity && row.surface.empty()) continue;
        SCOPED_TRACE(row.name + " " + state.name + " " + name_of(quadrature));
        const mechanics::Scene scene = small_scene(row, deck::Influence::inverse, quadrature);
        std::vector<Vector> fields = fields_of(scene, state);
        const Vector last = fields.back();
        fields.pop_back();
        const Total sums = total(scene, last, internal_force(scene, committed_after(scene, fields), last).force);
        EXPECT_LE(measured("internal force: total force", sums.force), 1e-14);    // 9.0e-17
        EXPECT_LE(measured("internal force: total moment", sums.moment), 1e-14);  // 2.6e-16
      }
}

TEST(InternalForce, RigidMotionMakesNone) {
  for (const MaterialRow& row : material_table()) {
    SCOPED_TRACE(row.name);
    const mechanics::Scene scene = small_scene(row, deck::Influence::polynomial, deck::Quadrature::partial_volume);
    const mechanics::Committed start(scene);
    // A strain of a thousandth makes the force to compare with.
    Matrix strained = rotation(0, 3);
    strained[0][0] += 1e-3;
    strained[0][1] += 1e-3;
    const double scale = norm(internal_force(scene, start, affine_field(scene, strained)).force);
    ASSERT_GT(scale, 0);
    for (double degrees : {1.0, 30.0, 90.0, 180.0, 275.0}) {
      Vector field = affine_field(scene, rotation(degrees, row.dimension));
      for (double& value : field) value += 0.3;  // and a translation
      const Answer answer = internal_force(scene, start, field);
      // Displacements of order 4 are rounded to 4e-16, a thousandth of the shortest bond is 4e-4: 1e-12 is rounding.
      EXPECT_LE(measured("internal force: of a rigid rotation over that of strain 1e-3", norm(answer.force) / scale),
                5e-12);  // 1.7e-12
      EXPECT_EQ(answer.trial.yielding, 0);
    }
  }
}

TEST(InternalForce, TurnsWithTheBody) {
  // Rotating the deformed body rotates its forces, with plastic history too.
  for (const MaterialRow& row : material_table()) {
    SCOPED_TRACE(row.name);
    const int d = row.dimension;
    const mechanics::Scene scene = small_scene(row, deck::Influence::constant, deck::Quadrature::whole);
    const mechanics::Committed committed = committed_after(scene, {field_of(scene, {2.0})});
    const Vector upright = internal_force(scene, committed, field_of(scene, {-3.0})).force;
    const Vector turned = internal_force(scene, committed, field_of(scene, {-3.0, 70})).force;
    const Matrix turn = rotation(70, d);
    Vector expected(upright.size(), 0.0);
    for (LocalIndex i = 0; i < scene.owned(); ++i)
      for (int c = 0; c < d; ++c)
        for (int k = 0; k < d; ++k) expected[i * d + c] += turn[c][k] * upright[i * d + k];
    EXPECT_LE(measured("internal force: objectivity", relative_difference(turned, expected)), 1e-12);  // 1.4e-13
  }
}

TEST(InternalForce, IsMinusTheGradientOfTheStoredEnergy) {
  for (const MaterialRow& row : material_table())
    for (const LoadState& state : load_states()) {
      if (state.needs_plasticity && row.surface.empty()) continue;
      if (!row.surface.empty() && state.flow != Flow::none) continue;  // not where energy is dissipated
      for (deck::Influence influence :
           {deck::Influence::constant, deck::Influence::inverse, deck::Influence::polynomial}) {
        SCOPED_TRACE(row.name + " " + state.name + " " + name_of(influence));
        const mechanics::Scene scene = small_scene(row, influence, deck::Quadrature::partial_volume);
        std::vector<Vector> fields = fields_of(scene, state);
        const Vector here = fields.back();
        fields.pop_back();
        const mechanics::Committed committed = committed_after(scene, fields);
        const Vector force = internal_force(scene, committed, here).force;
        const auto energy = [&](const Vector& at) { return internal_force(scene, committed, at).trial.stored; };
        // Along the force (its norm) and along a random direction.
        for (const Vector& along : {sum(force, 1 / norm(force) - 1, force), random_field(scene, 1, 17)}) {
          double best = 1;
          for (double relative : {1e-3, 3e-4, 1e-4, 3e-5, 1e-5}) {
            const double s = relative * scene.bonds().horizon * yield_strain;
            const double slope = (8 * (energy(sum(here, s, along)) - energy(sum(here, -s, along))) -
                                  (energy(sum(here, 2 * s, along)) - energy(sum(here, -2 * s, along)))) /
                                 (12 * s);
            best = std::min(best, std::abs(slope + dot(force, along)) / (norm(force) * norm(along)));
          }
          EXPECT_LE(measured("internal force: against the energy's gradient", best), 1e-9);  // 4.9e-11
        }
      }
    }
}

TEST(InternalForce, NamesTheParticleWhoseForceIsNotFinite) {
  const MaterialRow row = material_table()[0];
  const mechanics::Scene scene = small_scene(row, deck::Influence::constant, deck::Quadrature::whole);
  const mechanics::Committed start(scene);
  Vector field(scene.owned_unknowns(), 0.0);
  const Answer sound = internal_force(scene, start, field);
  EXPECT_EQ(mechanics::first_not_finite(scene, sound.trial, sound.force.data()), "");
  // Particle 1 is put where particle 0 is.
  for (int c = 0; c < 3; ++c) field[3 + c] = scene.body().position(0)[c] - scene.body().position(1)[c];
  const Answer collapsed = internal_force(scene, start, field);
  const std::string sentence = mechanics::first_not_finite(scene, collapsed.trial, collapsed.force.data());
  EXPECT_NE(sentence.find("particle 0 at"), std::string::npos) << sentence;
  EXPECT_NE(sentence.find("its bond to particle 1 has collapsed to length zero"), std::string::npos) << sentence;
}

}  // namespace
}  // namespace perinox::test
