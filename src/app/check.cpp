#include <fmt/format.h>

#include "commands.hpp"
#include "perinox/deck/read.hpp"
#include "perinox/deck/remarks.hpp"
#include "perinox/fracture/bond_limits.hpp"
#include "perinox/loads/boundary.hpp"
#include "perinox/stepping/plastic_stretch.hpp"
#include "perinox/stepping/time_stepper.hpp"
#include "scene_report.hpp"

namespace perinox::app {

namespace {

/// Rough times of a bond of a lattice body, and of a pair of any other body, on a core of 2020 (docs/performance.md).
constexpr double nanoseconds_a_bond = 1.5, nanoseconds_a_pair = 4;

/// A load step takes at least two Newton iterations, each with a linear solve of twenty products and its
/// preconditioner.
constexpr double least_products_a_step = 60;
/// Nobody means to wait for a core's year.
constexpr double long_seconds = 365.25 * 86400;

/// Core seconds of one product of the tangent, or of one time step. Collective.
double seconds_of_a_sweep(const Problem& problem, const Communicator& communicator) {
  const auto bonds = static_cast<double>(communicator.sum(problem.scene.families().directed));
  return 1e-9 * bonds * (problem.scene.lattice() ? nanoseconds_a_bond : nanoseconds_a_pair);
}

std::string remark_on(double seconds, const char* what) {
  if (seconds < long_seconds) return "";
  return fmt::format("  warning: {:.3g} years of a core; is {} what you mean?\n", seconds / long_seconds, what);
}

/// The number of load steps, what is written, and the least cost in words. It is empty for a deck that moves in time.
/// Collective.
std::string load_steps_in_words(const Problem& problem, const Communicator& communicator) {
  const deck::Deck& deck = problem.deck;
  if (deck.dynamics == deck::Dynamics::explicit_) return "";
  const bool arc = deck.steps.control == deck::Control::arc_length;
  const int count = arc ? deck.arc_length.max_steps : deck.steps.count;
  const double seconds = least_products_a_step * count * seconds_of_a_sweep(problem, communicator);
  return fmt::format(
             "load steps\n  {}{} of them{}, every {} written to results.h5; {} about {:.3g} core seconds, more where "
             "it "
             "flows or breaks\n",
             arc ? "at most " : "", count, arc ? "" : fmt::format(", each {:.4g} in t", deck.steps.end / count),
             deck.output.every == 1 ? std::string("one") : fmt::format("{}th", deck.output.every),
             arc ? "then" : "at least", seconds) +
         remark_on(seconds, arc ? "arc_length.max_steps" : "steps.count");
}

/// The time step, the number of time steps and the cost in words. It is empty for a quasi-static deck. Collective.
std::string motion_in_words(Problem& problem, const Communicator& communicator) {
  if (problem.deck.dynamics != deck::Dynamics::explicit_) return "";
  stepping::TimeStepper stepper(problem.deck, problem.scene);
  const stepping::TimeStepPlan plan = stepper.plan();
  const double seconds = static_cast<double>(plan.time_steps) * seconds_of_a_sweep(problem, communicator);
  std::string text = fmt::format(
      "motion in time\n  {} time steps of {:.4g}; the largest stable one is {:.4g}\n  about {:.3g} core seconds, as "
      "long as nothing flows\n",
      plan.time_steps, plan.length, plan.stable, seconds);
  if (const motion::Contact* contact = stepper.motion().contact())
    text += fmt::format("  contact: {} exposed particles are watched\n",
                        communicator.sum(static_cast<long long>(contact->exposed())));
  text += remark_on(seconds, "steps.end");
  if (!plan.remark.empty()) text += fmt::format("  warning: {}\n", plan.remark);
  return text;
}

/// A warning if the prescribed displacements stretch a material that flows farther than its law holds; otherwise empty.
/// Collective.
std::string stretch_in_words(const Problem& problem, const loads::Boundary& boundary) {
  if (!stepping::flows_finitely(problem.scene)) return "";
  const stepping::BondStretch found = stepping::largest_prescribed_stretch(problem.deck, problem.scene, boundary);
  if (found.stretch <= stepping::most_plastic_stretch) return "";
  return fmt::format(
      "  warning: at t = {:.6g} the prescribed displacements stretch a material that flows by {:.3g} % about ({:g}, "
      "{:g}, {:g}); {}\n",
      found.t, 100 * found.stretch, found.place[0], found.place[1], found.place[2], stepping::consequence_of_stretch());
}

}  // namespace

int check(const Options& options, const Communicator& communicator) {
  Problem problem = prepare(options, communicator);
  const loads::Boundary boundary(problem.deck, problem.scene);
  say_remarks(problem, boundary, communicator);
  if (communicator.is_root())
    for (const std::string& remark : deck::remarks_on_fields(problem.deck, materials::full_schema()))
      fmt::print(stderr, "note: {}\n", remark);
  const std::string steps = load_steps_in_words(problem, communicator);
  const std::string in_time = motion_in_words(problem, communicator);
  const std::string stretch = stretch_in_words(problem, boundary);
  std::string damage;
  if (problem.deck.breaks())
    for (const std::string& line : fracture::describe(fracture::bond_limits(problem.deck, problem.scene), problem.deck))
      damage += fmt::format("  {}\n", line);
  if (!communicator.is_root() || options.quiet) return 0;
  fmt::print("{}{}", problem.report.summary, problem.report.details);
  fmt::print("boundary\n  {} unknowns prescribed, {} free\n{}", boundary.prescribed_count(), boundary.free_count(),
             stretch);
  if (!damage.empty()) fmt::print("fracture\n{}", damage);
  fmt::print("{}{}", steps, in_time);
  fmt::print("\n# the resolved deck\n{}", deck::write_resolved(problem.deck));
  fmt::print("# {} is a valid deck\n", options.deck);
  return 0;
}

}  // namespace perinox::app
