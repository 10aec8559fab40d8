#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "perinox/core/communicator.hpp"
#include "perinox/core/types.hpp"
#include "perinox/output/checksum.hpp"
#include "stretch.hpp"

namespace perinox::output {

/// An HDF5 file that all ranks hold open together (with MPI-IO; one rank alone does without). Every member, the
/// destructor included, is collective. Any failure throws RunError on every rank, with the file's path and the reason;
/// HDF5 prints nothing itself. Datasets are tables of `total` rows, of which each rank writes or reads the rows [first,
/// first + rows).
class ParallelFile {
 public:
  enum class Mode { create, append, read };

  /// Opens the file. Mode create replaces an existing one. The first user_block bytes (0, or a power of two from 512)
  /// are left to the caller.
  ParallelFile(std::string path, const Communicator& communicator, Mode mode, int user_block = 0);
  ~ParallelFile();
  ParallelFile(const ParallelFile&) = delete;
  ParallelFile& operator=(const ParallelFile&) = delete;

  const std::string& path() const { return path_; }
  void make_group(const std::string& name);
  bool has(const std::string& name) const;
  /// Removes a group or dataset with all that is in it. The room that it took stays in the file.
  void remove(const std::string& name);

  /// Writes a dataset [total] if columns is 0, otherwise [total, columns]. values: this rank's rows, row-major.
  void write_rows(const std::string& dataset, const std::vector<double>& values, GlobalId total, GlobalId first,
                  int columns = 0);
  void write_rows(const std::string& dataset, const std::vector<int>& values, GlobalId total, GlobalId first);
  void write_rows(const std::string& dataset, const std::vector<GlobalId>& values, GlobalId total, GlobalId first);
  /// Gives a column of a dataset [total, columns] a name of its own. The view is a dataset [total] that holds no
  /// numbers: HDF5's readers see those of the column (virtual dataset).
  void make_view(const std::string& view, const std::string& dataset, GlobalId total, int columns, int column);
  /// Reads this rank's rows of a dataset of `total` rows. Throws RunError for another shape.
  std::vector<double> read_rows(const std::string& dataset, GlobalId total, GlobalId first, int rows,
                                int columns = 0) const;

  std::vector<int> read_integers(const std::string& dataset, GlobalId total, GlobalId first, int rows) const;
  /// Makes a list [total] that is written and read in portions. This rank's values begin at `first`; a rank may have
  /// none.
  void make_list(const std::string& dataset, GlobalId total);
  /// The place of this rank's `count` values in a list. It is filled without HDF5 and closed with close_list.
  Stretch list_stretch(const std::string& dataset, GlobalId first, std::size_t count);
  void close_list(Stretch& stretch);
  /// Length of a list; -1 if the dataset is no list.
  GlobalId list_size(const std::string& dataset) const;
  std::vector<double> read_part(const std::string& dataset, GlobalId first, std::size_t count) const;

  /// Sets an attribute of a group or dataset ("/" is the file itself). The value must be the same on every rank.
  void set_attribute(const std::string& object, const std::string& name, double value);
  void set_attribute(const std::string& object, const std::string& name, GlobalId value);
  void set_attribute(const std::string& object, const std::string& name, const std::string& value);
  void set_attribute(const std::string& object, const std::string& name, const std::vector<std::string>& values);
  bool has_attribute(const std::string& object, const std::string& name) const;
  GlobalId integer_attribute(const std::string& object, const std::string& name) const;
  double number_attribute(const std::string& object, const std::string& name) const;
  std::vector<std::string> texts_attribute(const std::string& object, const std::string& name) const;
  /// Reads an attribute of exactly one text.
  std::string text_attribute(const std::string& object, const std::string& name) const;

  /// The lists that were filled by stretches, in the order of the file: bytes [begin, end) of the file that need not be
  /// read for its checksum, and this rank's share of it.
  std::vector<KnownShare> filled() const;

  /// Closes the file. Everything is on disk when this returns. If it is not called the destructor closes the file and
  /// reports nothing.
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
