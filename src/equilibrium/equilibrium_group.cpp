#include "equilibrium_group.hpp"

#include <Thyra_TpetraThyraWrappers.hpp>
#include <Tpetra_Vector.hpp>

#include "perinox/core/tpetra.hpp"

namespace perinox::equilibrium {

namespace {

using Converter = Thyra::TpetraOperatorVectorExtraction<double, LocalIndex, GlobalId>;

Teuchos::RCP<NOX::Thyra::Vector> vector_of(const Teuchos::RCP<const tpetra::Map>& map) {
  const auto space = Thyra::createVectorSpace<double, LocalIndex, GlobalId>(map);
  const auto values = Teuchos::rcp(new tpetra::Vector(map));
  return Teuchos::rcp(
      new NOX::Thyra::Vector(Teuchos::RCP<Thyra::VectorBase<double>>(Thyra::createVector(values, space))));
}

void write(const std::vector<double>& values, NOX::Thyra::Vector& to) {
  const auto view = Converter::getTpetraVector(to.getThyraRCPVector())->getLocalViewHost(Tpetra::Access::OverwriteAll);
  for (std::size_t u = 0; u < values.size(); ++u) view(u, 0) = values[u];
}

std::vector<double> read(const NOX::Thyra::Vector& from) {
  const auto vector = Converter::getConstTpetraVector(Teuchos::rcpFromRef(from.getThyraVector()));
  const auto view = vector->getLocalViewHost(Tpetra::Access::ReadOnly);
  return std::vector<double>(view.data(), view.data() + view.extent(0));
}

}  // namespace

EquilibriumGroup::EquilibriumGroup(EquilibriumSolve& solve, const medium::Displacement& x)
    : solve_(solve),
      x_(vector_of(solve.model.system().map())),
      f_(vector_of(solve.model.system().map())),
      newton_(vector_of(solve.model.system().map())),
      displacement_(x) {
  write(x.values(), *x_);
}

NOX::Abstract::Group& EquilibriumGroup::operator=(const NOX::Abstract::Group& source) {
  const auto& from = dynamic_cast<const EquilibriumGroup&>(source);
  if (&from == this) return *this;
  *x_ = *from.x_;
  *f_ = *from.f_;
  *newton_ = *from.newton_;
  displacement_ = from.displacement_;
  norm_ = from.norm_;
  has_f_ = from.has_f_;
  has_jacobian_ = from.has_jacobian_;
  has_newton_ = from.has_newton_;
  return *this;
}

void EquilibriumGroup::take_displacement() {
  displacement_.change() = read(*x_);
  has_f_ = has_jacobian_ = has_newton_ = false;
}

void EquilibriumGroup::setX(const NOX::Abstract::Vector& x) {
  *x_ = x;
  take_displacement();
}

void EquilibriumGroup::computeX(const NOX::Abstract::Group& from, const NOX::Abstract::Vector& direction, double step) {
  x_->update(1.0, from.getX(), step, direction);
  take_displacement();
}

NOX::Abstract::Group::ReturnType EquilibriumGroup::computeF() {
  if (has_f_) return Ok;
  solve_.model.evaluate(at());
  std::vector<double> f = solve_.model.out_of_balance();
  for (double& value : f) value = -value;
  write(f, *f_);
  norm_ = f_->norm();
  has_f_ = true;
  return Ok;
}

// The system keeps one linearisation: that of the group that was asked for it last.
NOX::Abstract::Group::ReturnType EquilibriumGroup::computeJacobian() {
  if (has_jacobian_) return Ok;
  const linear::LinearOutcome outcome = solve_.model.linearise(at());
  if (!outcome.converged) throw LinearFailure(outcome);
  has_jacobian_ = true;
  return Ok;
}

NOX::Abstract::Group::ReturnType EquilibriumGroup::computeNewton(Teuchos::ParameterList&) {
  if (has_newton_) return Ok;
  solve_.forcing = solve_.progress.forcing();
  std::vector<double> right = f_values(), left;
  for (double& value : right) value = -value;
  const linear::LinearOutcome outcome = solve_.linear.solve(solve_.model.system(), right, solve_.forcing, left);
  solve_.linear_iterations = outcome.iterations;
  solve_.all_iterations += outcome.iterations;
  if (!outcome.converged && outcome.failure != linear::Failure::linear_iterations) throw LinearFailure(outcome);
  write(left, *newton_);
  has_newton_ = true;
  return outcome.converged ? Ok : NotConverged;
}

Teuchos::RCP<NOX::Abstract::Group> EquilibriumGroup::clone(NOX::CopyType type) const {
  auto copy = Teuchos::rcp(new EquilibriumGroup(solve_, displacement_));
  if (type == NOX::DeepCopy) copy->operator=(static_cast<const NOX::Abstract::Group&>(*this));
  return copy;
}

std::vector<double> EquilibriumGroup::f_values() const { return read(*f_); }

}  // namespace perinox::equilibrium
