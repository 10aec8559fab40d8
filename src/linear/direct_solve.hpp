#pragma once
#include <memory>

#include "owned_operator.hpp"
#include "perinox/core/communicator.hpp"

namespace perinox::linear {

/// The inverse of a sparse matrix by factorisation (Eigen's supernodal LU), to be applied as a preconditioner: the
/// Krylov method then ends after its first iteration, definite or not. The matrix is gathered to rank 0 and factorised
/// there, so it is for small scenes.
///
/// Not Amesos2, as Debian's Trilinos 13.2 has it: on more than one rank its KLU2 left a residual of 7e-2 for our
/// matrices and its Tacho crashed; on one rank KLU2 took 2 to 4 times longer (cube of 8^3 particles: 0.9 s against
/// 0.35).
class DirectSolve : public OwnedOperator {
 public:
  /// The global numbers of the unknowns are 0 .. n-1, in any order on any rank. Collective.
  DirectSolve(Teuchos::RCP<const tpetra::Matrix> matrix, const Communicator& communicator);
  ~DirectSolve() override;

  /// Factorises the matrix's present values. Collective. Throws std::runtime_error on every rank where it is singular.
  void factorise();
  /// y = A^-1 x after factorise(). Collective.
  void multiply(const double* x, double* y) const override;

 private:
  struct Root;
  Teuchos::RCP<const tpetra::Matrix> matrix_;
  Communicator communicator_;
  std::unique_ptr<Root> root_;  ///< what rank 0 keeps
};

}  // namespace perinox::linear
