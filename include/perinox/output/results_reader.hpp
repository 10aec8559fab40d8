#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace perinox::output {

/// Reads results.h5 in one process, without MPI. Rows are in the order of the particles' ids. Any failure throws
/// RunError with the file's path and the reason.
class ResultsReader {
 public:
  struct Step {
    int number;
    double t;
  };

  struct Phase {
    int number;  ///< group /phases/<number>
    int step;
    double t_begin, t_end, time;
  };

  explicit ResultsReader(std::string path);
  ~ResultsReader();
  ResultsReader(const ResultsReader&) = delete;
  ResultsReader& operator=(const ResultsReader&) = delete;

  std::size_t particles() const { return particles_; }
  /// Number of unknowns of a particle: 3 or 2.
  int dimension() const;
  /// Positions before loading. [particles * 3], length
  std::vector<double> reference() const { return read("/particles/reference", 3); }
  /// Volumes. [particles], length^dimension
  std::vector<double> volume() const { return read("/particles/volume", 1); }
  /// Steps in the order of their numbers.
  std::vector<Step> steps() const;
  /// Phases in time of a run that lost its equilibrium, in the order of their numbers.
  std::vector<Phase> phases() const;
  /// True if the file holds a group or dataset of this name.
  bool has(const std::string& object) const;
  /// Names of the fields of a step.
  std::vector<std::string> fields(int step) const;
  /// Number of columns of a field: 3 for a vector, 1 for a scalar, 0 if the step holds no such field.
  int columns(int step, const std::string& field) const;
  /// Values of a field. [particles * columns]
  std::vector<double> field(int step, const std::string& field) const;

 private:
  std::vector<std::string> names_in(const std::string& group) const;
  std::vector<double> read(const std::string& dataset, int columns) const;
  double number_attribute(const std::string& object, const std::string& name) const;

  std::string path_;
  std::int64_t file_ = -1;  ///< HDF5's hid_t, kept out of this header
  std::size_t particles_ = 0;
};

}  // namespace perinox::output
