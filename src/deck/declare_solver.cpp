/// Declares the keys of the solver.
#include "declare.hpp"
#include "words.hpp"

namespace perinox::deck {
namespace {

Key tolerance_key(std::string name, std::string fallback, std::string sentence) {
  Key key = positive_key(std::move(name), "-", std::move(sentence));
  key.maximum = 1;
  key.fallback = std::move(fallback);
  return key;
}

}  // namespace

Key declare_solver() {
  Key newton = map_key(
      "newton", "Newton's iteration of a step.",
      {tolerance_key("tolerance", "1e-9", "Force residual, relative to the reactions, at which a step is converged."),
       tolerance_key(
           "update_tolerance", "1e-6",
           "What another Newton update would change, relative to the step's displacement increment, at which a "
           "step is converged: the last update times the factor by which it has lowered the residual."),
       integer_key("max_iterations", 1, 100000, "25", "Iterations after which a step counts as failed."),
       word_key(
           "line_search", words::line_search, "backtrack",
           "Shorten an update that makes no progress (it neither lowers the residual nor brings the next correction "
           "down), or always take it whole."),
       word_key("forcing", words::forcing, "eisenstat-walker",
                "Tolerance of the linear solves: adapted to Newton's progress, or always linear.tolerance.")});
  newton.fallback = "{}";
  Key linear = map_key(
      "linear", "The linear solves within Newton's iteration.",
      {word_key("method", words::linear_method, "automatic",
                "Krylov method; automatic takes cg where the tangent is symmetric, else gmres. direct factorises the "
                "assembled tangent on one rank: for small scenes."),
       word_key(
           "preconditioner", words::preconditioner, "automatic",
           "Preconditioner; jacobi, symmetric-gauss-seidel, chebyshev and ilu work on the assembled tangent; automatic "
           "takes two-level for the matrix-free one, block-jacobi where the body is two horizons wide at most."),
       tolerance_key("tolerance", "1e-2",
                     "Relative residual of a linear solve; with eisenstat-walker forcing the loosest one allowed."),
       integer_key("max_iterations", 1, 1e9, "2000", "Iterations after which a linear solve is given up."),
       word_key(
           "chebyshev_steps", words::chebyshev_steps, "automatic",
           "Products and applications of two-level or block-jacobi in one iteration of the Krylov method, joined by "
           "Chebyshev's polynomial: fewer iterations, sums over all ranks and vectors of gmres, for about a fifth "
           "more products. automatic takes 3 with two-level where kappa/mu is above 300 (nu = 0.4983), else 1.")});
  linear.fallback = "{}";
  Key key = map_key(
      "solver", "How each step is solved; every key has a good default.",
      {word_key("tangent", words::tangent_kind, "auto",
                "Apply the tangent bond by bond, or assemble a matrix; auto assembles only for a method or "
                "preconditioner that needs a matrix."),
       word_key(
           "form", words::tangent_form, "consistent",
           "Tangent with every term of the derivative, or the form printed in the literature, which leaves terms out."),
       newton, linear});
  key.fallback = "{}";
  key.example = "solver:\n  newton: {tolerance: 1e-9}\n  linear: {preconditioner: ilu}";
  return key;
}

}  // namespace perinox::deck
