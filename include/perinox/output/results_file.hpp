#pragma once
#include <memory>
#include <string>
#include <vector>

#include "perinox/body/body.hpp"
#include "perinox/solve/record.hpp"

namespace perinox::output {

/// `results.h5`, written by all ranks together (parallel HDF5), rows in ascending particle id whatever the number of
/// ranks, and `results.xdmf` beside it. After every step the file on disk is complete and readable.
class ResultsFile {
 public:
  ResultsFile(const std::string& directory, const std::string& title, const body::Body& body);
  ~ResultsFile();

  /// Group /steps/<record.step> with attributes t, newton_iterations, linear_iterations and one dataset a field: [n,3]
  /// for vectors (2-D: third column zero), [n] for scalars. Collective. Throws RunError if the disk refuses.
  void write(const solve::StepRecord& record, const std::vector<solve::Field>& fields);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace perinox::output
