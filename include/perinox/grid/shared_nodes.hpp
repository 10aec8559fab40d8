#pragma once
#include <vector>

#include "perinox/core/communicator.hpp"
#include "perinox/core/types.hpp"

namespace perinox::grid {

/// The nodes that several ranks hold. Each rank has its share of the values that belong to such a node.
class SharedNodes {
 public:
  /// ids: this rank's nodes, ascending. A node has the same id on every rank. Collective.
  SharedNodes(const Communicator& ranks, const std::vector<GlobalId>& ids);

  /// Number of distinct nodes over all ranks.
  long long total() const { return total_; }
  /// [nodes] 1 on the lowest of the ranks that hold a node, 0 on the others.
  const std::vector<char>& counted() const { return counted_; }

  /// Replaces every rank's share by the sum of all shares. They are added up in the order of the ranks, so that the
  /// result is the same on all ranks to the last bit. values: [nodes * width]. Collective.
  void sum(double* values, int width) const { exchange(values, width, MPI_DOUBLE, Sum()); }
  /// Replaces every rank's value by the lowest of all. values: [nodes * width]. Collective.
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
    std::vector<LocalIndex> nodes;  ///< nodes that both ranks hold, in the order of their ids
  };
  template <class Number, class Combine>
  void exchange(Number* values, int width, MPI_Datatype type, const Combine& combine) const;

  MPI_Comm comm_;
  int rank_;
  long long total_ = 0;
  std::vector<Neighbor> neighbors_;  ///< in ascending order of rank
  std::vector<LocalIndex> shared_;   ///< nodes that at least one neighbour holds too
  std::vector<char> counted_;
};

}  // namespace perinox::grid
