#include "perinox/linear/lanczos.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstdint>

namespace perinox::linear {

namespace {

/// Of the symmetric tridiagonal matrix of Lanczos' method. side: [diagonal.size()], its last entry that of the next
/// vector.
Ritz ritz_of(const std::vector<double>& diagonal, const std::vector<double>& side) {
  const auto n = static_cast<Eigen::Index>(diagonal.size());
  const Eigen::Map<const Eigen::VectorXd> middle(diagonal.data(), n), beside(side.data(), n - 1);
  // Eigen takes entries below 5e-32 for nothing, so the matrix is brought to the size of one first; by a power of two,
  // which rounds nothing.
  const double largest = std::max(middle.cwiseAbs().maxCoeff(), n > 1 ? beside.cwiseAbs().maxCoeff() : 0.0);
  const double unit = largest > 0 && std::isfinite(largest) ? std::exp2(std::ilogb(largest)) : 1;
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
  solver.computeFromTridiagonal(middle / unit, beside / unit);
  return {solver.eigenvalues()[n - 1] * unit, solver.eigenvalues()[0] * unit,
          side.back() * std::abs(solver.eigenvectors()(n - 1, n - 1))};
}

}  // namespace

Ritz largest_eigenvalue(const Communicator& ranks, const std::vector<double>& start, const LinearMap& a,
                        const LinearMap& m, const LanczosSettings& settings) {
  const std::size_t unknowns = start.size();
  const auto dot = [&](const std::vector<double>& x, const std::vector<double>& y) {
    double sum = 0;
    for (std::size_t u = 0; u < unknowns; ++u) sum += x[u] * y[u];
    return ranks.sum(sum);
  };
  // v has the length one in the scalar product of M, y = M v.
  std::vector<double> w = start, y(unknowns), v(unknowns, 0.0), before(unknowns);
  const auto length_of_w = [&] {
    if (m)
      m(w, y);
    else
      y = w;
    const double square = dot(w, y);
    return std::sqrt(square < 0 ? 0 : square);
  };
  double length = length_of_w();
  std::vector<double> diagonal, side;
  Ritz ritz;
  while (length > 0 && static_cast<int>(diagonal.size()) < settings.most_products) {
    std::swap(before, v);
    for (std::size_t u = 0; u < unknowns; ++u) {
      v[u] = w[u] / length;
      y[u] /= length;
    }
    a(y, w);
    if (!side.empty())
      for (std::size_t u = 0; u < unknowns; ++u) w[u] -= side.back() * before[u];
    diagonal.push_back(dot(w, y));
    for (std::size_t u = 0; u < unknowns; ++u) w[u] -= diagonal.back() * v[u];
    length = length_of_w();
    side.push_back(length);
    ritz = ritz_of(diagonal, side);
    // A side of rounding only: the space is exhausted, the value exact.
    if (ritz.residual <= settings.accuracy * std::abs(ritz.value) || length <= 1e-12 * std::abs(ritz.value)) break;
  }
  return ritz;
}

double scatter(GlobalId id, int component) {
  auto x = static_cast<std::uint64_t>(id) * 4 + static_cast<std::uint64_t>(component) + 0x9e3779b97f4a7c15ULL;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return static_cast<double>((x ^ (x >> 31)) >> 11) * 0x1p-52 - 1;
}

}  // namespace perinox::linear
