#include "node_smoother.hpp"

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "perinox/core/widest.hpp"

namespace perinox::linear {

namespace {

constexpr int power_iterations = 12;
/// The power iteration's estimate is from below, by 4 to 7 % (cubes, cracks, holes, contrasts to 1e6, clouds, bars, nu
/// to 0.499). The cycle stays definite as long as the largest eigenvalue is at most 1.05 of what is taken for it.
constexpr double estimate_margin = 1.1;

typedef double Four __attribute__((vector_size(32), aligned(8), may_alias));
typedef float FourSingle __attribute__((vector_size(16), aligned(4), may_alias));

inline __attribute__((always_inline)) void load(const float* at, Four& column) {
  column = __builtin_convertvector(*reinterpret_cast<const FourSingle*>(at), Four);
}

/// left = right - A x; right may be null for zero.
template <int d>
inline __attribute__((always_inline)) void subtract_product(std::size_t nodes, const LocalIndex* begin,
                                                            const LocalIndex* column, const float* blocks,
                                                            const double* right, const double* x, double* left) {
  for (std::size_t n = 0; n < nodes; ++n) {
    Four sum = right ? *reinterpret_cast<const Four*>(right + 4 * n) : Four{};
    for (LocalIndex k = begin[n]; k < begin[n + 1]; ++k) {
      const float* block = blocks + static_cast<std::size_t>(k) * (4 * d);
      const double* value = x + 4 * static_cast<std::size_t>(column[k]);
#pragma GCC unroll 3
      for (int c = 0; c < d; ++c) {
        Four entries;
        load(block + 4 * c, entries);
        sum -= entries * value[c];
      }
    }
    *reinterpret_cast<Four*>(left + 4 * n) = sum;
  }
}

PERINOX_WIDEST void subtract_product_3(std::size_t nodes, const LocalIndex* begin, const LocalIndex* column,
                                       const float* blocks, const double* right, const double* x, double* left) {
  subtract_product<3>(nodes, begin, column, blocks, right, x, left);
}
PERINOX_WIDEST void subtract_product_2(std::size_t nodes, const LocalIndex* begin, const LocalIndex* column,
                                       const float* blocks, const double* right, const double* x, double* left) {
  subtract_product<2>(nodes, begin, column, blocks, right, x, left);
}

/// A number in [-1, 1] that depends on nothing but the unknown: the same on any partition.
double scattered(GlobalId id, int component) {
  auto bits = static_cast<std::uint64_t>(id * 4 + component + 1) * 0x9E3779B97F4A7C15ULL;
  bits = (bits ^ bits >> 30) * 0xBF58476D1CE4E5B9ULL;
  bits = (bits ^ bits >> 27) * 0x94D049BB133111EBULL;
  return static_cast<double>(bits >> 11) * 0x1.0p-52 - 1;
}

}  // namespace

NodeSmoother::NodeSmoother(const Communicator& ranks, const grid::SharedNodes& shared, const std::vector<GlobalId>& id,
                           const CoarseMatrix& matrix, int degree, double ratio)
    : shared_(shared), dimension_(matrix.dimension), degree_(degree) {
  const auto d = static_cast<std::size_t>(dimension_);
  const std::size_t nodes = id.size();
  begin_.assign(matrix.row_begin.begin(), matrix.row_begin.end());
  column_ = matrix.column;
  blocks_.assign(column_.size() * 4 * d, 0);
  for (std::size_t k = 0; k < column_.size(); ++k)
    for (std::size_t p = 0; p < d; ++p)
      for (std::size_t q = 0; q < d; ++q)
        blocks_[(k * d + q) * 4 + p] = static_cast<float>(matrix.value[(k * d + p) * d + q]);

  std::vector<double> diagonal(nodes * d * d);
  for (std::size_t n = 0; n < nodes; ++n)
    for (std::size_t k = matrix.row_begin[n]; k < matrix.row_begin[n + 1]; ++k)
      if (matrix.column[k] == static_cast<LocalIndex>(n))
        std::copy_n(&matrix.value[k * d * d], d * d, &diagonal[n * d * d]);
  shared_.sum(diagonal.data(), static_cast<int>(d * d));
  inverse_diagonal_.assign(nodes * 4 * d, 0);
  for (std::size_t n = 0; n < nodes; ++n) {
    const Eigen::Map<const Eigen::MatrixXd> block(&diagonal[n * d * d], dimension_, dimension_);
    const Eigen::MatrixXd inverse = block.inverse();
    for (std::size_t p = 0; p < d; ++p)
      for (std::size_t q = 0; q < d; ++q)
        inverse_diagonal_[(n * d + q) * 4 + p] = inverse(static_cast<Eigen::Index>(p), static_cast<Eigen::Index>(q));
  }

  // The largest eigenvalue of D^-1 A: w = D^-1 A v has the quotient w.Aw / w.Dw <= highest, here w.Av / v.Av.
  Vector v(size(), 0), w;
  for (std::size_t n = 0; n < nodes; ++n)
    for (int c = 0; c < dimension_; ++c) v[4 * n + static_cast<std::size_t>(c)] = scattered(id[n], c);
  const std::vector<char>& counted = shared_.counted();
  double highest = 1;
  for (int k = 0; k < power_iterations; ++k) {
    work_.assign(size(), 0);
    residual({}, v, work_);
    shared_.sum(work_.data(), 4);
    multiply_diagonal(work_, w);
    std::vector<double> sums{0, 0, 0};
    for (std::size_t u = 0; u < size(); ++u) {
      if (!counted[u / 4]) continue;
      sums[0] += w[u] * work_[u];
      sums[1] -= v[u] * work_[u];
      sums[2] = std::max(sums[2], std::abs(w[u]));
    }
    const double most = ranks.max(sums[2]);
    sums.resize(2);
    ranks.sum(sums);
    if (!(sums[1] > 0) || !(most > 0)) break;
    highest = sums[0] / sums[1];
    for (std::size_t u = 0; u < size(); ++u) v[u] = w[u] / most;
  }
  highest_ = estimate_margin * highest;
  lowest_ = highest_ / ratio;
}

void NodeSmoother::residual(const Vector& right, const Vector& x, Vector& left) const {
  left.resize(size());
  const auto product = dimension_ == 3 ? subtract_product_3 : subtract_product_2;
  product(size() / 4, begin_.data(), column_.data(), blocks_.data(), right.empty() ? nullptr : right.data(), x.data(),
          left.data());
}

void NodeSmoother::multiply_diagonal(const Vector& x, Vector& y) const {
  y.resize(size());
  const auto d = static_cast<std::size_t>(dimension_);
  for (std::size_t n = 0; n < size() / 4; ++n) {
    Four sum{};
    for (std::size_t c = 0; c < d; ++c)
      sum += *reinterpret_cast<const Four*>(&inverse_diagonal_[(n * d + c) * 4]) * x[4 * n + c];
    *reinterpret_cast<Four*>(&y[4 * n]) = sum;
  }
}

void NodeSmoother::smooth(const Vector& right, Vector& x, bool from_zero) const {
  const double middle = (highest_ + lowest_) / 2, half = (highest_ - lowest_) / 2;
  double rho = half / middle;
  if (from_zero) {
    work_ = right;
    x.assign(size(), 0);
  } else {
    residual(right, x, work_);
  }
  for (int k = 0; k < degree_; ++k) {
    shared_.sum(work_.data(), 4);
    multiply_diagonal(work_, scaled_);
    if (k == 0) {
      direction_.resize(size());
      for (std::size_t u = 0; u < size(); ++u) direction_[u] = scaled_[u] / middle;
    } else {
      const double next = 1 / (2 * middle / half - rho);
      for (std::size_t u = 0; u < size(); ++u)
        direction_[u] = next * rho * direction_[u] + 2 * next / half * scaled_[u];
      rho = next;
    }
    for (std::size_t u = 0; u < size(); ++u) x[u] += direction_[u];
    if (k + 1 < degree_) residual(right, x, work_);
  }
}

std::size_t NodeSmoother::bytes() const {
  return blocks_.capacity() * sizeof(float) +
         (inverse_diagonal_.capacity() + work_.capacity() + direction_.capacity() + scaled_.capacity()) *
             sizeof(double) +
         (begin_.capacity() + column_.capacity()) * sizeof(LocalIndex);
}

}  // namespace perinox::linear
