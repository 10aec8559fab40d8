#pragma once
/// Belos through Thyra. A heavy header.
#include <Thyra_LinearOpWithSolveFactoryBase.hpp>
#include <Thyra_PreconditionerBase.hpp>
#include <exception>
#include <string>

#include "perinox/core/tpetra.hpp"
#include "perinox/deck/deck.hpp"
#include "perinox/linear/failure.hpp"

namespace perinox::linear {

using LinearSolverFactory = Thyra::LinearOpWithSolveFactoryBase<double>;

/// Belos' conjugate gradients where the operator is symmetric (or the deck asks for them), its GMRES otherwise.
Teuchos::RCP<LinearSolverFactory> belos_factory(const deck::Linear& linear, bool symmetric);

struct LinearOutcome {
  bool converged = false;
  Failure failure = Failure::none;
  int iterations = 0;
  std::string reason;  ///< a sentence, where not converged
};

/// What Trilinos threw; other, where it is nothing that is known here.
Failure failure_of(const std::exception& failure);
/// One sentence for what Trilinos threw: its own text runs over several lines and names its source files.
std::string sentence_of(const std::exception& failure);

/// Solves A left = right to `tolerance` relative to |right|; preconditioner may be null. Collective.
LinearOutcome solve_linear(const LinearSolverFactory& factory, const Teuchos::RCP<const Thyra::LinearOpBase<double>>& a,
                           const Teuchos::RCP<const Thyra::PreconditionerBase<double>>& preconditioner,
                           double tolerance, const Teuchos::RCP<tpetra::Vector>& right,
                           const Teuchos::RCP<tpetra::Vector>& left);

}  // namespace perinox::linear
