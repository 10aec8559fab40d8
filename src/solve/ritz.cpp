#include "ritz.hpp"

#include <Eigen/Eigenvalues>

namespace perinox::solve {

Ritz largest_ritz(const std::vector<double>& diagonal, const std::vector<double>& side) {
  const auto n = static_cast<Eigen::Index>(diagonal.size());
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
  solver.computeFromTridiagonal(Eigen::Map<const Eigen::VectorXd>(diagonal.data(), n),
                                Eigen::Map<const Eigen::VectorXd>(side.data(), n - 1));
  return {solver.eigenvalues()[n - 1], solver.eigenvalues()[0],
          side.back() * std::abs(solver.eigenvectors()(n - 1, n - 1))};
}

double scatter(GlobalId id, int component) {
  auto x = static_cast<std::uint64_t>(id) * 4 + static_cast<std::uint64_t>(component) + 0x9e3779b97f4a7c15ULL;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return static_cast<double>((x ^ (x >> 31)) >> 11) * 0x1p-52 - 1;
}

}  // namespace perinox::solve
