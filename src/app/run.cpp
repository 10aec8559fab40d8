#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "perinox/app/commands.hpp"
#include "perinox/app/scene_report.hpp"
#include "perinox/core/error.hpp"
#include "perinox/mechanics/scene.hpp"
#include "perinox/output/profile_table.hpp"
#include "perinox/output/run_writer.hpp"
#include "perinox/solve/load_stepper.hpp"

namespace perinox::app {

namespace {

/// Share of the work that may be missing without a word.
constexpr double worth_a_warning = 0.05;

/// What of the external work is neither stored nor dissipated, over the largest of the three.
double unaccounted(const solve::Energies& e) {
  const double size = std::max({std::abs(e.external_work), std::abs(e.stored), std::abs(e.dissipated)});
  return size > 0 ? (e.external_work - e.stored - e.dissipated - e.released - e.relaxed) / size : 0;
}

}  // namespace

int run(const Options& options, const Communicator& communicator) {
  Problem problem = prepare(options, communicator);
  const deck::Deck& deck = problem.deck;
  mechanics::Scene& scene = problem.scene;
  solve::LoadStepper stepper(deck, scene);

  const bool talk = communicator.is_root() && !options.quiet;
  if (talk) fmt::print("{}", problem.report.summary);
  say_remarks(stepper.boundary(), communicator);

  const std::string directory =
      options.output.empty() ? (std::filesystem::path("results") / std::filesystem::path(options.deck).stem()).string()
                             : options.output;
  output::RunWriter writer(deck, scene.body(), directory, options.quiet);
  const ProfileReading before = communicator.profile().read();
  const auto say_times = [&] {  // of a run that stops short too
    const ProfileReading times = communicator.slowest(communicator.profile().read() - before);
    if (talk) fmt::print("\n{}", output::profile_table(times));
  };
  try {
    stepper.run(writer);
  } catch (const RunError&) {
    say_times();
    throw;
  }
  say_times();
  const solve::Energies& e = stepper.energies();
  const double gap = unaccounted(e);
  if (talk)
    fmt::print(
        "done: stored {:.6g}, dissipated {:.6g}, external work {:.6g} ({:+.1e} of it not accounted for); results in "
        "{}\n",
        e.stored, e.dissipated, e.external_work, gap, directory);
  if (communicator.is_root() && std::abs(gap) > worth_a_warning)
    fmt::print(stderr,
               "warning: the external work is {:.1f} % {} than what is stored and dissipated; it is summed by the "
               "trapezoidal rule, and the steps are too long for that: take more of them\n",
               100 * std::abs(gap), gap > 0 ? "more" : "less");
  return 0;
}

}  // namespace perinox::app
