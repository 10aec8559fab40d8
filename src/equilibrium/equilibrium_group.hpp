#pragma once
/// The force balance as NOX sees it. A heavy header: only the sources around NOX include it.
#include <NOX_Abstract_Group.H>
#include <NOX_Thyra_Vector.H>

#include <memory>
#include <stdexcept>
#include <vector>

#include "equilibrium_model.hpp"
#include "newton_progress.hpp"

namespace perinox::equilibrium {

/// What the groups of one solve share.
struct EquilibriumSolve {
  EquilibriumModel& model;
  const linear::LinearSolver& linear;
  NewtonProgress& progress;   ///< which says how exactly a linear solve has to be
  int linear_iterations = 0;  ///< of the last direction
  double forcing = 0;         ///< tolerance that the last direction was solved to
  int all_iterations = 0;     ///< of all directions
};

/// A linear solve that gives no direction at all: NOX would go on with what it has.
class LinearFailure : public std::runtime_error {
 public:
  explicit LinearFailure(const linear::LinearOutcome& outcome)
      : std::runtime_error(outcome.reason), failure(outcome.failure) {}
  linear::Failure failure;
};

/// A point of Newton's iteration: displacement, F(u) = -(internal + external force) on the free unknowns and zero on
/// the prescribed ones, and Newton's direction. The displacement carries the number of its state, so that nothing is
/// evaluated twice. Gradients and other products with the Jacobian are not defined.
class EquilibriumGroup : public NOX::Abstract::Group {
 public:
  /// x: [owned unknowns]. solve: kept by reference.
  EquilibriumGroup(EquilibriumSolve& solve, const medium::Displacement& x);

  NOX::Abstract::Group& operator=(const NOX::Abstract::Group& source) override;
  void setX(const NOX::Abstract::Vector& x) override;
  void computeX(const NOX::Abstract::Group& from, const NOX::Abstract::Vector& direction, double step) override;
  ReturnType computeF() override;
  ReturnType computeJacobian() override;
  /// Solves to the tolerance that the progress asks for. A direction that is not solved that far is NotConverged;
  /// throws LinearFailure where there is none.
  ReturnType computeNewton(Teuchos::ParameterList&) override;

  bool isF() const override { return has_f_; }
  bool isJacobian() const override { return has_jacobian_; }
  bool isNewton() const override { return has_newton_; }
  const NOX::Abstract::Vector& getX() const override { return *x_; }
  const NOX::Abstract::Vector& getF() const override { return *f_; }
  const NOX::Abstract::Vector& getNewton() const override { return *newton_; }
  double getNormF() const override { return norm_; }
  Teuchos::RCP<const NOX::Abstract::Vector> getXPtr() const override { return x_; }
  Teuchos::RCP<const NOX::Abstract::Vector> getFPtr() const override { return f_; }
  Teuchos::RCP<const NOX::Abstract::Vector> getNewtonPtr() const override { return newton_; }
  Teuchos::RCP<NOX::Abstract::Group> clone(NOX::CopyType type) const override;
  /// Throw std::logic_error: Newton's method needs no gradient.
  const NOX::Abstract::Vector& getGradient() const override { throw std::logic_error("the group has no gradient"); }
  Teuchos::RCP<const NOX::Abstract::Vector> getGradientPtr() const override {
    throw std::logic_error("the group has no gradient");
  }

  /// The displacement with the number of its state.
  medium::At at() const { return displacement_.at(); }
  const std::vector<double>& displacement() const { return displacement_.values(); }
  /// F as plain numbers.
  std::vector<double> f_values() const;

 private:
  void take_displacement();

  EquilibriumSolve& solve_;
  Teuchos::RCP<NOX::Thyra::Vector> x_, f_, newton_;
  medium::Displacement displacement_;
  double norm_ = 0;
  bool has_f_ = false, has_jacobian_ = false, has_newton_ = false;
};

}  // namespace perinox::equilibrium
