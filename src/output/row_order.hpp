#pragma once
#include <mpi.h>

#include <vector>

#include "perinox/core/communicator.hpp"
#include "perinox/core/types.hpp"

namespace perinox::output {

/// Carries values of the particles a rank owns to the rows of a file and back. Row = particle id; rank r holds the
/// contiguous rows [total*r/ranks, total*(r+1)/ranks), so a file does not depend on how the particles are spread.
/// The plan is made once; a rank may own no particles and may hold no rows.
class RowOrder {
 public:
  /// id: of the owned particles; over all ranks every one of 0 .. total-1 exactly once, else std::logic_error on every
  /// rank. Collective.
  RowOrder(const Communicator& communicator, const std::vector<GlobalId>& id, int owned, GlobalId total);

  GlobalId first_row() const { return first_row_; }
  int rows() const { return rows_; }
  GlobalId total() const { return total_; }

  /// Values of the owned particles, in their own order, [owned * components] -> [rows * components]. Collective.
  std::vector<double> to_rows(const double* values, int components) const;
  std::vector<int> to_rows(const int* values) const;
  std::vector<GlobalId> to_rows(const GlobalId* values) const;
  /// The way back: [rows * components] -> [owned * components]. Collective.
  std::vector<double> to_owners(const double* rows, int components) const;

 private:
  /// One direction of the exchange: how many particles go to (come from) each rank, and where each of them sits.
  struct Side {
    std::vector<int> count;   ///< [ranks]
    std::vector<int> offset;  ///< [ranks]
    std::vector<int> place;   ///< [particles], in the order of the exchange buffer
  };
  template <class T>
  std::vector<T> exchange(const Side& from, const Side& to, const T* values, int components, MPI_Datatype type) const;

  Communicator communicator_;
  GlobalId total_ = 0;
  GlobalId first_row_ = 0;
  int rows_ = 0;
  Side owners_;  ///< place: index of the owned particle
  Side file_;    ///< place: row - first_row
};

}  // namespace perinox::output
