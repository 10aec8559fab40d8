/// Internal forces, dilatations and plastic multipliers against fields computed by other programs
/// (tests/data/reference/README.md). Differences are largest entry over largest entry.
#include <gtest/gtest.h>

#include "materials/elastic.hpp"
#include "materials/elastic_plastic.hpp"
#include "support/families.hpp"
#include "support/measured.hpp"
#include "support/reference_table.hpp"
#include "support/scenes.hpp"

namespace perinox::test {
namespace {

/// The points of the first `count` rows as a cloud of equal volumes.
deck::Deck cloud_of(const ReferenceTable& table, std::size_t count, double volume, double horizon) {
  std::vector<std::array<double, 4>> points;
  for (std::size_t row = 0; row < count; ++row)
    points.push_back({table.at(row, "x"), table.at(row, "y"), table.at(row, "z"), volume});
  return cloud_deck(points, horizon);
}

/// The scene, with the particles in the table's order.
mechanics::Scene scene_of(const ReferenceTable& table, std::size_t count, const deck::Deck& deck, Materials materials) {
  mechanics::Scene scene = make_scene(deck, std::move(materials));
  remove_cloud(deck);
  EXPECT_EQ(static_cast<std::size_t>(scene.owned()), count);
  EXPECT_EQ(relative_difference(scene.body().reference, table.vectors("x", "y", "z", 0, count)), 0);
  return scene;
}

Vector scaled(Vector values, double factor) {
  for (double& value : values) value *= factor;
  return values;
}

// The lattices of the README: V = 1e-9, k = 160e9, mu = 80e9, horizon 3.015e-3.
constexpr double volume = 1e-9;
constexpr double bulk = 160e9;
constexpr double shear = 80e9;
constexpr double horizon = 3.015e-3;
constexpr std::size_t points = 343;

class LammpsSolid : public ::testing::TestWithParam<const char*> {};

TEST_P(LammpsSolid, Forces) {
  const ReferenceTable table(GetParam());
  ASSERT_EQ(table.rows(), points);
  deck::Deck deck = cloud_of(table, points, volume, horizon);
  deck.influence = deck::Influence::inverse;
  deck.quadrature = deck::Quadrature::taper_inside;
  const mechanics::Scene scene =
      scene_of(table, points, deck, materials_of(std::make_unique<materials::Elastic>(bulk, shear, true)));
  const Answer answer = internal_force(scene, mechanics::Committed(scene), table.vectors("ux", "uy", "uz", 0, points));
  const std::string name = GetParam();
  EXPECT_LE(measured(name + ": force",
                     relative_difference(answer.force, scaled(table.vectors("fx", "fy", "fz", 0, points), volume))),
            1e-10);  // 2.2e-13
  EXPECT_LE(
      measured(name + ": dilatation", relative_difference(answer.trial.dilatation, table.column("theta", 0, points))),
      1e-10);  // 2.8e-13
}

INSTANTIATE_TEST_SUITE_P(Reference, LammpsSolid,
                         ::testing::Values("lps_uniform_strain", "lps_simple_shear", "lps_rotation30_stretch1pct",
                                           "lps_random"),
                         [](const auto& one) { return std::string(one.param); });

TEST(LammpsSolid, RotationAloneMakesNoForce) {
  // The 30 degrees of lps_rotation30_stretch1pct without its stretch, against its forces.
  const ReferenceTable table("lps_rotation30_stretch1pct");
  deck::Deck deck = cloud_of(table, points, volume, horizon);
  deck.influence = deck::Influence::inverse;
  deck.quadrature = deck::Quadrature::taper_inside;
  const mechanics::Scene scene =
      scene_of(table, points, deck, materials_of(std::make_unique<materials::Elastic>(bulk, shear, true)));
  const Vector force = internal_force(scene, mechanics::Committed(scene), affine_field(scene, rotation(30, 2))).force;
  const double scale = volume * largest_magnitude(table.vectors("fx", "fy", "fz", 0, points));
  EXPECT_LE(measured("rotation by 30 degrees: force over that of 1 % stretch", largest_magnitude(force) / scale),
            1e-12);  // 2.4e-14
}

TEST(MitchellPlasticity, ElevenStepsOfLoadingUnloadingAndReversal) {
  const ReferenceTable table("plastic_shear_history");
  constexpr std::size_t steps = 11;
  ASSERT_EQ(table.rows(), steps * points);
  materials::ElasticPlastic::Parameters parameters;
  parameters.bulk = bulk;
  parameters.shear = shear;
  parameters.yield_shear = 300e6;
  parameters.continuum_yield = true;
  const mechanics::Scene scene = scene_of(table, points, cloud_of(table, points, volume, horizon),
                                          materials_of(std::make_unique<materials::ElasticPlastic>(parameters)));
  mechanics::Committed committed(scene);
  long long most_yielding = 0, least_yielding = scene.owned();
  for (std::size_t step = 0; step < steps; ++step) {
    SCOPED_TRACE(step);
    const std::size_t first = step * points;
    ASSERT_EQ(table.at(first, "step"), static_cast<double>(step));
    Answer answer = internal_force(scene, committed, table.vectors("ux", "uy", "uz", first, points));
    most_yielding = std::max(most_yielding, answer.trial.yielding);
    least_yielding = std::min(least_yielding, answer.trial.yielding);
    EXPECT_LE(
        measured("plastic history: force",
                 relative_difference(answer.force, scaled(table.vectors("fx", "fy", "fz", first, points), volume))),
        1e-10);  // 2.1e-13
    // Back at the start in steps 6 and 10 the dilatation is zero: compared with a strain of 1e-3, the path's order.
    const Vector theta = table.column("theta", first, points);
    Vector difference(points), multiplier(points);
    for (std::size_t i = 0; i < points; ++i) {
      difference[i] = answer.trial.dilatation[i] - theta[i];
      multiplier[i] = answer.trial.point_history[2 * i];
    }
    EXPECT_LE(measured("plastic history: dilatation over 1e-3", largest_magnitude(difference) / 1e-3),
              1e-10);  // 4.9e-13
    EXPECT_LE(measured("plastic history: plastic multiplier",
                       relative_difference(multiplier, table.column("lambda", first, points))),
              1e-10);  // 2.6e-13
    commit(scene, committed, std::move(answer.trial));
  }
  // The path does load, unload and load again.
  EXPECT_GT(most_yielding, scene.owned() / 2);
  EXPECT_EQ(least_yielding, 0);
}

TEST(MitchellPlasticity, TetrahedronFirstPlasticStep) {
  const ReferenceTable table("tetrahedron_plastic_step");
  const double tetrahedron_horizon = 1.2, psi0 = 2;
  const double m = 3;  // three bonds of length 1 to points of V = 1
  const double continuum_m = 4 * std::acos(-1.0) * std::pow(tetrahedron_horizon, 5) / 5;
  for (bool continuum : {false, true}) {
    SCOPED_TRACE(continuum ? "continuum" : "discrete");
    materials::ElasticPlastic::Parameters parameters;
    parameters.bulk = 160;
    parameters.shear = 80;
    // psi0 = d(d+2) tau^2/(2m) solved for tau, with the m of either scaling.
    parameters.yield_shear = std::sqrt(2 * psi0 * (continuum ? continuum_m : m) / 15);
    parameters.continuum_yield = continuum;
    const mechanics::Scene scene = scene_of(table, 4, cloud_of(table, 4, 1, tetrahedron_horizon),
                                            materials_of(std::make_unique<materials::ElasticPlastic>(parameters)));
    const Answer answer = internal_force(scene, mechanics::Committed(scene), table.vectors("ux", "uy", "uz", 0, 4));
    EXPECT_EQ(answer.trial.yielding, 4);
    EXPECT_LE(measured("tetrahedron: force", relative_difference(answer.force, table.vectors("fx", "fy", "fz", 0, 4))),
              1e-10);  // 1.4e-15
    EXPECT_LE(
        measured("tetrahedron: dilatation", relative_difference(answer.trial.dilatation, table.column("theta", 0, 4))),
        1e-10);  // 2.0e-16
    Vector multiplier;
    for (std::size_t i = 0; i < 4; ++i) multiplier.push_back(answer.trial.point_history[2 * i]);
    EXPECT_LE(
        measured("tetrahedron: plastic multiplier", relative_difference(multiplier, table.column("lambda", 0, 4))),
        1e-10);  // 2.9e-14
  }
}

TEST(Peridigm, ConvergedFieldOfTheStretchedCube) {
  const ReferenceTable table("peridigm_stretched_cube");
  constexpr std::size_t count = 1000;
  constexpr double spacing = 0.1;
  ASSERT_EQ(table.rows(), count);
  const mechanics::Scene scene =
      scene_of(table, count, cloud_of(table, count, spacing * spacing * spacing, 3.015 * spacing),
               materials_of(std::make_unique<materials::Elastic>(67.5e9, 25.9e9, true)));
  const Answer answer = internal_force(scene, mechanics::Committed(scene), table.vectors("ux", "uy", "uz", 0, count));
  EXPECT_LE(
      measured("Peridigm cube: force", relative_difference(answer.force, table.vectors("fx", "fy", "fz", 0, count))),
      1e-10);  // 2.7e-13
  EXPECT_LE(measured("Peridigm cube: dilatation",
                     relative_difference(answer.trial.dilatation, table.column("dilatation", 0, count))),
            1e-10);  // 2.7e-13
  // In equilibrium between the held layers: three at each end.
  double interior = 0, reaction = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double z = scene.body().position(static_cast<LocalIndex>(i))[2];
    for (std::size_t c = 0; c < 3; ++c) {
      double& largest = z < 3 * spacing || z > 7 * spacing ? reaction : interior;
      largest = std::max(largest, std::abs(answer.force[3 * i + c]));
    }
  }
  ASSERT_GT(reaction, 0);
  EXPECT_LE(measured("Peridigm cube: interior force over reactions", interior / reaction), 1e-10);  // 3.0e-13
}

}  // namespace
}  // namespace perinox::test
