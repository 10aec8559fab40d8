#include "perinox/output/results_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "perinox/output/agree.hpp"
#include "perinox/output/parallel_file.hpp"
#include "perinox/output/reserve.hpp"

namespace perinox::output {

namespace {
/// [points * components] -> [points * 3], the missing component zero.
std::vector<double> three_columns(const double* values, std::size_t points, int components) {
  std::vector<double> wide(points * 3, 0.0);
  const auto width = static_cast<std::size_t>(components);
  for (std::size_t i = 0; i < points; ++i)
    for (std::size_t c = 0; c < width; ++c) wide[i * 3 + c] = values[i * width + c];
  return wide;
}

constexpr double header_room = 64 * 1024;  ///< bytes for HDF5's own bookkeeping of a step
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
  require_room(6.0 * static_cast<double>(body.total));
  const GlobalId n = order_.total();
  const GlobalId first = order_.first_row();
  ParallelFile file(path_, communicator_, ParallelFile::Mode::create);
  file.set_attribute("/", "title", title);
  file.set_attribute("/", "perinox_version", std::string(PERINOX_VERSION));
  file.set_attribute("/", "dimension", static_cast<GlobalId>(body.dimension));
  file.make_group("/particles");
  file.make_group("/steps");
  file.write_rows("/particles/id", order_.to_rows(body.id.data()), n, first);
  const auto reference = three_columns(body.reference.data(), static_cast<std::size_t>(body.owned), body.dimension);
  file.write_rows("/particles/reference", order_.to_rows(reference.data(), 3), n, first, 3);
  file.write_rows("/particles/volume", order_.to_rows(body.volume.data(), 1), n, first);
  file.write_rows("/particles/block", order_.to_rows(body.part.data()), n, first);
  file.set_attribute("/particles/block", "names", block_names);
  file.close();
}

void ResultsFile::require_room(double numbers) const {
  const double bytes = numbers * static_cast<double>(sizeof(double)) + header_room;
  agree_on_run_error(communicator_, communicator_.is_root() ? reserve(path_, bytes) : std::string());
}

void ResultsFile::write(const solve::StepRecord& record, const std::vector<solve::Field>& fields) {
  double columns = 0;
  for (const solve::Field& field : fields) columns += std::max(1, XdmfIndex::columns_of(field.components));
  require_room(columns * static_cast<double>(order_.total()));

  const std::string group = fmt::format("/steps/{}", record.step);
  std::vector<XdmfIndex::FieldShape> shapes;
  ParallelFile file(path_, communicator_, ParallelFile::Mode::append);
  file.make_group(group);
  file.set_attribute(group, "t", record.t);
  file.set_attribute(group, "load", record.t);
  file.set_attribute(group, "newton_iterations", static_cast<GlobalId>(record.newton_iterations));
  file.set_attribute(group, "linear_iterations", static_cast<GlobalId>(record.linear_iterations));
  for (const solve::Field& field : fields) {
    const int width = XdmfIndex::columns_of(field.components);
    const std::vector<double> rows = order_.to_rows(field.values, field.components);
    const std::string name = group + "/" + field.name;
    if (width == 3)
      file.write_rows(name, three_columns(rows.data(), static_cast<std::size_t>(order_.rows()), field.components),
                      order_.total(), order_.first_row(), 3);
    else
      file.write_rows(name, rows, order_.total(), order_.first_row(), width);
    shapes.push_back({field.name, width});
  }
  file.close();

  std::string sentence;
  if (communicator_.is_root()) {
    index_.add_step(record.step, steps_as_time_ ? record.step : record.t, shapes);
    sentence = replace_file(directory_ + "/results.xdmf", index_.text());
  }
  agree_on_run_error(communicator_, sentence);
}

}  // namespace perinox::output
