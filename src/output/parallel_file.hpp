#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "perinox/core/communicator.hpp"
#include "perinox/core/types.hpp"
#include "perinox/output/checksum.hpp"
#include "stretch.hpp"

namespace perinox::output {

/// An HDF5 file that all ranks hold open together (MPI-IO; one rank alone does without). Every member, the
/// destructor included, is collective. Whatever fails throws RunError on every rank, with the file's path and the
/// reason; HDF5 prints nothing itself. Datasets are tables of `total` rows, of which each rank writes or reads the rows
/// [first, first + rows).
class ParallelFile {
 public:
  enum class Mode { create, append, read };

  /// Mode create replaces an existing file; user_block bytes at its beginning (0, or a power of two from 512) are left
  /// to the caller.
  ParallelFile(std::string path, const Communicator& communicator, Mode mode, int user_block = 0);
  ~ParallelFile();
  ParallelFile(const ParallelFile&) = delete;
  ParallelFile& operator=(const ParallelFile&) = delete;

  const std::string& path() const { return path_; }
  void make_group(const std::string& name);
  bool has(const std::string& name) const;
  /// A group or dataset with all that is in it; the room it took stays in the file.
  void remove(const std::string& name);

  /// columns 0: dataset [total]; otherwise [total, columns]. values: this rank's rows, row-major.
  void write_rows(const std::string& dataset, const std::vector<double>& values, GlobalId total, GlobalId first,
                  int columns = 0);
  void write_rows(const std::string& dataset, const std::vector<int>& values, GlobalId total, GlobalId first);
  void write_rows(const std::string& dataset, const std::vector<GlobalId>& values, GlobalId total, GlobalId first);
  /// A column of a dataset [total, columns] under a name of its own, as a dataset [total] that holds no numbers: HDF5's
  /// readers see those of the column (virtual dataset).
  void make_view(const std::string& view, const std::string& dataset, GlobalId total, int columns, int column);
  /// This rank's rows of a dataset of `total` rows; another shape is a RunError.
  std::vector<double> read_rows(const std::string& dataset, GlobalId total, GlobalId first, int rows,
                                int columns = 0) const;

  std::vector<int> read_integers(const std::string& dataset, GlobalId total, GlobalId first, int rows) const;
  /// A list [total] that is written and read in portions: this rank's values begin at `first`; a rank may have none.
  void make_list(const std::string& dataset, GlobalId total);
  /// The place of this rank's `count` values in a list, to be filled without HDF5 and closed with close_list.
  Stretch list_stretch(const std::string& dataset, GlobalId first, std::size_t count);
  void close_list(Stretch& stretch);
  /// Its length; -1 if the dataset is no list.
  GlobalId list_size(const std::string& dataset) const;
  std::vector<double> read_part(const std::string& dataset, GlobalId first, std::size_t count) const;

  /// Attribute of a group or dataset ("/" is the file itself). The same value on every rank.
  void set_attribute(const std::string& object, const std::string& name, double value);
  void set_attribute(const std::string& object, const std::string& name, GlobalId value);
  void set_attribute(const std::string& object, const std::string& name, const std::string& value);
  void set_attribute(const std::string& object, const std::string& name, const std::vector<std::string>& values);
  bool has_attribute(const std::string& object, const std::string& name) const;
  GlobalId integer_attribute(const std::string& object, const std::string& name) const;
  double number_attribute(const std::string& object, const std::string& name) const;
  std::vector<std::string> texts_attribute(const std::string& object, const std::string& name) const;
  /// Of exactly one text.
  std::string text_attribute(const std::string& object, const std::string& name) const;

  /// Lists that were filled by stretches: bytes [begin, end) of the file that need not be read for its checksum, and
  /// this rank's share of that. In the order of the file.
  std::vector<KnownShare> filled() const;

  /// Everything is on disk and the file is closed when this returns. Without it the destructor closes, silently.
  void close();

 private:
  void write_table(const std::string& dataset, const void* values, int rows, GlobalId total, GlobalId first,
                   int columns, std::int64_t type);
  void write_attribute(const std::string& object, const std::string& name, std::int64_t type, const void* value,
                       const std::size_t* count);
  void read_table(const std::string& dataset, void* values, int rows, GlobalId total, GlobalId first, int columns,
                  std::int64_t type) const;
  void read_attribute(const std::string& object, const std::string& name, std::int64_t type, void* value) const;
  void agree(bool failed, const std::string& doing) const;

  std::string path_;
  Communicator communicator_;
  std::int64_t file_ = -1;  ///< HDF5's hid_t, kept out of this header
  int user_block_;
  std::vector<KnownShare> filled_;
};

}  // namespace perinox::output
