#pragma once
#include <mpi.h>

#include <memory>
#include <string>
#include <vector>

#include "perinox/core/profile.hpp"

namespace perinox {

/// The ranks that work on one scene: a thin, copyable view of an MPI communicator, which it does not own. Every member
/// below except rank(), size() and the profile is collective.
class Communicator {
 public:
  explicit Communicator(MPI_Comm comm = MPI_COMM_WORLD);

  MPI_Comm mpi() const { return comm_; }
  int rank() const { return rank_; }
  int size() const { return size_; }
  bool is_root() const { return rank_ == 0; }
  /// This rank's stop watches, shared by all copies of this view. They belong to the communicator because everything
  /// that takes time, down to the halo exchange inside the body, gets the communicator anyway. So no signature changes
  /// and nothing is global: two scenes in one program (as in the tests) have a profile each.
  Profile& profile() const { return *profile_; }

  double sum(double value) const;
  long long sum(long long value) const;
  double max(double value) const;
  long long max(long long value) const;
  double min(double value) const;
  bool any(bool value) const;
  /// Sum of `value` over the ranks before this one; it is 0 on rank 0.
  long long exclusive_scan(long long value) const;
  /// Replaces `values` by their sums over the ranks, element by element. [values]
  void sum(std::vector<double>& values) const;
  /// Replaces `values` by their largest over the ranks, element by element. [values]
  void max(std::vector<double>& values) const;
  /// A reading with the seconds of the slowest rank, section by section, and the counts of this rank.
  ProfileReading slowest(const ProfileReading& reading) const;
  /// Collects one entry from every rank, in rank order, on every rank.
  std::vector<double> gather(double value) const;
  std::vector<long long> gather(long long value) const;
  /// Collects the lists of all ranks one after the other, in rank order, on every rank.
  std::vector<double> gather(const std::vector<double>& values) const;
  std::vector<long long> gather(const std::vector<long long>& values) const;
  void barrier() const;

  /// Throws InputError on EVERY rank if any rank passes a non-empty sentence. The sentence of the lowest such rank is
  /// thrown. All ranks leave together, so that none is left waiting.
  void agree_on_input_error(const std::string& sentence) const;

 private:
  MPI_Comm comm_;
  int rank_ = 0;
  int size_ = 1;
  std::shared_ptr<Profile> profile_;
};

}  // namespace perinox
