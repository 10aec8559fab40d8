#include <fmt/format.h>

#include "perinox/app/commands.hpp"
#include "perinox/app/scene_report.hpp"
#include "perinox/deck/read.hpp"
#include "perinox/solve/bond_limits.hpp"
#include "perinox/solve/boundary.hpp"
#include "perinox/solve/time_stepper.hpp"

namespace perinox::app {

namespace {

/// Rough: what a lattice body takes on a core of 2020, docs/performance.md.
constexpr double nanoseconds_a_bond = 1.5, nanoseconds_a_pair = 4;

/// Time step, number of time steps, cost; empty for a quasi-static deck. Collective.
std::string motion_in_words(Problem& problem, const Communicator& communicator) {
  if (problem.deck.dynamics != deck::Dynamics::explicit_) return "";
  solve::TimeStepper stepper(problem.deck, problem.scene);
  const solve::TimeStepPlan plan = stepper.plan();
  const auto bonds = static_cast<double>(communicator.sum(problem.scene.families().directed));
  const double seconds = 1e-9 * bonds * static_cast<double>(plan.time_steps) *
                         (problem.scene.lattice() ? nanoseconds_a_bond : nanoseconds_a_pair);
  std::string text = fmt::format(
      "motion in time\n  {} time steps of {:.4g}; the largest stable one is {:.4g}\n  about {:.3g} core seconds, as "
      "long as nothing flows\n",
      plan.time_steps, plan.length, plan.stable, seconds);
  if (const solve::Contact* contact = stepper.motion().contact())
    text += fmt::format("  contact: {} exposed particles are watched\n",
                        communicator.sum(static_cast<long long>(contact->exposed())));
  if (!plan.remark.empty()) text += fmt::format("  warning: {}\n", plan.remark);
  return text;
}

}  // namespace

int check(const Options& options, const Communicator& communicator) {
  Problem problem = prepare(options, communicator);
  const solve::Boundary boundary(problem.deck, problem.scene);
  say_remarks(boundary, communicator);
  const std::string in_time = motion_in_words(problem, communicator);
  std::string damage;
  if (problem.deck.breaks())
    for (const std::string& line : solve::describe(solve::bond_limits(problem.deck, problem.scene), problem.deck))
      damage += fmt::format("  {}\n", line);
  if (!communicator.is_root() || options.quiet) return 0;
  fmt::print("{}{}", problem.report.summary, problem.report.details);
  fmt::print("boundary\n  {} unknowns prescribed, {} free\n", boundary.prescribed_count(), boundary.free_count());
  if (!damage.empty()) fmt::print("fracture\n{}", damage);
  fmt::print("{}", in_time);
  fmt::print("\n# the resolved deck\n{}", deck::write_resolved(problem.deck));
  fmt::print("# {} is a valid deck\n", options.deck);
  return 0;
}

}  // namespace perinox::app
