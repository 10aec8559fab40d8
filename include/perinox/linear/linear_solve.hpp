#pragma once
#include <memory>
#include <string>
#include <vector>

#include "perinox/deck/deck.hpp"
#include "perinox/linear/failure.hpp"

namespace perinox::linear {

class TangentSystem;

struct LinearOutcome {
  bool converged = false;
  Failure failure = Failure::none;
  int iterations = 0;
  std::string reason;  ///< a sentence, where not converged
};

/// Belos' conjugate gradients where the operator is symmetric (or the deck asks for them), its GMRES otherwise, through
/// Thyra.
class LinearSolver {
 public:
  LinearSolver(const deck::Linear& linear, bool symmetric);
  ~LinearSolver();

  /// Solves the system's operator times left = right, to `tolerance` relative to |right|, with the system's
  /// preconditioner. right, left: [owned unknowns]; left is overwritten, with the last iterate where the solve has not
  /// converged. Collective.
  LinearOutcome solve(const TangentSystem& system, const std::vector<double>& right, double tolerance,
                      std::vector<double>& left) const;

 private:
  struct Factory;
  std::unique_ptr<Factory> factory_;
};

/// What Trilinos threw in a linear solve or a factorisation, with one sentence that says so: its own text runs over
/// several lines and names its source files.
LinearOutcome outcome_of(const std::exception& failure);

}  // namespace perinox::linear
