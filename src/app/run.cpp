#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <type_traits>

#include "checkpointing.hpp"
#include "commands.hpp"
#include "perinox/core/clock.hpp"
#include "perinox/core/error.hpp"
#include "perinox/mechanics/scene.hpp"
#include "perinox/output/directory_lock.hpp"
#include "perinox/output/profile_table.hpp"
#include "perinox/output/run_writer.hpp"
#include "perinox/stepping/load_stepper.hpp"
#include "perinox/stepping/time_stepper.hpp"
#include "scene_report.hpp"
#include "stop_signal.hpp"

namespace perinox::app {

namespace {

/// Share of the work that may be missing without a warning: where it is known along the path of a step, along its
/// chord, and where part of the way went in time.
constexpr double worth_a_warning = 1e-4;
constexpr double worth_a_warning_of_chords = 0.05;
constexpr double worth_a_warning_in_time = 0.01;

/// Prints warnings about states that were reached and for which the model does not hold, and about those between.
template <class Stepper>
void say_doubts(const Stepper& stepper, const Communicator& communicator) {
  std::vector<std::string> sentences = stepper.validity() ? stepper.validity()->at_end() : std::vector<std::string>();
  if constexpr (std::is_same_v<Stepper, stepping::LoadStepper>)
    if (!stepper.jumps().empty()) sentences.push_back(stepper.jumps());
  if (!communicator.is_root()) return;
  for (const std::string& sentence : sentences) fmt::print(stderr, "warning: {}\n", sentence);
}

/// The remark on a share that is missing; "" if it is small.
std::string remark_on(double gap, const mechanics::Scene& scene, const stepping::Energies& e) {
  const std::string what = fmt::format("the external work is {:.2g} % {} than what is stored and dissipated",
                                       100 * std::abs(gap), gap > 0 ? "more" : "less");
  gap = std::abs(gap);
  if (e.damped != 0)
    return gap > worth_a_warning_in_time
               ? what +
                     "; the time steps of the phases in time are too long for what happens in them: take a smaller "
                     "explicit.safety"
               : "";
  if (!scene.from_sums())
    return gap > worth_a_warning_of_chords ? what +
                                                 "; it is taken along the chord of each step, and the steps are too "
                                                 "long for that: take more of them"
                                           : "";
  return gap > worth_a_warning
             ? what + "; the steps are solved too loosely for these to agree: take a smaller solver.newton.tolerance"
             : "";
}

/// Directory of the results: --output, or where the checkpoint lies, or results/<deck's name>.
std::string directory_of(const Options& options) {
  if (!options.output.empty()) return options.output;
  if (!options.restart.empty()) return restart_of(options).directory;
  return (std::filesystem::path("results") / std::filesystem::path(options.deck).stem()).string();
}

/// Takes the lock on the directory of the results, which the root holds for all ranks. Collective. Throws InputError.
std::unique_ptr<output::DirectoryLock> lock_directory(const Options& options, const Communicator& communicator) {
  std::unique_ptr<output::DirectoryLock> lock;
  std::string refusal;
  const std::string directory = directory_of(options);
  // A checkpoint that is not there is refused later, and no directory is made for it.
  const bool nothing = options.output.empty() && !options.restart.empty() && !std::filesystem::exists(directory);
  if (communicator.is_root() && !nothing) try {
      lock = std::make_unique<output::DirectoryLock>(directory, options.deck);
      if (!lock->remark().empty()) fmt::print(stderr, "warning: {}\n", lock->remark());
    } catch (const InputError& error) {
      refusal = error.what();
    }
  communicator.agree_on_input_error(refusal);
  return lock;
}

bool same_directory(const std::string& a, const std::string& b) {
  std::error_code error;
  return std::filesystem::equivalent(a, b, error) && !error;
}

/// Runs either stepper into the directory. It says where the time went, also for a run that stops short.
template <class Stepper>
void run_into(Stepper& stepper, const Problem& problem, const Options& options, const Communicator& communicator,
              const std::optional<Restart>& from, double begin) {
  const bool talk = communicator.is_root() && !options.quiet;
  if (talk) fmt::print("{}", problem.report.summary);
  say_remarks(problem, stepper.boundary(), communicator);
  const std::string directory = directory_of(options);
  const bool goes_on = from && communicator.any(communicator.is_root() && same_directory(from->directory, directory));
  if (talk && from)
    fmt::print(
        "restart {} step {}, t = {:.10g}: {}\n", from->head.attempt > 0 ? "within" : "after",
        from->head.step + (from->head.attempt > 0 ? 1 : 0), from->head.t,
        goes_on ? "the files of " + directory + " go on" : "new files in " + directory + " begin with the next step");
  const output::RunWriter::Continuation kept =
      goes_on
          ? output::RunWriter::Continuation{from->head.step, from->head.history_bytes, from->head.convergence_bytes,
                                            static_cast<int>(from->head.phases), static_cast<int>(from->head.attempt)}
          : output::RunWriter::Continuation();
  const body::Body& body = problem.scene.body();
  const auto writer = goes_on ? std::make_unique<output::RunWriter>(problem.deck, body, directory, options.quiet, kept)
                              : std::make_unique<output::RunWriter>(problem.deck, body, directory, options.quiet);
  const auto save = [&](StateWriter& to) { stepper.save(to); };
  Checkpointing checkpoints(options, problem.deck, save, *writer, body, directory, begin);
  stepper.on_commit([&](const StepRecord& record) { checkpoints.committed(record); });
  if constexpr (std::is_same_v<Stepper, stepping::LoadStepper>)
    stepper.on_stop([&](const StepRecord& last) { checkpoints.stopping(last); });
  stepper.on_passing([&](int step, double t) { checkpoints.passing(step, t); });
  const ProfileReading before = communicator.profile().read();
  const auto say_times = [&] {
    const ProfileReading times = communicator.slowest(communicator.profile().read() - before);
    if (talk) fmt::print("\n{}", output::profile_table(times));
  };
  try {
    stepper.run(*writer);
  } catch (const RunError& error) {
    say_times();
    say_doubts(stepper, communicator);
    const std::string command = checkpoints.resume_command();
    throw RunError(command.empty() ? error.what() : fmt::format("{}\nresume with: {}", error.what(), command));
  }
  say_times();
  say_doubts(stepper, communicator);
}

int run_in_time(Problem& problem, const Options& options, const Communicator& communicator,
                const std::optional<Restart>& from, double begin) {
  stepping::TimeStepper stepper(problem.deck, problem.scene);
  if (from) {
    output::CheckpointReader reader(from->file, problem.scene.body());
    stepper.restore(reader);
  }
  const std::string remark = stepper.plan().remark;
  if (communicator.is_root() && !remark.empty()) fmt::print(stderr, "warning: {}\n", remark);
  run_into(stepper, problem, options, communicator, from, begin);
  const motion::MotionEnergies& e = stepper.energies();
  if (communicator.is_root() && !options.quiet)
    fmt::print(
        "done: kinetic {:.6g}, stored {:.6g}, dissipated {:.6g}, damped {:.6g}, released {:.6g}, in contacts {:.6g}, "
        "external work {:.6g} ({:+.1e} of the largest not accounted for, {:.1e} at worst); results in {}\n",
        e.kinetic, e.stored, e.dissipated, e.damped, e.released, e.contact, e.external_work, -stepper.unaccounted(),
        stepper.worst_gain(), directory_of(options));
  if (communicator.is_root() && stepper.worst_gain() > worth_a_warning_in_time)
    fmt::print(stderr,
               "warning: up to {:.1f} % of the energy is not accounted for; the time steps are too long for what "
               "happens in them: take a smaller explicit.safety or time_step\n",
               100 * stepper.worst_gain());
  return 0;
}

}  // namespace

int run(const Options& options, const Communicator& communicator) {
  const double begin = now();
  deck::Deck deck = read_deck(options, communicator);
  const std::unique_ptr<output::DirectoryLock> lock = lock_directory(options, communicator);
  const std::optional<Restart> from = find_restart(options, deck, communicator);
  Problem problem = prepare(std::move(deck), communicator);
  note_stop_signals(communicator.is_root());
  if (problem.deck.dynamics == deck::Dynamics::explicit_)
    return run_in_time(problem, options, communicator, from, begin);
  stepping::LoadStepper stepper(problem.deck, problem.scene);
  if (from) {
    output::CheckpointReader reader(from->file, problem.scene.body());
    stepper.restore(reader);
  }
  run_into(stepper, problem, options, communicator, from, begin);
  const stepping::Energies& e = stepper.energies();
  const double gap = e.unaccounted();
  if (communicator.is_root() && !options.quiet)
    fmt::print(
        "done: stored {:.6g}, dissipated {:.6g}, external work {:.6g} ({:+.1e} of the largest not accounted for); "
        "results in {}\n",
        e.stored, e.dissipated, e.external_work, gap, directory_of(options));
  for (const std::string& remark : {stepper.unreached(), remark_on(gap, problem.scene, e)})
    if (communicator.is_root() && !remark.empty()) fmt::print(stderr, "warning: {}\n", remark);
  return 0;
}

}  // namespace perinox::app
