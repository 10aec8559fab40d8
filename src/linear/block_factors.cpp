#include "block_factors.hpp"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cstring>
#include <stdexcept>

#include "perinox/core/widest.hpp"

namespace perinox::linear {

namespace {

using Sparse = Eigen::SparseMatrix<double>;

/// Place of each node in an order of little fill.
std::vector<std::size_t> order_of(std::size_t nodes, const std::vector<BlockFactors::Place>& places) {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(places.size());
  for (const BlockFactors::Place& place : places) entries.emplace_back(place.row, place.column, 1);
  Sparse graph(static_cast<int>(nodes), static_cast<int>(nodes));
  graph.setFromTriplets(entries.begin(), entries.end());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> back;
  Eigen::AMDOrdering<int>()(graph, back);
  std::vector<std::size_t> order(nodes);
  for (std::size_t k = 0; k < nodes; ++k)
    order[static_cast<std::size_t>(back.indices()[static_cast<Eigen::Index>(k)])] = k;
  return order;
}

template <int d>
struct Lanes {
  static constexpr int count = d == 3 ? 4 : 2;
  typedef double Vector __attribute__((vector_size(8 * count)));
};

struct Columns {
  std::size_t nodes;
  const LocalIndex *begin, *row;
  const double* blocks;
  const double* inverse;
};

// Numbers lie at any multiple of eight bytes.
template <class Vector>
inline __attribute__((always_inline)) void load(const double* from, Vector& to) {
  std::memcpy(&to, from, sizeof to);
}
template <class Vector>
inline __attribute__((always_inline)) void store(const Vector& from, double* to) {
  std::memcpy(to, &from, sizeof from);
}

template <int d>
inline __attribute__((always_inline)) void solve_both(const Columns& l, double* x) {
  using Vector = typename Lanes<d>::Vector;
  constexpr int lanes = Lanes<d>::count;
  for (std::size_t j = 0; j < l.nodes; ++j) {
    const double* inverse = l.inverse + j * d * lanes;
    double* own = x + j * lanes;
    Vector y{}, column;
#pragma GCC unroll 3
    for (int c = 0; c < d; ++c) {
      load(inverse + c * lanes, column);
      y += column * own[c];
    }
    store(y, own);
    for (LocalIndex k = l.begin[j]; k < l.begin[j + 1]; ++k) {
      const double* block = l.blocks + static_cast<std::size_t>(k) * (d * lanes);
      double* below = x + static_cast<std::size_t>(l.row[k]) * lanes;
      Vector sum;
      load(below, sum);
#pragma GCC unroll 3
      for (int c = 0; c < d; ++c) {
        load(block + c * lanes, column);
        sum -= column * y[c];
      }
      store(sum, below);
    }
  }
  for (std::size_t j = l.nodes; j-- > 0;) {
    const double* inverse = l.inverse + j * d * lanes;
    Vector sums[d] = {}, column, below, left;
    for (LocalIndex k = l.begin[j]; k < l.begin[j + 1]; ++k) {
      const double* block = l.blocks + static_cast<std::size_t>(k) * (d * lanes);
      load(x + static_cast<std::size_t>(l.row[k]) * lanes, below);
#pragma GCC unroll 3
      for (int c = 0; c < d; ++c) {
        load(block + c * lanes, column);
        sums[c] += column * below;
      }
    }
    double* own = x + j * lanes;
    load(own, left);
#pragma GCC unroll 3
    for (int c = 0; c < d; ++c)
      for (int p = 0; p < d; ++p) left[c] -= sums[c][p];
#pragma GCC unroll 3
    for (int c = 0; c < d; ++c) {
      load(inverse + c * lanes, column);
      own[c] = 0;
      for (int p = c; p < d; ++p) own[c] += column[p] * left[p];
    }
  }
}

PERINOX_WIDEST void solve_3(const Columns& l, double* x) { solve_both<3>(l, x); }
PERINOX_WIDEST void solve_2(const Columns& l, double* x) { solve_both<2>(l, x); }

}  // namespace

BlockFactors::BlockFactors(int dimension, std::size_t nodes, const std::vector<Place>& places,
                           const std::vector<double>& blocks)
    : dimension_(dimension), order_(order_of(nodes, places)) {
  const auto d = static_cast<std::size_t>(dimension);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(blocks.size());
  for (std::size_t k = 0; k < places.size(); ++k) {
    std::size_t row = order_[static_cast<std::size_t>(places[k].row)];
    std::size_t column = order_[static_cast<std::size_t>(places[k].column)];
    const bool turned = row < column;
    if (turned) std::swap(row, column);
    for (std::size_t p = 0; p < d; ++p)
      for (std::size_t q = 0; q < d; ++q)
        if (row != column || p >= q)
          entries.emplace_back(static_cast<int>(row * d + p), static_cast<int>(column * d + q),
                               blocks[k * d * d + (turned ? q * d + p : p * d + q)]);
  }
  const auto n = static_cast<int>(nodes * d);
  Sparse lower(n, n);
  lower.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLLT<Sparse, Eigen::Lower, Eigen::NaturalOrdering<int>> factors(lower);
  if (factors.info() != Eigen::Success) throw std::runtime_error("the coarse matrix is not positive definite");

  // Unknowns of a node stay together and are all coupled, so that the factor is made of whole blocks.
  const Sparse& l = factors.matrixL().nestedExpression();
  begin_.push_back(0);
  inverse_.assign(nodes * d * lanes(), 0);
  for (std::size_t j = 0; j < nodes; ++j) {
    Eigen::MatrixXd diagonal = Eigen::MatrixXd::Zero(dimension, dimension);
    const std::size_t first = row_.size();
    for (std::size_t c = 0; c < d; ++c)
      for (Sparse::InnerIterator entry(l, static_cast<int>(j * d + c)); entry; ++entry) {
        const auto row = static_cast<LocalIndex>(static_cast<std::size_t>(entry.row()) / d);
        const std::size_t p = static_cast<std::size_t>(entry.row()) % d;
        if (row == static_cast<LocalIndex>(j)) {
          diagonal(static_cast<Eigen::Index>(p), static_cast<Eigen::Index>(c)) = entry.value();
          continue;
        }
        const auto from = row_.begin() + static_cast<std::ptrdiff_t>(first);
        const auto found = std::lower_bound(from, row_.end(), row);
        const auto k = static_cast<std::size_t>(found - row_.begin());
        if (found == row_.end() || *found != row) {
          if (c > 0 || found != row_.end()) throw std::logic_error("a factor that is not made of whole blocks");
          row_.push_back(row);
          blocks_.resize(row_.size() * d * lanes(), 0);
        }
        blocks_[(k * d + c) * lanes() + p] = entry.value();
      }
    const Eigen::MatrixXd inverse =
        diagonal.triangularView<Eigen::Lower>().solve(Eigen::MatrixXd::Identity(dimension, dimension));
    for (std::size_t c = 0; c < d; ++c)
      for (std::size_t p = c; p < d; ++p)
        inverse_[(j * d + c) * lanes() + p] = inverse(static_cast<Eigen::Index>(p), static_cast<Eigen::Index>(c));
    begin_.push_back(static_cast<LocalIndex>(row_.size()));
  }
  row_.shrink_to_fit();
  blocks_.shrink_to_fit();
}

void BlockFactors::solve(double* x) const {
  const Columns columns{order_.size(), begin_.data(), row_.data(), blocks_.data(), inverse_.data()};
  (dimension_ == 3 ? solve_3 : solve_2)(columns, x);
}

std::size_t BlockFactors::bytes() const {
  return blocks_.capacity() * sizeof(double) + inverse_.capacity() * sizeof(double) +
         (begin_.capacity() + row_.capacity()) * sizeof(LocalIndex) + order_.capacity() * sizeof(std::size_t);
}

}  // namespace perinox::linear
