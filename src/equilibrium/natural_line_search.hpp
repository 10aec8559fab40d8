#pragma once
#include <NOX_LineSearch_Generic.H>
#include <NOX_LineSearch_UserDefinedFactory.H>

#include "equilibrium_group.hpp"

namespace perinox::equilibrium {

/// Shortens Newton's step until it makes progress, by either of two measures: the residual falls, or the next
/// correction, found with the tangent at hand, is shorter than the step (P. Deuflhard, Newton Methods for Nonlinear
/// Problems, 2004, section 3.3: the natural monotonicity test). The second lets through the full steps of bodies that
/// turn or bend, where the residual must rise first: a rotation found linearly stretches, and stretching is stiff.
/// It costs a linear solve to a tenth, and only where the residual has risen. Collective.
class NaturalLineSearch : public NOX::LineSearch::Generic {
 public:
  /// reach: no step is longer (2-norm of the displacement).
  NaturalLineSearch(EquilibriumSolve& solve, double reach) : solve_(solve), reach_(reach) {}

  bool compute(NOX::Abstract::Group& trial, double& step, const NOX::Abstract::Vector& direction,
               const NOX::Solver::Generic& solver) override;
  /// Of all its linear solves.
  int linear_iterations() const { return linear_iterations_; }

 private:
  /// 2-norm of the next correction over the free unknowns; infinite where the linear solve fails.
  double next_correction(const NOX::Abstract::Group& trial);

  EquilibriumSolve& solve_;
  double reach_;
  int linear_iterations_ = 0;
};

/// Hands NOX a line search that is there already.
class GivenLineSearch : public NOX::LineSearch::UserDefinedFactory {
 public:
  explicit GivenLineSearch(Teuchos::RCP<NOX::LineSearch::Generic> search) : search_(std::move(search)) {}
  Teuchos::RCP<NOX::LineSearch::Generic> buildLineSearch(const Teuchos::RCP<NOX::GlobalData>&,
                                                         Teuchos::ParameterList&) const override {
    return search_;
  }

 private:
  Teuchos::RCP<NOX::LineSearch::Generic> search_;
};

}  // namespace perinox::equilibrium
