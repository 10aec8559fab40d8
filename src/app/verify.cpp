#include <fmt/format.h>

#include <algorithm>

#include "commands.hpp"
#include "perinox/mechanics/tangent_check.hpp"
#include "perinox/stepping/load_stepper.hpp"
#include "scene_report.hpp"

namespace perinox::app {

namespace {
// Bounds of `verify`. A central difference of the whole force reaches about 1e-9 (docs/theory.md, section 6).
constexpr double direction_bound = 1e-7;
constexpr double symmetry_bound = 1e-12;
constexpr double assembled_bound = 1e-13;
// The sparse matrix is compared if it stays below this many bonds, which is about 1 GB.
constexpr long long assembled_bonds = 1'500'000;
}  // namespace

int verify(const Options& options, const Communicator& communicator) {
  Problem problem = prepare(options, communicator);
  const deck::Deck& deck = problem.deck;
  mechanics::Scene& scene = problem.scene;
  if (deck.dynamics == deck::Dynamics::explicit_)
    deck::refuse(deck.resolved.at("dynamics").location(),
                 "verify follows a quasi-static run; give --set dynamics=quasi-static, or another deck");
  mechanics::PeridynamicMedium medium(scene);
  stepping::LoadStepper stepper(deck, medium);
  const bool talk = communicator.is_root() && !options.quiet;
  say_remarks(problem, stepper.boundary(), communicator);
  const bool with_assembled = communicator.sum(scene.families().directed) <= assembled_bonds;
  if (talk) {
    fmt::print("{}", problem.report.summary);
    fmt::print("{:>5} {:>10} {:>9} {:>12} {:>12} {:>12}", "step", "t", "yielding", "difference", "symmetry",
               "assembled");
    for (const deck::Material& material : deck.materials) fmt::print(" {:>12}", material.name.substr(0, 12));
    fmt::print("\n");
  }

  int step = 0;
  mechanics::TangentCheck worst;
  stepper.on_convergence([&] {
    const std::vector<double>& after = medium.trial().displacement;
    const std::vector<double> displacement(after.begin(),
                                           after.begin() + static_cast<std::ptrdiff_t>(scene.owned_unknowns()));
    const mechanics::TangentCheck check =
        mechanics::check_tangent(scene, medium.committed(), displacement, deck.solver.form, with_assembled,
                                 1 + 2 * static_cast<std::uint64_t>(step));
    ++step;
    worst.direction = std::max(worst.direction, check.direction);
    worst.symmetry = std::max(worst.symmetry, check.symmetry);
    worst.assembled = std::max(worst.assembled, check.assembled);
    if (!talk) return;
    fmt::print("{:5} {:10.6g} {:9} {:12.2e} {:12.2e} ", step, medium.trial().t, check.yielding, check.direction,
               check.symmetry);
    fmt::print("{:>12}", check.assembled < 0 ? std::string("-") : fmt::format("{:.2e}", check.assembled));
    for (const double error : check.of_material) fmt::print(" {:12.2e}", error);
    fmt::print("\n");
    std::fflush(stdout);
  });
  Observer nobody;
  stepper.run(nobody);

  const bool holds =
      worst.direction <= direction_bound && worst.symmetry <= symmetry_bound && worst.assembled <= assembled_bound;
  if (communicator.is_root())
    fmt::print("{}: difference {:.2e} (bound {:.0e}), symmetry {:.2e} ({:.0e}), assembled {:.2e} ({:.0e})\n",
               holds ? "the tangent holds" : "the tangent does NOT hold", worst.direction, direction_bound,
               worst.symmetry, symmetry_bound, std::max(worst.assembled, 0.0), assembled_bound);
  return holds ? 0 : 1;
}

}  // namespace perinox::app
