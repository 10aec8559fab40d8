#pragma once
#include <mpi.h>

#include <vector>

#include "perinox/core/communicator.hpp"
#include "perinox/core/types.hpp"

namespace perinox::output {

/// Carries values of the particles that a rank owns to the rows of a file and back. A row is a particle's id. Rank r
/// holds the contiguous rows [total*r/ranks, total*(r+1)/ranks), so a file does not depend on how the particles are
/// spread. The plan is made once. A rank may own no particles and may hold no rows.
class RowOrder {
 public:
  /// id: those of the owned particles. Over all ranks they must be every one of 0 .. total-1 exactly once, otherwise
  /// every rank throws std::logic_error. Collective.
  RowOrder(const Communicator& communicator, const std::vector<GlobalId>& id, int owned, GlobalId total);

  GlobalId first_row() const { return first_row_; }
  int rows() const { return rows_; }
  GlobalId total() const { return total_; }

  /// Carries values of the owned particles, in their own order, to the rows: [owned * components] -> [rows *
  /// components]. Collective.
  std::vector<double> to_rows(const double* values, int components) const;
  std::vector<int> to_rows(const int* values) const;
  std::vector<GlobalId> to_rows(const GlobalId* values) const;
  /// Carries values of the rows back to the owned particles: [rows * components] -> [owned * components]. Collective.
  std::vector<double> to_owners(const double* rows, int components) const;

 private:
  /// One direction of the exchange: the number of particles that go to (or come from) each rank, and the place of each.
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
