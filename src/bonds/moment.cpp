#include "perinox/bonds/moment.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace perinox::bonds {

namespace {
/// Below this ratio of M's smallest eigenvalue to its largest a family does not tell all strains apart.
constexpr double singular = 1e-6;
constexpr double isotropic = 1e-10;
/// Least deviatoric volume over m: a few bonds in one direction have no energy left once the dilatation is taken off.
constexpr double least_share = 0.1;
}  // namespace

Mandel mandel(int dimension, const double* n, double scale) {
  const double root2 = std::sqrt(2.0);
  if (dimension == 2) return {scale * n[0] * n[0], scale * n[1] * n[1], scale * root2 * n[0] * n[1], 0, 0, 0};
  return {scale * n[0] * n[0],         scale * n[1] * n[1],         scale * n[2] * n[2],
          scale * root2 * n[1] * n[2], scale * root2 * n[0] * n[2], scale * root2 * n[0] * n[1]};
}

double Moment::weighted_volume() const {
  double m = 0;
  for (int c = 0; c < dimension; ++c) m += second[static_cast<std::size_t>(c)];
  return m;
}

double deviatoric_volume(int dimension, const std::array<double, 36>& sums) {
  const int n = mandel_size(dimension), d = dimension;
  double m = 0, square = 0;  // trace of M I, and the square of its norm
  for (int p = 0; p < n; ++p) {
    double entry = 0;
    for (int c = 0; c < d; ++c) entry += sums[static_cast<std::size_t>(p * n + c)];
    if (p < d) m += entry;
    square += entry * entry;
  }
  // The mean over unit deviators of eps M eps - (I M eps)^2/m. The trace of M is m.
  const double mean = (m * (d - 1) / d - (square - m * m / d) / m) / (n - 1);
  return std::max(d * (d + 2) * mean / 2, least_share * m);
}

FamilyKind make_moment(int dimension, const std::array<double, 36>& sums, double rounding, Moment& moment) {
  using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor, 6, 6>;
  using Column = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 6, 1>;
  const int n = mandel_size(dimension);
  const Square all = Eigen::Map<const Square>(sums.data(), n, n);
  Column one = Column::Zero(n);
  one.head(dimension).setOnes();
  const Column second = all * one;
  const double m = one.dot(second);
  const Square even = m / (dimension * (dimension + 2)) * (one * one.transpose() + 2 * Square::Identity(n, n));
  if (!((all - even).norm() > (isotropic + rounding) * m)) return FamilyKind::isotropic;
  const Eigen::SelfAdjointEigenSolver<Square> values(all);
  if (!(values.eigenvalues()[0] > singular * values.eigenvalues()[n - 1])) return FamilyKind::deficient;
  moment.dimension = dimension;
  Eigen::Map<Square>(moment.inverse.data(), n, n) =
      values.eigenvectors() * values.eigenvalues().cwiseInverse().asDiagonal() * values.eigenvectors().transpose();
  Eigen::Map<Column>(moment.second.data(), n) = second;
  return FamilyKind::irregular;
}

}  // namespace perinox::bonds
