/// Contact of bodies one particle thick: whether a particle can be touched is a fact of its own family.
#include <gtest/gtest.h>

#include "perinox/motion/exposed_particles.hpp"
#include "support/motion.hpp"
#include "support/thin_bodies.hpp"

namespace perinox::test {
namespace {

TEST(ThinContact, BodiesOneParticleThickDoNotPassEachOtherWhateverIsFarAway) {
  for (const ThinScene& scene : thin_scenes) {
    RunResult alone = run_deck(deck_of(thin_deck(scene, false)));
    RunResult beside = run_deck(deck_of(thin_deck(scene, true)));
    ASSERT_EQ(alone.stopped, "");
    ASSERT_EQ(beside.stopped, "");
    double touched = 0, nearest = 0;
    for (const StepRecord& row : alone.records.steps) {
      touched = std::max(touched, row.motion->contact_energy);
      nearest = std::min(nearest, row.history[0] - row.history[1]);
    }
    for (auto particle = beside.displacement.begin(); particle != beside.displacement.end();)
      particle = alone.displacement.count(particle->first) ? std::next(particle) : beside.displacement.erase(particle);
    const double difference = relative_difference(beside.displacement, alone.displacement);
    const double pushed = alone.records.steps.back().history[1];
    std::printf("%s: contact energy %.2g, nearer by %.2f on the mean, below pushed by %.3f, far body %.1e\n",
                scene.name, touched, -nearest, pushed, difference);
    EXPECT_GT(touched, 0) << scene.name;
    EXPECT_LT(pushed, -0.01) << scene.name;
    EXPECT_LE(difference, 1e-10) << scene.name;  // 2e-15
  }
}

/// Bodies of which every particle is exposed, and others of which the inside is not.
struct Shape {
  const char* name;
  const char* dimension;
  const char* box;
  double ratio;
  long long inside;  ///< particles that are not exposed
};

TEST(ThinContact, ExposedAreThinBodiesWholeAndThickOnesAtTheirSurface) {
  const Shape shapes[] = {
      {"strip", "plane-strain", "min: [0, 0], max: [30, 1]", 3.015, 0},
      {"strip, short horizon", "plane-strain", "min: [0, 0], max: [30, 1]", 1.015, 0},
      {"strip, long horizon", "plane-strain", "min: [0, 0], max: [30, 1]", 5.015, 0},
      {"plate", "3", "min: [0, 0, 0], max: [12, 12, 1]", 3.015, 0},
      {"plate, short horizon", "3", "min: [0, 0, 0], max: [12, 12, 1]", 1.015, 0},
      {"row", "3", "min: [0, 0, 0], max: [20, 1, 1]", 3.015, 0},
      {"square", "plane-strain", "min: [0, 0], max: [20, 20]", 3.015, 256},
      {"cube", "3", "min: [0, 0, 0], max: [12, 12, 12]", 3.015, 512},
      {"cube, long horizon", "3", "min: [0, 0, 0], max: [14, 14, 14]", 4.015, 896},
  };
  for (const Shape& shape : shapes) {
    const deck::Deck deck = deck_of(fmt::format(R"(
dimension: {}
body: [{{name: b, shape: {{box: {{{}}}}}, spacing: 1, material: steel}}]
horizon: {{ratio: {}}}
materials: {{steel: {{model: elastic, young_modulus: 210e3, poisson_ratio: 0.3, density: 7.85e-9}}}}
dynamics: explicit
explicit: {{contact: {{}}}}
boundary: []
steps: {{end: 1, count: 1}}
)",
                                                shape.dimension, shape.box, shape.ratio));
    const mechanics::Scene scene = mechanics::build_scene(deck, Communicator(MPI_COMM_SELF));
    const auto exposed = static_cast<long long>(motion::find_exposed(scene).particle.size());
    EXPECT_EQ(scene.owned() - exposed, shape.inside) << shape.name;
  }
}

}  // namespace
}  // namespace perinox::test
