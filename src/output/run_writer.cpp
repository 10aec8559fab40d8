#include "perinox/output/run_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <optional>
#include <utility>
#include <vector>

#include "agree.hpp"
#include "perinox/core/error.hpp"
#include "perinox/deck/read.hpp"
#include "perinox/output/tables.hpp"
#include "results_file.hpp"
#include "run_directory.hpp"
#include "terminal.hpp"

namespace perinox::output {

namespace {
std::vector<std::string> block_names(const deck::Deck& deck) {
  std::vector<std::string> names;
  for (const deck::BodyPart& part : deck.body) names.push_back(part.name);
  return names;
}
}  // namespace

struct RunWriter::Files {
  Communicator communicator;
  std::string directory;
  int every;
  std::vector<std::string> asked_fields;
  bool fields_checked = false;
  int current_step = 0;
  int committed_step = 0;  ///< the last one
  int attempt = 1;
  int phases = 0;  ///< phases in time that are over

  std::optional<ResultsFile> results;
  // The following exist on rank 0 only.
  std::optional<HistoryTable> history;
  std::optional<ConvergenceTable> convergence;
  std::optional<Terminal> terminal;

  Files(const deck::Deck& deck, const body::Body& body, std::string where)
      : communicator(body.communicator), directory(std::move(where)), every(deck.output.every) {
    asked_fields = {"displacement", "force"};
    for (const std::string& field : deck.output.fields)
      if (std::find(asked_fields.begin(), asked_fields.end(), field) == asked_fields.end())
        asked_fields.push_back(field);
  }

  /// The carried fields that were asked for, in the order asked. It says once which of them are not there.
  std::vector<Field> chosen(const std::vector<Field>& carried) {
    std::vector<Field> fields;
    for (const std::string& name : asked_fields) {
      const auto found = std::find_if(carried.begin(), carried.end(), [&](const auto& f) { return f.name == name; });
      if (found != carried.end())
        fields.push_back(*found);
      else if (!fields_checked && communicator.is_root())
        std::cerr << fmt::format("warning: this scene carries no field {}: it is not in results.h5\n", name);
    }
    fields_checked = true;
    return fields;
  }

