#pragma once
#include <mpi.h>

#include <string>
#include <vector>

namespace perinox {

/// The ranks that work on one scene: a thin, copyable view of an MPI communicator (not owned).
/// Every member below except rank() and size() is collective.
class Communicator {
 public:
  explicit Communicator(MPI_Comm comm = MPI_COMM_WORLD);

  MPI_Comm mpi() const { return comm_; }
  int rank() const { return rank_; }
  int size() const { return size_; }
  bool is_root() const { return rank_ == 0; }

  double sum(double value) const;
  long long sum(long long value) const;
  double max(double value) const;
  long long max(long long value) const;
  double min(double value) const;
  bool any(bool value) const;
  /// Sum of `value` over the ranks before this one (0 on rank 0).
  long long exclusive_scan(long long value) const;
  /// Element-wise sums in place. [values]
  void sum(std::vector<double>& values) const;
  /// One entry of every rank, on every rank, in rank order.
  std::vector<double> gather(double value) const;
  std::vector<long long> gather(long long value) const;
  /// The lists of all ranks one after the other, in rank order, on every rank.
  std::vector<double> gather(const std::vector<double>& values) const;
  std::vector<long long> gather(const std::vector<long long>& values) const;
  void barrier() const;

  /// Throws InputError on EVERY rank if any rank passes a non-empty sentence; the lowest such rank's sentence wins,
  /// so that all ranks leave together and no rank is left waiting.
  void agree_on_input_error(const std::string& sentence) const;

 private:
  MPI_Comm comm_;
  int rank_ = 0;
  int size_ = 1;
};

}  // namespace perinox
