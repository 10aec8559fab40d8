#pragma once
#include <string>
#include <vector>

#include "perinox/core/types.hpp"

namespace perinox::output {

/// Writes `results.xdmf`, an XDMF 3 table of contents of results.h5 for ParaView and VisIt, with one point cloud a
/// step. It holds no numbers, only the names of datasets in the file beside it.
class XdmfIndex {
 public:
  struct FieldShape {
    std::string name;
    int columns = 0;  ///< 0: [n]; 3: vectors [n, 3]; 9: tensors, row by row, [n, 9]
    /// The components of a tensor that are also datasets /components/<step>/<name>_<component>. Readers number nine
    /// columns and do not name them.
    std::vector<std::string> named{};
  };
  /// Columns of a field with so many components. 2-D vectors are written with three columns and symmetric tensors with
  /// all nine, because readers do not agree on the order of six (docs/results.md).
  static int columns_of(int components) { return components == 1 ? 0 : components == 6 ? 9 : 3; }

  /// h5_name: name of the HDF5 file, relative to the index. particles: rows of every dataset.
  XdmfIndex(std::string title, std::string h5_name, GlobalId particles);
  void add_step(int step, double t, const std::vector<FieldShape>& fields);
  /// The whole index as XML.
  std::string text() const;

 private:
  std::string title_;
  std::string h5_name_;
  GlobalId particles_;
  std::string steps_;
};

/// Replaces a small file so that a reader sees the old text or the new one, never a part: a temporary file beside it is
/// renamed over it. One rank calls it. Returns the reason as a sentence if the disk refuses, otherwise "".
std::string replace_file(const std::string& path, const std::string& text);

}  // namespace perinox::output
