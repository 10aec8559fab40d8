/// Applies the rules that the solver's keys must follow together.
#include <fmt/format.h>

#include "convert.hpp"

namespace perinox::deck {
namespace {

bool works_on_matrix(Preconditioner kind) {
  return kind == Preconditioner::jacobi || kind == Preconditioner::symmetric_gauss_seidel ||
         kind == Preconditioner::chebyshev || kind == Preconditioner::ilu;
}

}  // namespace

bool Solver::needs_matrix() const {
  return linear.method == LinearMethod::direct || works_on_matrix(linear.preconditioner);
}

bool Solver::assembled() const {
  return tangent == TangentKind::assembled || (tangent == TangentKind::automatic && needs_matrix());
}

void refuse_unfit_solver(const Solver& solver, const Value& linear) {
  const Value &method = linear.at("method"), &preconditioner = linear.at("preconditioner");
  const Preconditioner kind = solver.linear.preconditioner;
  if (solver.linear.method == LinearMethod::direct) {
    if (!solver.assembled())
      refuse(method.location(),
             "the direct method factorises the assembled matrix; leave tangent: matrix-free out of solver, or take "
             "method: automatic");
    if (kind != Preconditioner::automatic && kind != Preconditioner::none)
      refuse(preconditioner.location(),
             fmt::format("the direct method takes no preconditioner, but {} is asked for; take one of the two out",
                         preconditioner.text()));
  }
  if (works_on_matrix(kind) && !solver.assembled())
    refuse(preconditioner.location(),
           fmt::format("the preconditioner {} needs the assembled matrix; leave tangent: matrix-free out of solver, or "
                       "take two-level",
                       preconditioner.text()));
  const bool without = solver.assembled() || kind == Preconditioner::none;
  if (solver.linear.chebyshev_steps > 1 && without)
    refuse(
        linear.at("chebyshev_steps").location(),
        "chebyshev_steps needs the matrix-free tangent with two-level or block-jacobi; take it out, or what asks for "
        "another preconditioner or the assembled matrix");
}

}  // namespace perinox::deck
