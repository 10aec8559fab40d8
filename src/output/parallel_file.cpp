#include "parallel_file.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "agree.hpp"
#include "hdf5_handle.hpp"

namespace perinox::output {

namespace {
/// Selects the rows [first, first + rows) of a table in its file dataspace.
void select_rows(hid_t space, GlobalId first, int rows, int columns) {
  const std::array<hsize_t, 2> start = {static_cast<hsize_t>(first), 0};
  const std::array<hsize_t, 2> count = {static_cast<hsize_t>(rows), static_cast<hsize_t>(columns)};
  if (rows == 0)
    H5Sselect_none(space);
  else
    H5Sselect_hyperslab(space, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr);
}

std::array<hsize_t, 2> shape(GlobalId rows, int columns) {
  return {static_cast<hsize_t>(rows), static_cast<hsize_t>(columns)};
}

Handle memory_space(int rows, int columns) {
  const auto extent = shape(rows, columns);
  return {H5Screate_simple(columns == 0 ? 1 : 2, extent.data(), nullptr), H5Sclose};
}

Handle collective_transfer(const Communicator& communicator) {
  const hid_t list = H5Pcreate(H5P_DATASET_XFER);
  if (communicator.size() > 1) H5Pset_dxpl_mpio(list, H5FD_MPIO_COLLECTIVE);
  return {list, H5Pclose};
}

/// Large datasets begin at a multiple of a block, so that their words of 8 bytes are words of the file. HDF5 demands no
/// more than the user block has.
constexpr hsize_t large = 4096, block = 512;

/// One rank needs no MPI-IO: opening a file with it costs more than a small checkpoint's content. Files are not locked,
/// just as MPI-IO does not lock them: a viewer may have results open that a run goes on writing.
Handle access_for(const Communicator& communicator, ParallelFile::Mode mode) {
  const hid_t list = H5Pcreate(H5P_FILE_ACCESS);
  if (communicator.size() > 1)
    H5Pset_fapl_mpio(list, communicator.mpi(), MPI_INFO_NULL);
  else
    H5Pset_file_locking(list, 0, 1);
  if (mode == ParallelFile::Mode::create) H5Pset_alignment(list, large, block);
  return {list, H5Pclose};
}

/// True if an attribute holds one value. H5Aread fills as much as the file says there is, whatever room there is for
/// it.
bool holds_one(const Handle& attribute) {
  if (attribute.failed()) return false;
  const Handle space(H5Aget_space(attribute), H5Sclose);
  return H5Sget_simple_extent_npoints(space) == 1;
}

/// HDF5's type of a text: UTF-8 of any length, ended by a zero.
Handle text_type() {
  const hid_t type = H5Tcopy(H5T_C_S1);
  H5Tset_size(type, H5T_VARIABLE);
  H5Tset_cset(type, H5T_CSET_UTF8);
  return {type, H5Tclose};
}
}  // namespace

ParallelFile::ParallelFile(std::string path, const Communicator& communicator, Mode mode, int user_block)
    : path_(std::move(path)), communicator_(communicator), user_block_(user_block) {
  const Silence silence;
  const Handle access = access_for(communicator_, mode);  // closed last: every call clears the reason of a failure
  const Handle creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
  H5Pset_userblock(creation, static_cast<hsize_t>(user_block));
  file_ = mode == Mode::create ? H5Fcreate(path_.c_str(), H5F_ACC_TRUNC, creation, access)
                               : H5Fopen(path_.c_str(), mode == Mode::append ? H5F_ACC_RDWR : H5F_ACC_RDONLY, access);
  try {
    agree(file_ < 0, mode == Mode::create ? "cannot be created" : "cannot be opened");
  } catch (...) {
    if (file_ >= 0) H5Fclose(file_);
    throw;
  }
}

ParallelFile::~ParallelFile() {
  const Silence silence;
  if (file_ >= 0) H5Fclose(file_);
}

void ParallelFile::agree(bool failed, const std::string& doing) const {
  agree_on_run_error(communicator_, failed ? path_ + " " + doing + ": " + take_reason() : std::string());
}

void ParallelFile::make_group(const std::string& name) {
  const Silence silence;
  const Handle group(H5Gcreate2(file_, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
  agree(group.failed(), "refuses the group " + name);
}

bool ParallelFile::has(const std::string& name) const {
  const Silence silence;
  return communicator_.any(H5Lexists(file_, name.c_str(), H5P_DEFAULT) > 0);
}

void ParallelFile::remove(const std::string& name) {
  const Silence silence;
  agree(H5Ldelete(file_, name.c_str(), H5P_DEFAULT) < 0, "does not give up " + name);
}

void ParallelFile::write_table(const std::string& dataset, const void* values, int rows, GlobalId total, GlobalId first,
                               int columns, std::int64_t type) {
  const Silence silence;
  const auto extent = shape(total, columns);
  const Handle space(H5Screate_simple(columns == 0 ? 1 : 2, extent.data(), nullptr), H5Sclose);
  const Handle table(H5Dcreate2(file_, dataset.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Dclose);
  agree(table.failed(), "refuses the dataset " + dataset);
  select_rows(space, first, rows, columns);
  const Handle memory = memory_space(rows, columns);
  const Handle transfer = collective_transfer(communicator_);
  agree(H5Dwrite(table, type, memory, space, transfer, values) < 0, "could not be written, dataset " + dataset);
}

void ParallelFile::write_rows(const std::string& dataset, const std::vector<double>& values, GlobalId total,
                              GlobalId first, int columns) {
  const auto rows = static_cast<int>(columns == 0 ? values.size() : values.size() / static_cast<std::size_t>(columns));
  write_table(dataset, values.data(), rows, total, first, columns, H5T_NATIVE_DOUBLE);
}
void ParallelFile::write_rows(const std::string& dataset, const std::vector<int>& values, GlobalId total,
                              GlobalId first) {
  write_table(dataset, values.data(), static_cast<int>(values.size()), total, first, 0, H5T_NATIVE_INT);
}
void ParallelFile::write_rows(const std::string& dataset, const std::vector<GlobalId>& values, GlobalId total,
                              GlobalId first) {
  write_table(dataset, values.data(), static_cast<int>(values.size()), total, first, 0, H5T_NATIVE_LLONG);
}

void ParallelFile::make_view(const std::string& view, const std::string& dataset, GlobalId total, int columns,
                             int column) {
  const Silence silence;
  const auto extent = shape(total, columns);
  const Handle all(H5Screate_simple(2, extent.data(), nullptr), H5Sclose);
  const std::array<hsize_t, 2> start = {0, static_cast<hsize_t>(column)}, count = {static_cast<hsize_t>(total), 1};
  H5Sselect_hyperslab(all, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr);
  const Handle space(H5Screate_simple(1, count.data(), nullptr), H5Sclose);
  const Handle mapped(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_virtual(mapped, space, ".", dataset.c_str(), all);  // ".": in the same file, whatever its name is
  const Handle table(H5Dcreate2(file_, view.c_str(), H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, mapped, H5P_DEFAULT),
                     H5Dclose);
  agree(table.failed(), "refuses the dataset " + view);
}

void ParallelFile::read_table(const std::string& dataset, void* values, int rows, GlobalId total, GlobalId first,
                              int columns, std::int64_t type) const {
  const Silence silence;
  const Handle table(H5Dopen2(file_, dataset.c_str(), H5P_DEFAULT), H5Dclose);
  agree(table.failed(), "has no dataset " + dataset);
  const Handle space(H5Dget_space(table), H5Sclose);
  std::array<hsize_t, 2> extent = {0, 0};
  const bool flat_or_table = H5Sget_simple_extent_ndims(space) == (columns == 0 ? 1 : 2);
  if (flat_or_table) H5Sget_simple_extent_dims(space, extent.data(), nullptr);
  agree_on_run_error(communicator_, flat_or_table && extent == shape(total, columns)
                                        ? std::string()
                                        : path_ + " holds the dataset " + dataset + " in another shape than [" +
                                              std::to_string(total) +
                                              (columns == 0 ? "]" : ", " + std::to_string(columns) + "]"));
  select_rows(space, first, rows, columns);
  const Handle memory = memory_space(rows, columns);
  const Handle transfer = collective_transfer(communicator_);
  agree(H5Dread(table, type, memory, space, transfer, values) < 0, "could not be read, dataset " + dataset);
}

std::vector<double> ParallelFile::read_rows(const std::string& dataset, GlobalId total, GlobalId first, int rows,
                                            int columns) const {
  std::vector<double> values(static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns == 0 ? 1 : columns));
  read_table(dataset, values.data(), rows, total, first, columns, H5T_NATIVE_DOUBLE);
  return values;
}
std::vector<int> ParallelFile::read_integers(const std::string& dataset, GlobalId total, GlobalId first,
                                             int rows) const {
  std::vector<int> values(static_cast<std::size_t>(rows));
  read_table(dataset, values.data(), rows, total, first, 0, H5T_NATIVE_INT);
  return values;
}

void ParallelFile::make_list(const std::string& dataset, GlobalId total) {
  const Silence silence;
  const auto extent = static_cast<hsize_t>(total);
  const Handle space(H5Screate_simple(1, &extent, nullptr), H5Sclose);
  const Handle at_once(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_alloc_time(at_once, H5D_ALLOC_TIME_EARLY);
  H5Pset_fill_time(at_once, H5D_FILL_TIME_NEVER);
  const Handle list(H5Dcreate2(file_, dataset.c_str(), H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, at_once, H5P_DEFAULT),
                    H5Dclose);
  agree(list.failed(), "refuses the dataset " + dataset);
}

Stretch ParallelFile::list_stretch(const std::string& dataset, GlobalId first, std::size_t count) {
  const Silence silence;
  const Handle list(H5Dopen2(file_, dataset.c_str(), H5P_DEFAULT), H5Dclose);
  const haddr_t place = list.failed() ? HADDR_UNDEF : H5Dget_offset(list);
  agree(place == HADDR_UNDEF, "has no place for the dataset " + dataset);
  const std::uint64_t behind_block = place - static_cast<std::uint64_t>(user_block_);
  const auto size = static_cast<std::uint64_t>(H5Dget_storage_size(list));
  filled_.push_back({place, place + size, 0});
  const std::uint64_t before = static_cast<std::uint64_t>(first) * sizeof(double);
  return {path_, place + before, count * sizeof(double), (behind_block + before) / sizeof(double)};
}

void ParallelFile::close_list(Stretch& stretch) {
  agree_on_run_error(communicator_, stretch.finish());
  KnownShare& last = filled_.back();
  last.checksum = stretch.checksum();
  if ((last.begin - static_cast<std::uint64_t>(user_block_)) % sizeof(double) != 0) filled_.pop_back();
}

std::vector<KnownShare> ParallelFile::filled() const {
  std::vector<KnownShare> ordered = filled_;
  std::sort(ordered.begin(), ordered.end(), [](const auto& a, const auto& b) { return a.begin < b.begin; });
  return ordered;
}

GlobalId ParallelFile::list_size(const std::string& dataset) const {
  const Silence silence;
  const Handle list(H5Dopen2(file_, dataset.c_str(), H5P_DEFAULT), H5Dclose);
  agree(list.failed(), "has no dataset " + dataset);
  const Handle space(H5Dget_space(list), H5Sclose);
  return H5Sget_simple_extent_ndims(space) == 1 ? H5Sget_simple_extent_npoints(space) : -1;
}

std::vector<double> ParallelFile::read_part(const std::string& dataset, GlobalId first, std::size_t count) const {
  const Silence silence;
  std::vector<double> values(count);
  const Handle list(H5Dopen2(file_, dataset.c_str(), H5P_DEFAULT), H5Dclose);
  bool failed = list.failed();
  if (!failed && count > 0) {
    const Handle space(H5Dget_space(list), H5Sclose);
    select_rows(space, first, static_cast<int>(count), 0);
    const Handle memory = memory_space(static_cast<int>(count), 0);
    failed = H5Dread(list, H5T_NATIVE_DOUBLE, memory, space, H5P_DEFAULT, values.data()) < 0;
  }
  agree(failed, "could not be read, dataset " + dataset);
  return values;
}

void ParallelFile::write_attribute(const std::string& object, const std::string& name, std::int64_t type,
                                   const void* value, const std::size_t* count) {
  const Silence silence;
  const hsize_t extent = count == nullptr ? 0 : *count;
  const Handle space(count == nullptr ? H5Screate(H5S_SCALAR) : H5Screate_simple(1, &extent, nullptr), H5Sclose);
  const Handle owner(H5Oopen(file_, object.c_str(), H5P_DEFAULT), H5Oclose);
  const Handle attribute(H5Acreate2(owner, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  const bool failed = attribute.failed() || H5Awrite(attribute, type, value) < 0;
  agree(failed, "refuses the attribute " + name + " of " + object);
}

void ParallelFile::set_attribute(const std::string& object, const std::string& name, double value) {
  write_attribute(object, name, H5T_NATIVE_DOUBLE, &value, nullptr);
}
void ParallelFile::set_attribute(const std::string& object, const std::string& name, GlobalId value) {
  write_attribute(object, name, H5T_NATIVE_LLONG, &value, nullptr);
}
void ParallelFile::set_attribute(const std::string& object, const std::string& name, const std::string& value) {
  const char* text = value.c_str();
  write_attribute(object, name, text_type(), &text, nullptr);
}
void ParallelFile::set_attribute(const std::string& object, const std::string& name,
                                 const std::vector<std::string>& values) {
  std::vector<const char*> texts;
  texts.reserve(values.size());
  for (const std::string& value : values) texts.push_back(value.c_str());
  const std::size_t count = texts.size();
  write_attribute(object, name, text_type(), texts.data(), &count);
}

void ParallelFile::read_attribute(const std::string& object, const std::string& name, std::int64_t type,
                                  void* value) const {
  const Silence silence;
  const Handle attribute(H5Aopen_by_name(file_, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  agree(!holds_one(attribute) || H5Aread(attribute, type, value) < 0, "has no number " + name + " at " + object);
}

bool ParallelFile::has_attribute(const std::string& object, const std::string& name) const {
  const Silence silence;
  return has(object) && communicator_.any(H5Aexists_by_name(file_, object.c_str(), name.c_str(), H5P_DEFAULT) > 0);
}

GlobalId ParallelFile::integer_attribute(const std::string& object, const std::string& name) const {
  GlobalId value = 0;
  read_attribute(object, name, H5T_NATIVE_LLONG, &value);
  return value;
}

double ParallelFile::number_attribute(const std::string& object, const std::string& name) const {
  double value = 0;
  read_attribute(object, name, H5T_NATIVE_DOUBLE, &value);
  return value;
}

std::vector<std::string> ParallelFile::texts_attribute(const std::string& object, const std::string& name) const {
  const Silence silence;
  const Handle attribute(H5Aopen_by_name(file_, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  agree(attribute.failed(), "has no text " + name + " at " + object);
  const Handle space(H5Aget_space(attribute), H5Sclose);
  std::vector<char*> read(static_cast<std::size_t>(std::max<hssize_t>(H5Sget_simple_extent_npoints(space), 0)),
                          nullptr);
  const bool failed = !read.empty() && H5Aread(attribute, text_type(), read.data()) < 0;
  std::vector<std::string> texts;
  for (char* const text : read) {
    texts.emplace_back(text == nullptr ? "" : text);
    H5free_memory(text);
  }
  agree(failed, "has no text " + name + " at " + object);
  return texts;
}

std::string ParallelFile::text_attribute(const std::string& object, const std::string& name) const {
  const std::vector<std::string> texts = texts_attribute(object, name);
  agree_on_run_error(communicator_, texts.size() == 1 ? std::string()
                                                      : path_ + " has no text " + name + " at " + object + ": it has " +
                                                            std::to_string(texts.size()) + " in place of one");
  return texts.front();
}

void ParallelFile::close() {
  const Silence silence;
  const herr_t closed = H5Fclose(file_);
  file_ = -1;
  agree(closed < 0, "could not be closed");
}

}  // namespace perinox::output
