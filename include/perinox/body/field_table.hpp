#pragma once
#include <string>
#include <vector>

#include "perinox/body/body.hpp"

namespace perinox::body {

/// A displacement field given as a CSV with header `t,x,y,z,ux,uy,uz` (t optional; 2-D: z = uz = 0), matched to
/// particles by reference position, linear in t between the given times, constant after the last, and linear from zero
/// at t = 0 to the first given time if that is later. Without t the field holds at every t > 0 and grows nowhere.
class FieldTable {
 public:
  /// Reads the rows of the owned particles of `set`; every one of them must be in the table at every given time.
  /// Collective. Throws InputError with the table's line.
  FieldTable(const std::string& path, const deck::Location& asked_at, const Body& body,
             const std::vector<LocalIndex>& set);

  /// Displacement of the k-th particle of the set. out: [dimension]
  void evaluate(std::size_t k, double t, double* out) const;
  const std::vector<double>& times() const { return times_; }
  /// False of a table without the column t.
  bool has_time() const { return has_time_; }

 private:
  int dimension_ = 3;
  std::vector<double> times_;
  std::vector<double> values_;  ///< [times][particles of the set][dimension]
  std::size_t count_ = 0;
  bool has_time_ = false;
};

}  // namespace perinox::body
