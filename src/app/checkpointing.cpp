#include "checkpointing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "perinox/core/clock.hpp"
#include "perinox/core/error.hpp"
#include "perinox/deck/read.hpp"
#include "perinox/materials/material.hpp"
#include "stop_signal.hpp"

namespace perinox::app {

namespace {

namespace fs = std::filesystem;

/// A step is expected to last at most this many times as long as the one before.
constexpr double caution = 1.25;
/// By the clock a checkpoint comes at the earliest after this many times the duration of the last one: 5 % of a run at
/// most.
constexpr double most_writing = 20;

/// The longest time from one moment to the next, of late. A long one is forgotten slowly, so that one short time after
/// it does not make the run reckless. Moves `last` on to now.
double of_late(double longest, double& last) {
  const double moment = now(), since = moment - last;
  last = moment;
  return std::max(since, 0.8 * longest);
}

/// The sentence about the first file of the deck whose contents differ from those when the checkpoint was written; ""
/// if there is none. now: output::file_fingerprints().
std::string refuse_other_files(const deck::Deck& deck, const Restart& from, const std::string& now) {
  if (from.head.files.empty()) return "";  // none, or an earlier version did not note it
  std::istringstream before(from.head.files), after(now);
  const std::vector<deck::InputFile> files = deck::input_files(deck);
  std::string there, here;
  for (std::size_t k = 0; k < files.size() && std::getline(after, here); ++k) {
    if (std::getline(before, there) && there == here) continue;
    return fmt::format(
        "{}: the file {} of {} does not hold what it held when {} was written: put the old one back, or start anew "
        "without --restart",
        deck.file, files[k].path, files[k].key, from.file);
  }
  return "";
}

/// The text as a shell takes it for one word.
std::string word(const std::string& text) {
  const bool plain = !text.empty() && text.find_first_not_of(
                                          "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                          "0123456789_-+=./:,@%") == std::string::npos;
  if (plain) return text;
  std::string quoted = "'";
  for (const char letter : text) quoted += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  return quoted + "'";
}

}  // namespace

Restart restart_of(const Options& options) {
  Restart from;
  from.file =
      fs::is_directory(options.restart) ? (fs::path(options.restart) / "checkpoint.h5").string() : options.restart;
  from.directory = fs::path(from.file).parent_path().string();
  if (from.directory.empty()) from.directory = ".";
  return from;
}

std::optional<Restart> find_restart(const Options& options, const deck::Deck& deck, const Communicator& communicator) {
  if (options.restart.empty()) return {};
  Restart from = restart_of(options);
  from.head = output::read_checkpoint_head(from.file, communicator);
  std::string sentence = deck::not_in_checkpoints(deck);
  if (!sentence.empty())
    sentence = fmt::format("{}: --restart cannot go on with {}: no checkpoint holds that yet; start the run without it",
                           deck.file, sentence);
  communicator.agree_on_input_error(sentence);
  try {
    const deck::Deck before = deck::read_saved(from.head.deck, "the deck in " + from.file, materials::full_schema());
    sentence = deck::refuse_changes(deck::changed_keys(before.resolved, deck.resolved), deck, from.file, from.head.t);
  } catch (const InputError& error) {
    sentence =
        fmt::format("{} (written by perinox {}; this is {})", error.what(), from.head.perinox_version, PERINOX_VERSION);
  }
  communicator.agree_on_input_error(sentence);
  communicator.agree_on_input_error(refuse_other_files(deck, from, output::file_fingerprints(deck, communicator)));
  return from;
}

Checkpointing::Checkpointing(const Options& options, const deck::Deck& deck, std::function<void(StateWriter&)> save,
                             output::RunWriter& writer, const body::Body& body, const std::string& directory,
                             double begin)
    : options_(options),
      deck_(deck),
      save_(std::move(save)),
      writer_(writer),
      communicator_(body.communicator),
      asked_(deck::checkpoints(deck)),
      possible_(deck::not_in_checkpoints(deck).empty()),
      resolved_(deck::write_resolved(deck, deck::folder_of(deck.file))),
      files_(output::file_fingerprints(deck, communicator_)),
      file_((fs::path(directory) / "checkpoint.h5").string(), body),
      begin_(begin),
      last_(now()),
      last_pass_(last_),
      last_write_(last_) {}

void Checkpointing::committed(const StepRecord& record) {
  const bool never = !possible_ || asked_.every == 0;
  const bool due = !never && (record.last || (asked_.every ? record.step % *asked_.every == 0 : late()));
  if (due) write(record.step, record.t, false);
  longest_ = of_late(longest_, last_);
  last_pass_ = last_;
  const std::string reason = record.last ? "" : reason_to_stop(caution * longest_);
  if (reason.empty()) return;
  if (!due && possible_) write(record.step, record.t, false);
  throw RunError(
      fmt::format("stopped after step {}, t = {:.10g} of {:g}: {}", record.step, record.t, deck_.steps.end, reason));
}

void Checkpointing::stopping(const StepRecord& last) {
  if (possible_ && asked_.every != 0 && last_step_ != last.step) write(last.step, last.t, false);
}

bool Checkpointing::late() const {
  return communicator_.any(now() - last_write_ >= std::max(asked_.seconds, most_writing * writing_));
}

void Checkpointing::passing(int step, double t) {
  longest_pass_ = of_late(longest_pass_, last_pass_);
  const std::string reason = reason_to_stop(caution * (longest_pass_ + writing_));
  const bool due = possible_ && asked_.every != 0 && late();
  if (possible_ && (due || !reason.empty())) write(step, t, true);
  if (!reason.empty())
    throw RunError(
        fmt::format("stopped within step {}, t = {:.10g} of {:g}: {}", step + 1, t, deck_.steps.end, reason));
}

void Checkpointing::write(int step, double t, bool within) {
  const double before = now();
  const output::RunWriter::Continuation tables = writer_.sync(step);
  const Profile::Scope timed(communicator_.profile(), Section::output);
  output::CheckpointHead head;
  head.step = step;
  head.t = t;
  head.deck = resolved_;
  head.files = files_;
  head.history_bytes = tables.history_bytes;
  head.convergence_bytes = tables.convergence_bytes;
  head.phases = tables.phases;
  head.attempt = within ? std::max(tables.attempt, 1) : 0;
  file_.write(head, save_);
  ++count_;
  last_step_ = within ? -1 : step;
  last_write_ = now();
  writing_ = last_write_ - before;
}

std::string Checkpointing::reason_to_stop(double seconds) const {
  const std::string signal = noted_signal();
  if (communicator_.any(!signal.empty())) {
    // Perhaps only one of the ranks knows which signal it was.
    const std::vector<long long> numbers = communicator_.gather(static_cast<long long>(signal.empty()        ? 0
                                                                                       : signal == "SIGTERM" ? 1
                                                                                       : signal == "SIGINT"  ? 2
                                                                                                             : 3));
    const long long number = *std::max_element(numbers.begin(), numbers.end());
    return fmt::format("{} was received", number == 1 ? "SIGTERM" : number == 2 ? "SIGINT" : "SIGUSR1");
  }
  if (!asked_.time_limit) return "";
  const bool late = now() - begin_ + seconds > *asked_.time_limit;
  if (!communicator_.any(late)) return "";
  return fmt::format("another step may not end before steps.time_limit = {:g} s", *asked_.time_limit);
}

std::string Checkpointing::resume_command() const {
  const std::string file = count_ > 0 ? file_.path() : options_.restart;
  if (file.empty()) return "";
  std::string command = communicator_.size() > 1 ? fmt::format("mpirun -np {} ", communicator_.size()) : "";
  command += fmt::format("perinox run {} --restart {}", word(options_.deck), word(file));
  for (const std::string& set : options_.overrides) command += " --set " + word(set);
  if (count_ == 0 && !options_.output.empty()) command += " --output " + word(options_.output);
  return command;
}

}  // namespace perinox::app
