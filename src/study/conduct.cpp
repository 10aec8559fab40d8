#include "perinox/study/conduct.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <thread>

#include "perinox/core/error.hpp"
#include "perinox/deck/read.hpp"
#include "perinox/output/directory_lock.hpp"
#include "perinox/output/table_reader.hpp"
#include "report.hpp"
#include "run_record.hpp"

namespace perinox::study {

namespace {
namespace fs = std::filesystem;

void write_file(const fs::path& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (!file) throw RunError(path.string() + " cannot be written");
}

/// A run with what is known of it before it is run.
struct Prepared {
  PlannedRun run;
  std::string folder;
  std::string fingerprint;
  std::optional<RunRecord> record;  ///< record of an earlier run of the same
};

std::vector<Prepared> prepare(const Study& study, const Request& request, const deck::Schema& schema) {
  std::vector<Prepared> all;
  for (PlannedRun& run : planned_runs(study)) {
    deck::Deck deck;
    try {
      deck = deck::read(study.deck, schema, run.overrides);
    } catch (const InputError& error) {
      throw InputError(fmt::format("{} (in the run {} of {})", error.what(), run.name, study.file));
    }
    check_measures(study, run, deck);
    Prepared one;
    one.folder = request.output + "/runs/" + run.name;
    one.fingerprint = fingerprint(deck, run.ranks, study.repeat);
    if (!request.again) one.record = read_record(one.folder);
    if (one.record && one.record->fingerprint != one.fingerprint) one.record.reset();
    one.run = std::move(run);
    all.push_back(std::move(one));
  }
  return all;
}

/// Waits until nobody uses the folder. A run of a study that was killed finishes its step before it ends, and writes
/// into its folder until then. Throws InputError if that takes longer than a minute.
void wait_until_free(const std::string& folder, const std::string& deck) {
  constexpr int most_looks = 600;
  for (int looks = 0; looks < most_looks && output::DirectoryLock::held(folder); ++looks)
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  const output::DirectoryLock lock(folder, deck);
}

RunRecord run_in(const std::string& folder, const Study& study, const Prepared& one) {
  if (fs::is_directory(folder)) wait_until_free(folder, study.deck);
  fs::remove_all(folder);
  fs::create_directories(folder);
  std::vector<std::string> command{own_path(), "run", study.deck, "--output", folder};
  for (const std::string& setting : one.run.overrides) {
    command.emplace_back("--set");
    command.push_back(setting);
  }
  const std::string log = folder + "/run.log", errors = folder + "/run.err";
  RunRecord record;
  record.fingerprint = one.fingerprint;
  record.outcome = run_child(on_ranks(one.run.ranks, command), log, errors);
  if (record.outcome.status == 2)
    throw InputError(fmt::format("{} (in the run {} of {})", reason_in(errors), one.run.name, study.file));
  if (record.outcome.status != 0) record.reason = reason_in(errors);
  if (record.outcome.status > 128)
    record.reason = fmt::format("ended by signal {}{}", record.outcome.status - 128,
                                record.outcome.status == 137 ? ": out of memory, or killed" : "");
  record.bonds = bonds_in(log);
  return record;
}

/// Makes one run and keeps the cheapest of its repetitions. Only a run that ended by itself gets a record; one that was
/// ended from outside is tried again next time.
RunRecord run_one(const Study& study, const Prepared& one) {
  const std::string other = one.folder + ".repeat";
  RunRecord best = run_in(one.folder, study, one);
  for (int k = 1; k < study.repeat && best.outcome.status == 0; ++k) {
    const RunRecord record = run_in(other, study, one);
    if (record.outcome.status == 0 && record.outcome.cpu_seconds < best.outcome.cpu_seconds) {
      fs::remove_all(one.folder);
      fs::rename(other, one.folder);
      best = record;
    }
  }
  fs::remove_all(other);
  if (best.outcome.status < 128 && !was_told_to_stop(best.reason)) write_record(one.folder, best);
  return best;
}

void say_start(const Study& study, const std::vector<Prepared>& all, const Request& request) {
  const auto ready = std::count_if(all.begin(), all.end(), [](const Prepared& one) { return one.record.has_value(); });
  fmt::print("{}\n  {} runs of {}, {} of them finished earlier; in {}\n", study.title, all.size(), study.deck, ready,
             request.output);
  std::fflush(stdout);
}

void say_end(std::size_t number, std::size_t count, const Prepared& one, const RunRecord& record) {
  fmt::print("  {:>{}}/{}  {}  {}\n", number, std::to_string(count).size(), count, one.run.name,
             one.record ? "finished earlier"
                        : fmt::format("{:.2f} s, {:.2f} CPU s, {:.0f} MB{}", record.outcome.wall_seconds,
                                      record.outcome.cpu_seconds, record.outcome.peak_megabytes,
                                      record.outcome.status == 0 ? "" : ", stopped: " + record.reason));
  std::fflush(stdout);
}

/// Relative residuals of the last attempt at the step.
std::vector<double> residuals_of(const Study& study, const std::string& folder) {
  const output::NumberTable table = output::read_table(folder + "/convergence.csv");
  const std::size_t step = table.column("step").value(), attempt = table.column("attempt").value(),
                    residual = table.column("relative_residual").value();
  if (table.rows.empty()) return {};
  const double wanted = study.newton_step > 0 ? study.newton_step : table.rows.back()[step];
  double last = 0;
  for (const auto& row : table.rows)
    if (row[step] == wanted) last = row[attempt];
  std::vector<double> residuals;
  for (const auto& row : table.rows)
    if (row[step] == wanted && row[attempt] == last) residuals.push_back(row[residual]);
  return residuals;
}

/// The results.h5 with which a measure of this run is compared. It is "" if the run is the finest itself or there is
/// none.
std::string reference_of(const Study& study, const Measure& measure, const std::vector<Row>& rows, const Row& row,
                         const std::string& output) {
  if (measure.reference != "finest") return measure.reference;
  const std::size_t along = first_numeric(study);
  const Row* finest = nullptr;
  for (const Row& other : rows) {
    bool same = other.status == 0 && other.values.count("particles") > 0;
    for (std::size_t s = 0; s < row.run.point.size(); ++s)
      same = same && (s == along || other.run.point[s] == row.run.point[s]);
    if (same && (finest == nullptr || other.value("particles") > finest->value("particles"))) finest = &other;
  }
  return finest == nullptr || finest == &row ? "" : output + "/runs/" + finest->run.name + "/results.h5";
}

/// Does `work`. What cannot be read or measured becomes the row's reason.
template <class Work>
void attempt(Row& row, const Work& work) {
  try {
    work();
  } catch (const RunError& error) {
    const std::string reason = error.what();
    if (row.reason.find(reason) == std::string::npos) row.reason += (row.reason.empty() ? "" : "; ") + reason;
  }
}

std::vector<Row> measure_all(const Study& study, const std::vector<Prepared>& all,
                             const std::vector<RunRecord>& records, const std::string& output) {
  std::vector<Row> rows;
  for (std::size_t k = 0; k < all.size(); ++k) {
    Row row;
    row.run = all[k].run;
    row.status = records[k].outcome.status;
    row.reason = records[k].reason;
    row.values = {{"ranks", row.run.ranks},
                  {"cpu_seconds", records[k].outcome.cpu_seconds},
                  {"wall_seconds", records[k].outcome.wall_seconds},
                  {"peak_megabytes", records[k].outcome.peak_megabytes}};
    if (records[k].bonds > 0) row.values["bonds"] = static_cast<double>(records[k].bonds);
    attempt(row, [&] {
      for (const auto& [name, value] : counts_of(all[k].folder)) row.values[name] = value;
    });
    if (study.kind == Kind::newton) {
      attempt(row, [&] { row.residuals = residuals_of(study, all[k].folder); });
      if (const auto order = newton_order(row.residuals)) row.values["newton_order"] = *order;
    }
    rows.push_back(std::move(row));
  }
  for (std::size_t k = 0; k < all.size(); ++k)
    for (const Measure& measure : study.measures) {
      if (rows[k].status != 0 && measure.needs_the_end()) continue;
      const std::string reference = reference_of(study, measure, rows, rows[k], output);
      if (measure.reference == "finest" && reference.empty()) continue;
      attempt(rows[k], [&] {
        for (const auto& [name, value] : measured(measure, all[k].run, all[k].folder, reference))
          rows[k].values[name] = value;
      });
    }
  return rows;
}
}  // namespace

int conduct(const Request& request, const deck::Schema& schema) {
  const Study study = read(request.file);
  std::vector<Prepared> all = prepare(study, request, schema);
  if (request.plan) {
    say_start(study, all, request);
    for (const Prepared& one : all) fmt::print("  {}{}\n", one.run.name, one.record ? "  finished earlier" : "");
    return 0;
  }
  const output::DirectoryLock lock(request.output + "/runs", request.file);
  if (!lock.remark().empty()) fmt::print(stderr, "warning: {}\n", lock.remark());
  if (!request.quiet) say_start(study, all, request);
  std::vector<RunRecord> records;
  for (std::size_t k = 0; k < all.size(); ++k) {
    records.push_back(all[k].record ? *all[k].record : run_one(study, all[k]));
    if (!request.quiet) say_end(k + 1, all.size(), all[k], records.back());
  }
  const std::vector<Row> rows = measure_all(study, all, records, request.output);
  write_file(request.output + "/study.csv", csv_text(study, rows));
  const std::vector<Plot> plots = plots_of(study, rows);
  for (const Plot& plot : plots) draw(plot.chart, request.output + "/" + plot.file);
  write_file(request.output + "/study.md", page(study, rows, plots));
  if (!request.quiet) fmt::print("{}\nsee {}/study.md\n", terminal_report(study, rows, plots), request.output);
  const auto short_of = std::count_if(rows.begin(), rows.end(), [](const Row& row) { return !row.reason.empty(); });
  if (short_of == 0) return 0;
  std::fflush(stdout);
  fmt::print(stderr, "warning: {} of {} runs stopped short or could not be measured; {}/study.csv says why\n", short_of,
             rows.size(), request.output);
  return 1;
}

}  // namespace perinox::study