  void agree_on_tables() const {
    std::string sentence;
    if (history) sentence = history->failure().empty() ? convergence->failure() : history->failure();
    agree_on_run_error(communicator, sentence);
  }
};

RunWriter::RunWriter(const deck::Deck& deck, const body::Body& body, std::string directory, bool quiet)
    : files_(std::make_unique<Files>(deck, body, std::move(directory))) {
  begin(deck, body, quiet, nullptr);
}

RunWriter::RunWriter(const deck::Deck& deck, const body::Body& body, std::string directory, bool quiet,
                     const Continuation& from)
    : files_(std::make_unique<Files>(deck, body, std::move(directory))) {
  begin(deck, body, quiet, &from);
}

void RunWriter::begin(const deck::Deck& deck, const body::Body& body, bool quiet, const Continuation* from) {
  Files& files = *files_;
  const bool root = files.communicator.is_root();
  if (root && !quiet) files.terminal.emplace(std::cout, screen_is_watched());
  const auto say = [&](const std::string& sentence) {
    if (files.terminal && !sentence.empty()) files.terminal->say(sentence);
  };
  const std::string history = files.directory + "/history.csv", convergence = files.directory + "/convergence.csv";
  const HistoryTable::Columns columns = HistoryTable::Columns::of(deck);
  long long history_kept = 0, convergence_kept = 0;
  if (from == nullptr) {
    say(prepare_directory(files.directory, files.communicator));
  } else {
    require_directory(files.directory, files.communicator);
    files.phases = from->phases;
    if (from->attempt > 0) {
      files.current_step = from->step + 1;
      files.attempt = from->attempt;
    }
    const auto kept = [&](const char* file, const std::string& header, long long bytes) {
      const bool fits = root && GrowingFile::continuable(files.directory + "/" + file, header, bytes);
      if (files.communicator.any(fits)) return bytes;
      say(set_aside(files.directory, file, files.communicator));
      return 0LL;
    };
    history_kept = kept("history.csv", HistoryTable::header(history_names(deck), columns), from->history_bytes);
    convergence_kept = kept("convergence.csv", ConvergenceTable::header(), from->convergence_bytes);
  }
  std::string failure;
  if (root) {
    files.history.emplace(history, history_names(deck), columns, history_kept);
    files.convergence.emplace(convergence, convergence_kept);
    failure = replace_file(files.directory + "/deck.resolved.yaml", deck::write_resolved(deck, files.directory));
  }
  agree_on_run_error(files.communicator, failure);
  files.agree_on_tables();
  if (from != nullptr) files.committed_step = from->step;
  if (from != nullptr) try {
      files.results.emplace(files.directory, deck.title, files.asked_fields, body,
                            ResultsFile::Continue{from->step, from->phases});
      return;
    } catch (const RunError& error) {
      say(fmt::format("results.h5 is begun anew after step {}: {}", from->step, error.what()));
      say(set_aside(files.directory, "results.h5", files.communicator));
    }
  files.results.emplace(files.directory, deck.title, block_names(deck), body,
                        deck.steps.control == deck::Control::arc_length);
}

RunWriter::Continuation RunWriter::sync(int step) {
  Files& files = *files_;
  const Profile::Scope timed(files.communicator.profile(), Section::output);
  Continuation now;
  now.step = step;
  now.phases = files.phases;
  now.attempt = files.current_step > step ? files.attempt : 0;
  if (files.history) now.history_bytes = files.history->sync();
  if (files.convergence) now.convergence_bytes = files.convergence->sync();
  files.agree_on_tables();
  files.results->sync();
  now.history_bytes = files.communicator.max(now.history_bytes);
  now.convergence_bytes = files.communicator.max(now.convergence_bytes);
  return now;
}

RunWriter::~RunWriter() = default;

void RunWriter::newton_iteration(const NewtonIteration& row) {
  Files& files = *files_;
  const Profile::Scope timed(files.communicator.profile(), Section::output);
  if (row.step != files.current_step) files.attempt = 1;
  files.current_step = row.step;
  if (files.convergence) files.convergence->row(row, files.attempt);
  if (files.terminal) files.terminal->newton_iteration(row, files.attempt);
}

void RunWriter::step_rejected(double t_from, double t_to, const std::string& reason) {
  ++files_->attempt;
  if (files_->terminal) files_->terminal->step_rejected(t_from, t_to, reason);
}

void RunWriter::bonds_broken(const BreakingPass& pass) {
  ++files_->attempt;
  if (files_->terminal) files_->terminal->bonds_broken(pass);
}

void RunWriter::phase_begins(const MotionPhase& phase) {
  if (files_->terminal) files_->terminal->phase_begins(phase);
}

void RunWriter::phase_ended(const MotionPhase& phase) {
  const Profile::Scope timed(files_->communicator.profile(), Section::output);
  if (files_->terminal) files_->terminal->phase_ended(phase);
  files_->results->write(phase);
  files_->phases = phase.number;
}

void RunWriter::moves(const MotionMoment& moment) {
  if (files_->terminal) files_->terminal->moves(moment);
}

void RunWriter::note(const std::string& sentence) {
  if (files_->terminal) files_->terminal->say("  " + sentence);
}

void RunWriter::write(const StepRecord& record) {
  Files& files = *files_;
  if (record.step % files.every == 0 || record.last) files.results->write(record, files.chosen(record.fields));
  if (files.history) files.history->row(record);
  files.agree_on_tables();
}

void RunWriter::run_begins(const StepRecord& record) {
  const Profile::Scope timed(files_->communicator.profile(), Section::output);
  write(record);
}

void RunWriter::step_committed(const StepRecord& record) {
  Files& files = *files_;
  const Profile::Scope timed(files.communicator.profile(), Section::output);
  files.current_step = 0;
  files.committed_step = record.step;
  write(record);
  if (files.terminal) files.terminal->step_committed(record);
}

void RunWriter::run_stopped(const StepRecord* last) {
  Files& files = *files_;
  const Profile::Scope timed(files.communicator.profile(), Section::output);
  if (last && (last->step % files.every != 0 || last->step > files.committed_step))
    files.results->write(*last, files.chosen(last->fields));
}

}  // namespace perinox::output
