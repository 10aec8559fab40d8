#pragma once
#include <memory>
#include <string>

#include "coarse_elasticity.hpp"

namespace perinox::linear {

/// Solves with the coarse matrix summed over the ranks, exactly or by a fixed symmetric positive definite
/// approximation of its inverse.
class CoarseSolver {
 public:
  virtual ~CoarseSolver() = default;
  /// right: this rank's share, adds up over the ranks; solution: at this rank's nodes. [BackgroundGrid::unknowns()].
  /// Collective.
  virtual void solve(const double* right, double* solution) = 0;
  /// True if solve() leaves no error.
  virtual bool exact() const = 0;
  /// Unknowns over all ranks.
  virtual long long unknowns() const = 0;
  /// Held on this rank.
  virtual std::size_t bytes() const = 0;
};

/// Sparse Cholesky factors, the same on every rank: for small systems. Throws std::runtime_error where the matrix is
/// not positive definite. Collective.
std::unique_ptr<CoarseSolver> factorised_coarse_solver(const Communicator& ranks, const std::vector<GlobalId>& node_ids,
                                                       const CoarseMatrix& matrix);

/// Factors of systems of at most factorised_up_to unknowns; else one V-cycle over the grid and every second, fourth,
/// ... node of it (Nesting), with Chebyshev smoothers of the given degree and factors of the first level that is small
/// enough. Collective.
std::unique_ptr<CoarseSolver> make_coarse_solver(const Communicator& ranks, const grid::BackgroundGrid& grid,
                                                 CoarseMatrix matrix, int smoothing, long long factorised_up_to);

}  // namespace perinox::linear
