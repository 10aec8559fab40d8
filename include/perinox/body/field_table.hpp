#pragma once
#include <string>
#include <vector>

#include "perinox/body/body.hpp"

namespace perinox::body {

/// A displacement field given as a CSV with the header `t,x,y,z,ux,uy,uz` (t optional; 2-D: z = uz = 0), matched to
/// particles by reference position. It is linear in t between the given times and constant after the last. If the first
/// given time is later than 0, it grows linearly from zero at t = 0 to that time. Without the column t the field holds
/// at every t > 0 and does not grow.
class FieldTable {
 public:
  /// Reads the rows of the owned particles of `set`. Every one of them must be in the table at every given time.
  /// Collective. Throws InputError with the table's line.
  FieldTable(const std::string& path, const deck::Location& asked_at, const Body& body,
             const std::vector<LocalIndex>& set);

  /// Displacement of the k-th particle of the set at t. out: [dimension], length.
  void evaluate(std::size_t k, double t, double* out) const;
  const std::vector<double>& times() const { return times_; }
  /// False for a table without the column t.
  bool has_time() const { return has_time_; }

 private:
  int dimension_ = 3;
  std::vector<double> times_;
  std::vector<double> values_;  ///< [times][particles of the set][dimension]
  std::size_t count_ = 0;
  bool has_time_ = false;
};

}  // namespace perinox::body
