#pragma once
#include "perinox/core/record.hpp"
#include "perinox/deck/deck.hpp"

namespace perinox::equilibrium {

/// The iterates of one Newton solve, whatever drives it: tells the observer of each, judges whether it has converged,
/// and says how exactly the next linear solve has to be.
class NewtonProgress {
 public:
  /// Both are kept by reference.
  NewtonProgress(const deck::Solver& settings, Observer& observer) : settings_(settings), observer_(observer) {}

  /// The next iterate, 0 first. floor: residual below which nothing but rounding is left, force.
  void add(const NewtonIteration& row, double floor);

  /// True where the residual of the last iterate is small against the reactions and what another update would change is
  /// small against the step, or where nothing but rounding is left.
  bool converged() const { return converged_; }
  /// Tolerance of the linear solve that follows the last iterate: Eisenstat and Walker's choice 2, or the deck's
  /// constant. 0 before the first one.
  double forcing() const { return forcing_; }
  /// True where a linear solve has needed all its iterations once more than is allowed.
  bool at_linear_limit() const { return linear_failures_ > allowed_failures_; }
  /// The first linear solve that needs all its iterations fails the step, not only the second: one bad linear solve may
  /// be a way to a better place.
  void fail_at_linear_limit() { allowed_failures_ = 0; }
  /// The most that one linear solve has taken.
  int most_linear_iterations() const { return most_linear_iterations_; }
  const NewtonIteration& last() const { return last_; }

 private:
  bool judge(double before, double floor) const;
  double next_forcing(double before) const;

  const deck::Solver& settings_;
  Observer& observer_;
  NewtonIteration last_;
  bool converged_ = false;
  double forcing_ = 0;
  int most_linear_iterations_ = 0, linear_failures_ = 0, allowed_failures_ = 1;
};

}  // namespace perinox::equilibrium
