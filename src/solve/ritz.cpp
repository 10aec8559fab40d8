#include "ritz.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace perinox::solve {

Ritz largest_ritz(const std::vector<double>& diagonal, const std::vector<double>& side) {
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

double scatter(GlobalId id, int component) {
  auto x = static_cast<std::uint64_t>(id) * 4 + static_cast<std::uint64_t>(component) + 0x9e3779b97f4a7c15ULL;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return static_cast<double>((x ^ (x >> 31)) >> 11) * 0x1p-52 - 1;
}

}  // namespace perinox::solve
