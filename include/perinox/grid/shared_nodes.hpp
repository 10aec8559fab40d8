#pragma once
#include <vector>

#include "perinox/core/communicator.hpp"
#include "perinox/core/types.hpp"

namespace perinox::grid {

/// Nodes that several ranks hold, each with its share of what belongs to them.
class SharedNodes {
 public:
  /// ids: of this rank's nodes, ascending; the same node has the same id on every rank. Collective.
  SharedNodes(const Communicator& ranks, const std::vector<GlobalId>& ids);

  /// Distinct nodes over all ranks.
  long long total() const { return total_; }
  /// [nodes] 1 on the lowest of the ranks that hold a node, 0 on the others.
  const std::vector<char>& counted() const { return counted_; }

  /// Every rank's shares become their sum, added up in the order of the ranks. [nodes * width] Collective.
  void sum(double* values, int width) const { exchange(values, width, MPI_DOUBLE, Sum()); }
  /// The lowest of the ranks' values. Collective.
  void lowest(long long* values, int width) const { exchange(values, width, MPI_LONG_LONG, Lowest()); }

 private:
  struct Sum {
    template <class Number>
    void operator()(Number& all, Number one) const {
      all += one;
    }
  };
  struct Lowest {
    template <class Number>
    void operator()(Number& all, Number one) const {
      all = one < all ? one : all;
    }
  };
  struct Neighbor {
    int rank;
    std::vector<LocalIndex> nodes;  ///< held by both, in the order of their ids
  };
  template <class Number, class Combine>
  void exchange(Number* values, int width, MPI_Datatype type, const Combine& combine) const;

  MPI_Comm comm_;
  int rank_;
  long long total_ = 0;
  std::vector<Neighbor> neighbors_;  ///< ascending
  std::vector<LocalIndex> shared_;   ///< nodes that a neighbour holds too
  std::vector<char> counted_;
};

}  // namespace perinox::grid
