#include "results_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>

#include "agree.hpp"
#include "parallel_file.hpp"
#include "perinox/core/error.hpp"
#include "perinox/output/results_reader.hpp"
#include "reserve.hpp"

namespace perinox::output {

namespace {
/// For each of xx, xy, xz, yx, ..., zz its number in xx, xy, xz, yy, yz, zz.
constexpr std::array<std::size_t, 9> of_symmetric = {0, 1, 2, 1, 3, 4, 2, 4, 5};

/// The rows as the file has them: vectors [points * 3], where a component that is missing in 2-D is zero; tensors
/// [points * 9].
std::vector<double> columns_of_file(const double* values, std::size_t points, int components) {
  const auto width = static_cast<std::size_t>(components);
  const auto columns = static_cast<std::size_t>(XdmfIndex::columns_of(components));
  std::vector<double> wide(points * columns, 0.0);
  for (std::size_t i = 0; i < points; ++i)
    for (std::size_t c = 0; c < columns; ++c)
      if (components == 6)
        wide[i * columns + c] = values[i * width + of_symmetric[c]];
      else if (c < width)
        wide[i * columns + c] = values[i * width + c];
  return wide;
}

/// A component of a symmetric tensor that has a name of its own, and its column in the file. In 2-D those across the
/// plane are zero.
struct NamedColumn {
  const char* name;
  int column;
  bool in_plane;
};
constexpr NamedColumn named_columns[] = {{"xx", 0, true}, {"xy", 1, true},  {"xz", 2, false},
                                         {"yy", 4, true}, {"yz", 5, false}, {"zz", 8, true}};

std::string view_of(long long step, const std::string& field, const std::string& component) {
  return fmt::format("/components/{}/{}_{}", step, field, component);
}

constexpr double header_room = 128 * 1024;  ///< bytes for HDF5's own bookkeeping of a step

/// HDF5 rewrites its table of contents in place, in some milliseconds, and a run that is killed in them loses the file.
/// For small files, whose steps are short too, the step is added to a copy, which is then renamed. Large files are
/// spared the copy: their steps are so long that those milliseconds are hardly ever hit.
constexpr double copied_up_to = 16e6;  ///< bytes
}  // namespace

ResultsFile::ResultsFile(std::string directory, const std::string& title, const std::vector<std::string>& block_names,
                         const body::Body& body, bool steps_as_time)
    : directory_(std::move(directory)),
      path_(directory_ + "/results.h5"),
      communicator_(body.communicator),
      dimension_(body.dimension),
      order_(communicator_, body.id, body.owned, body.total),
      index_(title, "results.h5", body.total),
      steps_as_time_(steps_as_time) {
  require_room(6.0 * static_cast<double>(body.total), path_);
  const GlobalId n = order_.total();
  const GlobalId first = order_.first_row();
  ParallelFile file(path_, communicator_, ParallelFile::Mode::create);
  file.set_attribute("/", "title", title);
  file.set_attribute("/", "perinox_version", std::string(PERINOX_VERSION));
  file.set_attribute("/", "dimension", static_cast<GlobalId>(body.dimension));
  file.make_group("/particles");
  file.make_group("/steps");
  file.write_rows("/particles/id", order_.to_rows(body.id.data()), n, first);
  const auto reference = columns_of_file(body.reference.data(), static_cast<std::size_t>(body.owned), body.dimension);
  file.write_rows("/particles/reference", order_.to_rows(reference.data(), 3), n, first, 3);
  file.write_rows("/particles/volume", order_.to_rows(body.volume.data(), 1), n, first);
  file.write_rows("/particles/block", order_.to_rows(body.part.data()), n, first);
  file.set_attribute("/particles/block", "names", block_names);
  file.close();
}

ResultsFile::ResultsFile(std::string directory, const std::string& title, const std::vector<std::string>& fields,
                         const body::Body& body, Continue kept)
    : directory_(std::move(directory)),
      path_(directory_ + "/results.h5"),
      communicator_(body.communicator),
      dimension_(body.dimension),
      order_(communicator_, body.id, body.owned, body.total),
      index_(title, "results.h5", body.total) {
  Later later;
  std::string sentence;
  if (communicator_.is_root()) try {
      later = look_back(kept, fields);
    } catch (const RunError& error) {
      sentence = error.what();
    }
  agree_on_run_error(communicator_, sentence);
  later.steps = communicator_.gather(later.steps);
  later.phases = communicator_.gather(later.phases);
  if (!later.steps.empty() || !later.phases.empty()) {
    const std::string written = copy_if_small();
    ParallelFile file(written, communicator_, ParallelFile::Mode::append);
    const bool named = file.has("/components");
    for (const long long step : later.steps) {
      file.remove(fmt::format("/steps/{}", step));
      const std::string components = fmt::format("/components/{}", step);
      if (named && file.has(components)) file.remove(components);
    }
    for (const long long phase : later.phases) file.remove(fmt::format("/phases/{}", phase));
    file.close();
    rename_copy(written);
  }
  if (communicator_.is_root()) sentence = replace_file(directory_ + "/results.xdmf", index_.text());
  agree_on_run_error(communicator_, sentence);
}

ResultsFile::Later ResultsFile::look_back(Continue kept, const std::vector<std::string>& fields) {
  const ResultsReader file(path_);
  if (file.particles() != static_cast<std::size_t>(order_.total()))
    throw RunError(fmt::format("{} holds {} particles, not {}", path_, file.particles(), order_.total()));
  Later later;
  for (const ResultsReader::Phase& phase : file.phases())
    if (phase.number > kept.last_phase) later.phases.push_back(phase.number);
  for (const ResultsReader::Step& step : file.steps()) {
    if (step.number > kept.last_step) {
      later.steps.push_back(step.number);
      continue;
    }
    // The fields that are asked for come first.
    std::vector<std::string> there = fields;
    for (const std::string& field : file.fields(step.number))
      if (std::find(fields.begin(), fields.end(), field) == fields.end()) there.push_back(field);
    std::vector<XdmfIndex::FieldShape> shapes;
    for (const std::string& field : there) {
      const int columns = file.columns(step.number, field);
      if (columns == 6)
        throw RunError(fmt::format("{} has six columns of {}, as an earlier version wrote tensors", path_, field));
      if (columns <= 0) continue;
      shapes.push_back({field, columns == 1 ? 0 : columns});
      for (const NamedColumn& column : named_columns)
        if (columns == 9 && file.has(view_of(step.number, field, column.name)))
          shapes.back().named.emplace_back(column.name);
    }
    index_.add_step(step.number, step.t, shapes);
  }
  return later;
}

void ResultsFile::sync() const {
  std::string reason;
  if (communicator_.is_root()) reason = sync_to_disk(path_);
  agree_on_run_error(communicator_, reason.empty() ? reason : path_ + " could not be brought to the disk: " + reason);
}

void ResultsFile::require_room(double numbers, const std::string& path) const {
  const double bytes = numbers * static_cast<double>(sizeof(double)) + header_room;
  agree_on_run_error(communicator_, communicator_.is_root() ? reserve(path, bytes) : std::string());
}

std::string ResultsFile::copy_if_small() const {
  namespace fs = std::filesystem;
  const std::string copy = path_ + ".part";
  std::error_code error;
  bool small = false;
  if (communicator_.is_root()) {
    small = static_cast<double>(fs::file_size(path_, error)) <= copied_up_to;
    if (small && !error) fs::copy_file(path_, copy, fs::copy_options::overwrite_existing, error);
    if (error) {  // no room for two
      small = false;
      fs::remove(copy, error);
    }
  }
  return communicator_.any(small) ? copy : path_;
}

void ResultsFile::rename_copy(const std::string& written) const {
  std::error_code error;
  if (communicator_.is_root() && written != path_) std::filesystem::rename(written, path_, error);
  agree_on_run_error(communicator_, error ? path_ + " cannot be replaced: " + error.message() : std::string());
}

void ResultsFile::write(const StepRecord& record, const std::vector<Field>& fields) {
  double columns = 0;
  for (const Field& field : fields) columns += std::max(1, XdmfIndex::columns_of(field.components));
  const std::string written = copy_if_small();
  try {
    require_room(columns * static_cast<double>(order_.total()), written);
  } catch (const RunError& error) {
    std::error_code ignored;
    if (communicator_.is_root() && written != path_) std::filesystem::remove(written, ignored);
    throw RunError(path_ + std::string(error.what()).substr(written.size()));  // it begins with the name
  }

  const std::string group = fmt::format("/steps/{}", record.step);
  std::vector<XdmfIndex::FieldShape> shapes;
  ParallelFile file(written, communicator_, ParallelFile::Mode::append);
  file.make_group(group);
  file.set_attribute(group, "t", record.t);
  file.set_attribute(group, "load", record.t);
  file.set_attribute(group, "newton_iterations", static_cast<GlobalId>(record.newton_iterations));
  file.set_attribute(group, "linear_iterations", static_cast<GlobalId>(record.linear_iterations));
  for (const Field& field : fields) {
    const int width = XdmfIndex::columns_of(field.components);
    const std::vector<double> rows = order_.to_rows(field.values, field.components);
    const std::string name = group + "/" + field.name;
    if (width > 0)
      file.write_rows(name, columns_of_file(rows.data(), static_cast<std::size_t>(order_.rows()), field.components),
                      order_.total(), order_.first_row(), width);
    else
      file.write_rows(name, rows, order_.total(), order_.first_row());
    shapes.push_back({field.name, width});
    if (width == 9) shapes.back().named = name_components(file, record.step, field.name);
  }
  file.close();
  rename_copy(written);

  std::string sentence;
  if (communicator_.is_root()) {
    index_.add_step(record.step, steps_as_time_ ? record.step : record.t, shapes);
    sentence = replace_file(directory_ + "/results.xdmf", index_.text());
  }
  agree_on_run_error(communicator_, sentence);
}

std::vector<std::string> ResultsFile::name_components(ParallelFile& file, int step, const std::string& field) const {
  std::vector<std::string> names;
  if (!file.has("/components")) file.make_group("/components");
  const std::string group = fmt::format("/components/{}", step);
  if (!file.has(group)) file.make_group(group);
  for (const NamedColumn& column : named_columns) {
    if (dimension_ == 2 && !column.in_plane) continue;
    file.make_view(view_of(step, field, column.name), fmt::format("/steps/{}/{}", step, field), order_.total(), 9,
                   column.column);
    names.emplace_back(column.name);
  }
  return names;
}

void ResultsFile::write(const MotionPhase& phase) {
  const std::string written = copy_if_small();
  ParallelFile file(written, communicator_, ParallelFile::Mode::append);
  if (!file.has("/phases")) file.make_group("/phases");
  const std::string group = fmt::format("/phases/{}", phase.number);
  file.make_group(group);
  file.set_attribute(group, "step", static_cast<GlobalId>(phase.step));
  file.set_attribute(group, "t_begin", phase.t_begin);
  file.set_attribute(group, "t_end", phase.t_end);
  file.set_attribute(group, "cause", static_cast<GlobalId>(phase.cause));
  file.set_attribute(group, "reason", phase.reason);
  file.set_attribute(group, "at_rest", static_cast<GlobalId>(phase.at_rest));
  file.set_attribute(group, "time", phase.time);
  file.set_attribute(group, "time_steps", static_cast<GlobalId>(phase.time_steps));
  file.set_attribute(group, "broken_bonds", static_cast<GlobalId>(phase.broken_bonds));
  file.set_attribute(group, "external_work", phase.external_work);
  file.set_attribute(group, "released_energy", phase.released_energy);
  file.set_attribute(group, "damped_energy", phase.damped_energy);
  file.set_attribute(group, "most_kinetic_energy", phase.most_kinetic_energy);
  file.set_attribute(group, "unaccounted_energy", phase.unaccounted_energy);
  file.set_attribute(group, "unaccounted_share", phase.unaccounted_share);
  file.close();
  rename_copy(written);
}

}  // namespace perinox::output
