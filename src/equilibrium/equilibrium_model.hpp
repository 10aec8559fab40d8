#pragma once
/// The force balance as a Thyra model for NOX: F(u) = -(internal + external force) on free unknowns, zero on prescribed
/// ones; its Jacobian is the tangent. A heavy header: only the Newton room's own translation units include it.
#include <Thyra_DefaultPreconditioner.hpp>
#include <Thyra_StateFuncModelEvaluatorBase.hpp>
#include <Thyra_TpetraThyraWrappers.hpp>
#include <Tpetra_Vector.hpp>
#include <string>

#include "perinox/equilibrium/newton.hpp"

namespace perinox::equilibrium {

class EquilibriumModel : public Thyra::StateFuncModelEvaluatorBase<double> {
 public:
  /// settings: of Newton's method; alive as long as the model.
  EquilibriumModel(const mechanics::Scene& scene, const loads::Boundary& boundary, linear::TangentSystem& system,
                   const deck::Newton& settings);

  /// The step to be solved: committed state and external force [owned * dimension] stay alive until the next call.
  void set_step(const mechanics::Committed& committed, const std::vector<double>& external, double t);

  /// Internal force and balance at displacement [owned * dimension]; the trial state is kept.
  const ForceBalance& evaluate(const double* displacement) const;
  const ForceBalance& balance() const { return balance_; }
  const std::vector<double>& force() const { return force_; }
  mechanics::Trial& trial() { return trial_; }
  /// Names the first particle with a force that is not finite, on any rank. Collective.
  std::string not_finite() const;
  /// Element-wise sums over the ranks, in place.
  void sum(std::vector<double>& values) const { scene_.body().communicator.sum(values); }
  /// Residual below which nothing but rounding is left: force. The displacement that it goes with is the larger one of
  /// the step's start and of the point last evaluated: on the way to no load at all the reactions vanish with the
  /// displacement, and rounding is that of the way. A displacement larger than the body does not raise it: a body that
  /// runs away is in no equilibrium. One that is smaller than rounding of the body's size to the square is none.
  double rounding_floor() const;
  /// Residual of the last evaluation over what it is judged against: the largest of reaction, external force, and the
  /// force that Newton's tolerance makes the rounding floor of. 0 where there is no residual.
  double relative_residual() const;
  /// 2-norm of a displacement of the body's own size; a step beyond it makes no sense.
  double reach() const { return reach_; }

  Teuchos::RCP<const Thyra::VectorSpaceBase<double>> get_x_space() const override { return space_; }
  Teuchos::RCP<const Thyra::VectorSpaceBase<double>> get_f_space() const override { return space_; }
  Thyra::ModelEvaluatorBase::InArgs<double> getNominalValues() const override { return createInArgs(); }
  Thyra::ModelEvaluatorBase::InArgs<double> createInArgs() const override;
  Teuchos::RCP<Thyra::LinearOpBase<double>> create_W_op() const override;
  Teuchos::RCP<Thyra::PreconditionerBase<double>> create_W_prec() const override;

 private:
  Thyra::ModelEvaluatorBase::OutArgs<double> createOutArgsImpl() const override;
  void evalModelImpl(const Thyra::ModelEvaluatorBase::InArgs<double>& in,
                     const Thyra::ModelEvaluatorBase::OutArgs<double>& out) const override;
  bool loose(std::size_t u) const;

  const mechanics::Scene& scene_;
  const loads::Boundary& boundary_;
  linear::TangentSystem& system_;
  const deck::Newton& settings_;
  double start_ = 0;  ///< 2-norm of the displacement that the step starts from
  double reach_;      ///< 2-norm of a displacement of the body's own size
  Teuchos::RCP<const Thyra::VectorSpaceBase<double>> space_;
  const mechanics::Committed* committed_ = nullptr;
  const std::vector<double>* external_ = nullptr;
  double t_ = 0;
  // The last evaluation. Thyra's evalModel is const; NOX, the status test and the predictor share its result.
  mutable bool evaluated_ = false;
  mutable mechanics::Trial trial_;
  mutable std::vector<double> force_;
  mutable ForceBalance balance_;
};

}  // namespace perinox::equilibrium
