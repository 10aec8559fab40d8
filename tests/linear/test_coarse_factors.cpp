/// The factorised coarse system against a dense solve: blocks of either dimension, any numbers of the nodes.
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cstdio>
#include <random>

#include "linear/coarse_solver.hpp"

namespace perinox::test {
namespace {

using linear::CoarseMatrix;

/// A random symmetric matrix on a grid of nodes, neighbours within one step on each axis coupled; definite by its
/// diagonal if `definite`.
struct Problem {
  Problem(int dimension, int edge, bool definite) {
    const int nodes = dimension == 3 ? edge * edge * edge : edge * edge;
    std::mt19937 generator(5);
    std::uniform_real_distribution<double> entry(-1, 1);
    const int n = nodes * dimension;
    dense = Eigen::MatrixXd::Zero(n, n);
    const auto near = [&](int a, int b) {
      const auto close = [&](int over) { return std::abs(a / over % edge - b / over % edge) <= 1; };
      return close(1) && close(edge) && (dimension == 2 || close(edge * edge));
    };
    for (int a = 0; a < nodes; ++a)
      for (int b = 0; b <= a; ++b)
        for (int p = 0; near(a, b) && p < dimension; ++p)
          for (int q = 0; q < dimension; ++q) dense(a * dimension + p, b * dimension + q) = entry(generator);
    dense = dense.selfadjointView<Eigen::Lower>();
    dense.diagonal().array() += definite ? 30 : -30;
    matrix.dimension = dimension;
    matrix.row_begin.push_back(0);
    for (int a = 0; a < nodes; ++a) {
      for (int b = 0; b < nodes; ++b) {
        if (!near(a, b)) continue;
        matrix.column.push_back(b);
        for (int p = 0; p < dimension; ++p)
          for (int q = 0; q < dimension; ++q) matrix.value.push_back(dense(a * dimension + p, b * dimension + q));
      }
      matrix.row_begin.push_back(matrix.column.size());
      ids.push_back(100 + 7 * a);
    }
  }
  Eigen::MatrixXd dense;
  CoarseMatrix matrix;
  std::vector<GlobalId> ids;
};

TEST(CoarseFactors, SolveAsADenseMatrixDoes) {
  for (const int dimension : {2, 3}) {
    const Problem of(dimension, 5, true);
    const auto factors = linear::factorised_coarse_solver(Communicator(MPI_COMM_SELF), of.ids, of.matrix);
    EXPECT_TRUE(factors->exact());
    EXPECT_EQ(factors->unknowns(), of.dense.rows());
    const Eigen::VectorXd a = Eigen::VectorXd::Random(of.dense.rows()), b = Eigen::VectorXd::Random(of.dense.rows());
    Eigen::VectorXd x(a.size()), y(a.size());
    factors->solve(a.data(), x.data());
    factors->solve(b.data(), y.data());
    const double error = (x - of.dense.llt().solve(a)).norm() / x.norm();
    const double asymmetry = std::abs(a.dot(y) - b.dot(x)) / (a.norm() * y.norm());
    std::printf("%d-D: error %.1e, asymmetry %.1e\n", dimension, error, asymmetry);
    EXPECT_LT(error, 1e-13);  // 2e-16
    EXPECT_LT(asymmetry, 1e-15);
  }
}

TEST(CoarseFactors, AnIndefiniteMatrixIsRefused) {
  const Problem of(3, 3, false);
  EXPECT_THROW(linear::factorised_coarse_solver(Communicator(MPI_COMM_SELF), of.ids, of.matrix), std::runtime_error);
}

}  // namespace
}  // namespace perinox::test
