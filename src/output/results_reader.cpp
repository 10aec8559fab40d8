#include "perinox/output/results_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "hdf5_handle.hpp"
#include "perinox/core/error.hpp"

namespace perinox::output {

namespace {
[[noreturn]] void fail(const std::string& path, const std::string& doing) {
  throw RunError(path + " " + doing + ": " + take_reason());
}

/// Number of rows and columns of a dataset. A list has no columns.
std::array<hsize_t, 2> extent_of(hid_t table) {
  const Handle space(H5Dget_space(table), H5Sclose);
  std::array<hsize_t, 2> extent = {0, 0};
  if (H5Sget_simple_extent_ndims(space) <= 2) H5Sget_simple_extent_dims(space, extent.data(), nullptr);
  return extent;
}
}  // namespace

ResultsReader::ResultsReader(std::string path) : path_(std::move(path)) {
  const Silence silence;
  file_ = H5Fopen(path_.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  if (file_ < 0) fail(path_, "cannot be opened");
  const Handle table(H5Dopen2(file_, "/particles/volume", H5P_DEFAULT), H5Dclose);
  if (table.failed()) {
    H5Fclose(file_);
    fail(path_, "holds no particles");
  }
  particles_ = static_cast<std::size_t>(extent_of(table)[0]);
}

ResultsReader::~ResultsReader() {
  const Silence silence;
  H5Fclose(file_);
}

int ResultsReader::dimension() const { return static_cast<int>(number_attribute("/", "dimension")); }

std::vector<std::string> ResultsReader::names_in(const std::string& where) const {
  const Silence silence;
  const Handle group(H5Gopen2(file_, where.c_str(), H5P_DEFAULT), H5Gclose);
  H5G_info_t info{};
  if (group.failed() || H5Gget_info(group, &info) < 0) fail(path_, "holds no " + where);
  std::vector<std::string> names;
  for (hsize_t k = 0; k < info.nlinks; ++k) {
    std::array<char, 64> name{};
    H5Lget_name_by_idx(group, ".", H5_INDEX_NAME, H5_ITER_INC, k, name.data(), name.size(), H5P_DEFAULT);
    names.emplace_back(name.data());
  }
  return names;
}

// Every link of the way must exist before HDF5 may be asked for the next.
bool ResultsReader::has(const std::string& object) const {
  const Silence silence;
  for (std::size_t end = object.find('/', 1);; end = object.find('/', end + 1)) {
    if (H5Lexists(file_, object.substr(0, end).c_str(), H5P_DEFAULT) <= 0) return false;
    if (end == std::string::npos) return true;
  }
}

std::vector<std::string> ResultsReader::fields(int step) const { return names_in(fmt::format("/steps/{}", step)); }

std::vector<ResultsReader::Step> ResultsReader::steps() const {
  std::vector<Step> steps;
  for (const std::string& name : names_in("/steps")) {
    const int number = std::atoi(name.c_str());
    steps.push_back({number, number_attribute(fmt::format("/steps/{}", number), "t")});
  }
  std::sort(steps.begin(), steps.end(), [](const Step& a, const Step& b) { return a.number < b.number; });
  return steps;
}

std::vector<ResultsReader::Phase> ResultsReader::phases() const {
  std::vector<Phase> phases;
  {
    const Silence silence;
    if (H5Lexists(file_, "/phases", H5P_DEFAULT) <= 0) return phases;
  }
  for (const std::string& name : names_in("/phases")) {
    const std::string group = "/phases/" + name;
    phases.push_back({std::atoi(name.c_str()), static_cast<int>(number_attribute(group, "step")),
                      number_attribute(group, "t_begin"), number_attribute(group, "t_end"),
                      number_attribute(group, "time")});
  }
  std::sort(phases.begin(), phases.end(), [](const Phase& a, const Phase& b) { return a.number < b.number; });
  return phases;
}

int ResultsReader::columns(int step, const std::string& field) const {
  const Silence silence;
  const std::string name = fmt::format("/steps/{}/{}", step, field);
  if (H5Lexists(file_, name.c_str(), H5P_DEFAULT) <= 0) return 0;
  const Handle table(H5Dopen2(file_, name.c_str(), H5P_DEFAULT), H5Dclose);
  return std::max(1, static_cast<int>(extent_of(table)[1]));
}

std::vector<double> ResultsReader::field(int step, const std::string& field) const {
  return read(fmt::format("/steps/{}/{}", step, field), columns(step, field));
}

std::vector<double> ResultsReader::read(const std::string& dataset, int columns) const {
  const Silence silence;
  const Handle table(H5Dopen2(file_, dataset.c_str(), H5P_DEFAULT), H5Dclose);
  if (table.failed()) fail(path_, "has no dataset " + dataset);
  const std::array<hsize_t, 2> extent = extent_of(table);
  if (extent[0] != particles_ || std::max<hsize_t>(1, extent[1]) != static_cast<hsize_t>(columns))
    throw RunError(fmt::format("{} holds the dataset {} in another shape than {} rows of {}", path_, dataset,
                               particles_, columns));
  std::vector<double> values(particles_ * static_cast<std::size_t>(columns));
  if (H5Dread(table, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0)
    fail(path_, "could not be read, dataset " + dataset);
  return values;
}

double ResultsReader::number_attribute(const std::string& object, const std::string& name) const {
  const Silence silence;
  double value = 0;
  const Handle attribute(H5Aopen_by_name(file_, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  if (attribute.failed() || H5Aread(attribute, H5T_NATIVE_DOUBLE, &value) < 0)
    fail(path_, "has no attribute " + name + " of " + object);
  return value;
}

}  // namespace perinox::output
