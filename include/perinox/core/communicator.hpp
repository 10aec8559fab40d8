#pragma once
#include <mpi.h>

#include <memory>
#include <string>
#include <vector>

#include "perinox/core/profile.hpp"

namespace perinox {

/// The ranks that work on one scene: a thin, copyable view of an MPI communicator (not owned).
/// Every member below except rank(), size() and the profile is collective.
class Communicator {
 public:
  explicit Communicator(MPI_Comm comm = MPI_COMM_WORLD);

  MPI_Comm mpi() const { return comm_; }
  int rank() const { return rank_; }
  int size() const { return size_; }
  bool is_root() const { return rank_ == 0; }
  /// This rank's stop watches, shared by all copies of this view. They live here because everything that takes time,
  /// down to the halo exchange inside the body, is handed the communicator already: no signature changes and nothing is
  /// global, so two scenes in one program (as in the tests) have a profile each.
  Profile& profile() const { return *profile_; }

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
  /// Element-wise largest values in place. [values]
  void max(std::vector<double>& values) const;
  /// The seconds the largest over the ranks, the counts this rank's own.
  ProfileReading slowest(const ProfileReading& reading) const;
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
  std::shared_ptr<Profile> profile_;
};

}  // namespace perinox
