#include "perinox/output/tables.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <utility>

#include "perinox/output/table_reader.hpp"

namespace perinox::output {

GrowingFile::GrowingFile(std::string path, const std::string& header, long long kept)
    : path_(std::move(path)), file_(std::fopen(path_.c_str(), kept > 0 ? "r+" : "w")) {
  if (file_ == nullptr) {
    failure_ = fmt::format("{} cannot be {}: {}", path_, kept > 0 ? "gone on with" : "created", std::strerror(errno));
  } else if (kept == 0) {
    if (!header.empty()) append(header);
  } else if (::ftruncate(::fileno(file_), kept) != 0 || std::fseek(file_, 0, SEEK_END) != 0) {
    failure_ = fmt::format("{} cannot be gone on with: {}", path_, std::strerror(errno));
  }
}

GrowingFile::~GrowingFile() {
  if (file_ != nullptr) std::fclose(file_);
}

void GrowingFile::append(const std::string& line) {
  if (!failure_.empty()) return;
  const bool written = std::fputs((line + "\n").c_str(), file_) >= 0 && std::fflush(file_) == 0;
  if (!written) failure_ = fmt::format("{} could not be written: {}", path_, std::strerror(errno));
}

long long GrowingFile::sync() {
  if (!failure_.empty()) return 0;
  if (::fsync(::fileno(file_)) != 0 && errno != EINVAL && errno != ENOTSUP)
    failure_ = fmt::format("{} could not be brought to the disk: {}", path_, std::strerror(errno));
  return std::ftell(file_);
}

bool GrowingFile::continuable(const std::string& path, const std::string& header, long long kept) {
  std::ifstream file(path, std::ios::binary);
  std::string line;
  if (kept <= 0 || !std::getline(file, line) || line != header) return false;
  file.seekg(kept - 1);
  return file.get() == '\n';
}

namespace {
/// The sections in the order of their columns, which is not that of the enumeration.
constexpr Section columns[] = {Section::product, Section::preconditioner, Section::halo,     Section::assembly,
                               Section::output,  Section::force,          Section::linearise};
static_assert(std::size(columns) == section_count);

std::string seconds_columns() {
  std::string header;
  for (const Section section : columns) header += fmt::format(",seconds_{}", name_of(section));
  return header;
}
}  // namespace

HistoryTable::Columns HistoryTable::Columns::of(const deck::Deck& deck) {
  return {deck.breaks(), deck.may_move(), deck.may_move() && deck.dynamics != deck::Dynamics::explicit_,
          deck.may_overlap()};
}

std::vector<std::string> history_names(const deck::Deck& deck) {
  std::vector<std::string> names;
  for (const deck::HistoryEntry& entry : deck.history) names.push_back(entry.name);
  return names;
}

std::vector<std::string> history_columns(const deck::Deck& deck) {
  return csv_cells(HistoryTable::header(history_names(deck), HistoryTable::Columns::of(deck)));
}

HistoryTable::HistoryTable(const std::string& path, const std::vector<std::string>& names, Columns columns,
                           long long kept)
    : file_(path, header(names, columns), kept), columns_(columns) {}

std::string HistoryTable::header(const std::vector<std::string>& names, Columns columns) {
  std::string header = "step,t";
  for (const std::string& name : names) header += "," + csv_cell(name);
  return header +
         ",stored_energy,dissipated_energy,external_work,newton_iterations,linear_iterations,seconds,products" +
         seconds_columns() +
         (columns.fracture ? ",passes,broken_bonds,released_energy,relaxed_energy,fragments,single_particles" : "") +
         (columns.motion ? ",time,time_steps,kinetic_energy,damped_energy,contact_energy" : "") +
         (columns.phases ? ",phases,cause,phase_time,phase_energy" : "") + (columns.overlap ? ",overlap" : "");
}

void HistoryTable::row(const StepRecord& record) {
  std::string line = fmt::format("{},{:.17g}", record.step, record.t);
  for (const double value : record.history) line += fmt::format(",{:.17g}", value);
  line += fmt::format(",{:.17g},{:.17g},{:.17g},{},{},{:.17g},{}", record.stored_energy, record.dissipated_energy,
                      record.external_work, record.newton_iterations, record.linear_iterations, record.seconds,
                      record.profile.count_of(Section::product));
  for (const Section section : columns) line += fmt::format(",{:.6g}", record.profile.seconds_of(section));
  if (columns_.fracture) {
    const FractureRow row = record.fracture.value_or(FractureRow());
    line += fmt::format(",{},{},{:.17g},{:.17g},{},{}", row.passes, row.broken_bonds, row.released_energy,
                        row.relaxed_energy, row.fragments, row.single_particles);
  }
  if (columns_.motion) {
    const MotionRow row = record.motion.value_or(MotionRow());
    line += fmt::format(",{:.17g},{},{:.17g},{:.17g},{:.17g}", row.time, row.time_steps, row.kinetic_energy,
                        row.damped_energy, row.contact_energy);
    if (columns_.phases)
      line += fmt::format(",{},{},{:.17g},{:.17g}", row.phases, static_cast<int>(row.cause), row.phase_time,
                          row.phase_energy);
  }
  if (columns_.overlap) line += fmt::format(",{:.17g}", record.overlap.value_or(0));
  file_.append(line);
}

ConvergenceTable::ConvergenceTable(const std::string& path, long long kept) : file_(path, header(), kept) {}

std::string ConvergenceTable::header() {
  return "step,t,attempt,iteration,residual,relative_residual,update,relative_update,linear_iterations,forcing,"
         "step_length";
}

void ConvergenceTable::row(const NewtonIteration& row, int attempt) {
  file_.append(fmt::format("{},{:.17g},{},{},{:.17g},{:.17g},{:.17g},{:.17g},{},{:.17g},{:.17g}", row.step, row.t,
                           attempt, row.iteration, row.residual, row.relative_residual, row.update, row.relative_update,
                           row.linear_iterations, row.forcing, row.step_length));
}

}  // namespace perinox::output
