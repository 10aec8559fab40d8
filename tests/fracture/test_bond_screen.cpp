/// The screen of motions: of any state it lets every bond through that has come to its limit, on a lattice and in
/// pairs, and nothing that is not a bond; what breaks after a time step is what breaks without it.
#include <gtest/gtest.h>

#include <cmath>

#include "perinox/fracture/bond_breaking.hpp"
#include "perinox/motion/explicit_motion.hpp"
#include "perinox/motion/stable_step.hpp"
#include "support/broken.hpp"
#include "support/fracture.hpp"
#include "support/measured.hpp"
#include "support/scenes.hpp"

namespace perinox::test {
namespace {

using mechanics::Layout;

/// Two bodies, the second of a material without a law.
deck::Deck two_blocks(bool flat, bool small, const std::string& damage, const std::string& model = "elastic") {
  return deck_of(fmt::format(R"(
dimension: {}
body:
  - {{name: one, shape: {{box: {{min: {}, max: {}}}}}, spacing: 0.5, material: brittle}}
  - {{name: two, shape: {{box: {{min: {}, max: {}}}}}, spacing: 0.5, material: plain}}
horizon: {{ratio: 2.515}}
quadrature: partial-volume
influence: inverse
deformation: {}
materials:
  brittle: {{model: {}, young_modulus: 1000, poisson_ratio: 0.3, density: 1.0e-9, damage: {{{}}}}}
  plain: {{model: elastic, young_modulus: 3000, poisson_ratio: 0.2, density: 1.0e-9}}
sets: {{foot: {{where: "x < 1"}}, middle: {{where: "x > 2 && x < 2.5"}}}}
boundary: [{{set: foot, displacement: {{x: 0, y: 0{}}}}}]
fracture: {{unbreakable: [middle]}}
)",
                             flat ? "plane-strain" : "3", flat ? "[0, 0]" : "[0, 0, 0]",
                             flat ? "[5, 4]" : "[3, 2.5, 2]", flat ? "[5, 0]" : "[3, 0, 0]",
                             flat ? "[7, 4]" : "[4, 2.5, 2]", small ? "small" : "finite", model, damage,
                             flat ? "" : ", z: 0"));
}

mechanics::Scene scene_of(const deck::Deck& deck, Layout layout) {
  test::Materials materials;
  for (const deck::Material& material : deck.materials) materials.push_back(materials::make(material, deck.dimension));
  return test::make_scene(deck, std::move(materials), layout);
}

std::array<GlobalId, 2> ids_of(const mechanics::Scene& scene, LocalIndex i, LocalIndex j) {
  const GlobalId a = scene.body().id[i], b = scene.body().id[j];
  return {std::min(a, b), std::max(a, b)};
}

/// All that come to their limit, looked at closely one by one.
BrokenSet critical(const deck::Deck& deck, mechanics::Scene& scene, const mechanics::Committed& state, double& worst) {
  const std::size_t before = scene.broken().size();
  fracture::BondBreaking breaking(deck, scene);
  worst = breaking.break_worst(state, breaking.bonds()).worst;
  return {scene.broken().begin() + static_cast<std::ptrdiff_t>(before), scene.broken().end()};
}

struct Screened {
  BrokenSet critical;
  std::size_t candidates = 0, missed = 0, strange = 0;
};

/// What the screen of a random state lets through, a tenth of the bonds gone.
Screened screen(const deck::Deck& deck, Layout layout, double amplitude, double& worst) {
  mechanics::Scene scene = scene_of(deck, layout);
  EXPECT_EQ(scene.lattice() != nullptr, layout == Layout::automatic);
  scene.break_bonds(test::some_bonds(scene, 0.1, 5));
  const mechanics::Committed state = test::committed_after(scene, {test::random_field(scene, amplitude, 3)});
  std::vector<double> points(static_cast<std::size_t>(scene.local() * (2 + bonds::mandel_size(scene.dimension()))));
  mechanics::Evaluation evaluation(scene);
  mechanics::force_states(evaluation, state, points.data());
  const auto limits = fracture::bond_limits(deck, scene);
  const bool energies = limits[0].kind == fracture::BondLimit::Kind::energy;

  BrokenSet all, candidates;
  for (const auto& bond : test::all_bonds(scene)) all.insert(ids_of(scene, bond[0], bond[1]));
  fracture::BondScreen screen(scene, limits);
  Screened found;
  for (const auto& bond : screen.find(state.displacement().data(), energies ? points.data() : nullptr)) {
    const auto ids = ids_of(scene, bond.near, bond.far);
    if (!all.count(ids) || !candidates.insert(ids).second) ++found.strange;
    const double length = std::sqrt([&] {
      double square = 0;
      for (int c = 0; c < scene.dimension(); ++c)
        square += std::pow(scene.body().position(bond.far)[c] - scene.body().position(bond.near)[c], 2);
      return square;
    }());
    if (std::abs(bond.length / length - 1) > 1e-12) ++found.strange;
  }
  found.critical = critical(deck, scene, state, worst);
  found.candidates = candidates.size();
  for (const auto& ids : found.critical)
    if (!candidates.count(ids)) ++found.missed;
  return found;
}

TEST(BondScreen, NeverMissesACriticalBond) {
  double share = 1;
  for (const bool flat : {false, true})
    for (const bool small : {false, true})
      for (const double amplitude : {1e-4, 1e-2, 0.1, 0.4})  // of a spacing of 0.5: up to bonds that turn over
        for (const char* law : {"critical_stretch: ", "critical_bond_energy: "}) {
          SCOPED_TRACE(fmt::format("{} {} {} {}", flat, small, amplitude, law));
          BrokenSet first;
          for (const Layout layout : {Layout::automatic, Layout::pairs}) {
            double worst = 0;
            screen(two_blocks(flat, small, law + std::string("1e-30")), layout, amplitude, worst);
            for (const double of_worst : {0.9, 0.3}) {
              const std::string limit = fmt::format("{}{:.17g}", law, of_worst * worst * 1e-30);
              const Screened found = screen(two_blocks(flat, small, limit), layout, amplitude, worst);
              EXPECT_GT(found.critical.size(), 0u);
              EXPECT_EQ(found.missed, 0u);
              EXPECT_EQ(found.strange, 0u);
              share =
                  std::min(share, static_cast<double>(found.critical.size()) / static_cast<double>(found.candidates));
              if (of_worst == 0.9 && layout == Layout::automatic) first = found.critical;
              if (of_worst == 0.9 && layout == Layout::pairs) {
                EXPECT_EQ(found.critical, first);
              }
            }
          }
        }
  std::printf("least share of critical bonds among those let through: %.2g\n", share);
}

TEST(BondScreen, LetsFewThatAreNotCriticalThroughOfSmoothStates) {
  for (const Layout layout : {Layout::automatic, Layout::pairs})
    for (const char* law : {"critical_stretch: 0.0301", "critical_bond_energy: 2"}) {
      const deck::Deck deck = two_blocks(true, false, law);
      mechanics::Scene scene = scene_of(deck, layout);
      test::Vector field(scene.owned_unknowns());
      for (LocalIndex i = 0; i < scene.owned(); ++i) {
        const double x = scene.body().position(i)[0];
        field[static_cast<std::size_t>(2 * i)] = 0.02 * x + 0.0011 * x * x;
      }
      const mechanics::Committed state = test::committed_after(scene, {field});
      std::vector<double> points(static_cast<std::size_t>(scene.local() * 5));
      mechanics::Evaluation evaluation(scene);
      mechanics::force_states(evaluation, state, points.data());
      const auto limits = fracture::bond_limits(deck, scene);
      fracture::BondScreen screen(scene, limits);
      const bool energies = limits[0].kind == fracture::BondLimit::Kind::energy;
      const auto bonds = static_cast<double>(test::all_bonds(scene).size());
      const auto found = screen.find(state.displacement().data(), energies ? points.data() : nullptr).size();
      double worst = 0;
      const BrokenSet broken = critical(deck, scene, state, worst);
      std::printf("%s: %zu of %.0f bonds are let through, %zu are critical in the breakable part\n", law, found, bonds,
                  broken.size());
      EXPECT_LT(static_cast<double>(found), 0.35 * bonds);
      EXPECT_GT(broken.size(), 0u);
      EXPECT_GE(found, broken.size());
    }
}

/// Random velocities, one time step after the other: what breaks with the screen and what would without.
TEST(BondScreen, AfterATimeStepTheSameBondsBreakAsWithoutIt) {
  for (const bool flat : {false, true})
    for (const Layout layout : {Layout::automatic, Layout::pairs})
      for (const auto& [law, model] : {std::pair<std::string, std::string>{"critical_stretch: 0.02", "elastic"},
                                       {flat ? "critical_bond_energy: 0.5" : "critical_bond_energy: 2", "elastic"},
                                       {"ductile: {d0: 0.015}", "elastic-plastic, yield_stress: {shear: 5}"}}) {
        SCOPED_TRACE(fmt::format("{} {} {}", flat, law, layout == Layout::pairs));
        const deck::Deck deck = two_blocks(flat, false, law, model);
        mechanics::Scene scene = scene_of(deck, layout);
        loads::Boundary boundary(deck, scene);
        motion::ExplicitMotion::Settings settings;
        settings.rate = 0;
        mechanics::Committed start(scene);
        motion::ExplicitMotion motion(scene, boundary, motion::particle_masses(deck, scene), std::move(start),
                                      settings);
        deck::InitialVelocity all;
        all.set = "all";
        all.component[0] = deck::Expression("3e4*sin(1.3*x + 2*y)", {});
        all.component[1] = deck::Expression("2e4*cos(2.1*x - y)", {});
        motion.set_velocity({all});
        fracture::BondBreaking breaking(deck, scene);
        BrokenSet so_far;
        std::size_t steps_with = 0;
        const double dt = motion.stable_time_step();
        for (int step = 0; step < 40; ++step) {
          motion.step(dt);
          mechanics::Scene beside = scene_of(deck, layout);
          std::vector<mechanics::BondEnds> gone;
          for (const auto& ids : so_far)
            gone.push_back({static_cast<LocalIndex>(ids[0]), static_cast<LocalIndex>(ids[1])});
          beside.break_bonds(gone);
          double worst = 0;
          const BrokenSet expected = critical(deck, beside, motion.committed(), worst);
          const long long broken = breaking.break_all(motion);
          EXPECT_EQ(broken, static_cast<long long>(expected.size()));
          so_far.insert(expected.begin(), expected.end());
          EXPECT_EQ(BrokenSet(scene.broken().begin(), scene.broken().end()), so_far);
          if (broken > 0) ++steps_with;
        }
        std::printf("%s: %zu bonds broken in %zu time steps\n", law.c_str(), so_far.size(), steps_with);
        EXPECT_GT(steps_with, 1u);
      }
}

}  // namespace
}  // namespace perinox::test
