#include "equilibrium_model.hpp"

#include <Thyra_TpetraLinearOp.hpp>
#include <algorithm>
#include <cmath>
#include <limits>

#include "perinox/body/extent.hpp"
#include "perinox/core/sentence.hpp"

namespace perinox::equilibrium {

namespace {
using Converter = Thyra::TpetraOperatorVectorExtraction<double, LocalIndex, GlobalId>;
}

EquilibriumModel::EquilibriumModel(const mechanics::Scene& scene, const loads::Boundary& boundary,
                                   linear::TangentSystem& system, const deck::Newton& settings)
    : scene_(scene),
      boundary_(boundary),
      system_(system),
      settings_(settings),
      reach_(body::diagonal(scene.body()) * std::sqrt(static_cast<double>(scene.body().total))),
      space_(Thyra::createVectorSpace<double, LocalIndex, GlobalId>(system.map())),
      force_(scene.owned_unknowns()) {}

void EquilibriumModel::set_step(const mechanics::Committed& committed, const std::vector<double>& external, double t) {
  committed_ = &committed;
  external_ = &external;
  t_ = t;
  evaluated_ = false;
  double square = 0;
  for (std::size_t u = 0; u < force_.size(); ++u)
    if (!loose(u)) square += committed.displacement()[u] * committed.displacement()[u];
  start_ = std::sqrt(scene_.body().communicator.sum(square));
}

bool EquilibriumModel::loose(std::size_t u) const {
  return !boundary_.loose().empty() && boundary_.loose()[u / static_cast<std::size_t>(scene_.dimension())] != 0;
}

const ForceBalance& EquilibriumModel::evaluate(const double* displacement) const {
  // NOX, the status test and the predictor ask at the same point in turn: answer from the last evaluation.
  const bool same = evaluated_ && std::equal(displacement, displacement + force_.size(), trial_.displacement.begin());
  if (!scene_.body().communicator.any(!same)) return balance_;
  evaluated_ = true;
  {
    const Profile::Scope timed(scene_.body().communicator.profile(), Section::force);
    mechanics::internal_force(scene_, *committed_, displacement, trial_, force_.data());
  }
  trial_.t = t_;
  std::vector<double> squares(4, 0.0);
  for (std::size_t u = 0; u < force_.size(); ++u) {
    if (loose(u)) continue;
    const double sum = force_[u] + (*external_)[u];
    squares[boundary_.prescribed()[u] ? 1 : 0] += sum * sum;
    squares[2] += (*external_)[u] * (*external_)[u];
    squares[3] += displacement[u] * displacement[u];
  }
  scene_.body().communicator.sum(squares);
  balance_ = {std::sqrt(squares[0]), std::sqrt(squares[1]), std::sqrt(squares[2]), std::sqrt(squares[3]), true};
  balance_.finite = std::isfinite(squares[0] + squares[1] + squares[3]);
  return balance_;
}

std::string EquilibriumModel::not_finite() const {
  const std::string mine = mechanics::first_not_finite(scene_, trial_, force_.data());
  const std::string text = first_sentence(scene_.body().communicator, mine);
  return text.empty() ? "the force balance is not finite" : text;
}

double EquilibriumModel::rounding_floor() const {
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  const double displacement = std::min(std::max(balance_.displacement, start_), reach_);
  return 64 * epsilon * system_.stiffness_scale() * std::max(displacement, epsilon * reach_);
}

double EquilibriumModel::relative_residual() const {
  if (balance_.residual == 0) return 0;
  const double scale = std::max({balance_.reaction, balance_.external, rounding_floor() / settings_.tolerance});
  return scale > 0 ? balance_.residual / scale : std::numeric_limits<double>::infinity();
}

Thyra::ModelEvaluatorBase::InArgs<double> EquilibriumModel::createInArgs() const {
  Thyra::ModelEvaluatorBase::InArgsSetup<double> in;
  in.setModelEvalDescription("perinox force balance");
  in.setSupports(Thyra::ModelEvaluatorBase::IN_ARG_x);
  return std::move(in);
}

Thyra::ModelEvaluatorBase::OutArgs<double> EquilibriumModel::createOutArgsImpl() const {
  Thyra::ModelEvaluatorBase::OutArgsSetup<double> out;
  out.setModelEvalDescription("perinox force balance");
  out.setSupports(Thyra::ModelEvaluatorBase::OUT_ARG_f);
  out.setSupports(Thyra::ModelEvaluatorBase::OUT_ARG_W_op);
  out.setSupports(Thyra::ModelEvaluatorBase::OUT_ARG_W_prec);
  return std::move(out);
}

Teuchos::RCP<Thyra::LinearOpBase<double>> EquilibriumModel::create_W_op() const {
  return Thyra::createLinearOp<double, LocalIndex, GlobalId>(system_.linear_operator());
}

Teuchos::RCP<Thyra::PreconditionerBase<double>> EquilibriumModel::create_W_prec() const {
  if (system_.preconditioner().is_null()) return Teuchos::null;
  const auto op = Thyra::createLinearOp<double, LocalIndex, GlobalId>(system_.preconditioner());
  return Teuchos::rcp(new Thyra::DefaultPreconditioner<double>(op));
}

void EquilibriumModel::evalModelImpl(const Thyra::ModelEvaluatorBase::InArgs<double>& in,
                                     const Thyra::ModelEvaluatorBase::OutArgs<double>& out) const {
  const auto x = Converter::getConstTpetraVector(in.get_x());
  const auto displacement = x->getLocalViewHost(Tpetra::Access::ReadOnly);
  if (const auto f = out.get_f(); !f.is_null()) {
    evaluate(displacement.data());
    const auto residual = Converter::getTpetraVector(f)->getLocalViewHost(Tpetra::Access::OverwriteAll);
    for (std::size_t u = 0; u < force_.size(); ++u)
      residual(u, 0) = boundary_.prescribed()[u] ? 0 : -(force_[u] + (*external_)[u]);
  }
  // NOX asks for W_op first and for W_prec at the same x afterwards.
  if (!out.get_W_op().is_null()) system_.update(*committed_, displacement.data());
  if (!out.get_W_prec().is_null()) system_.update_preconditioner();
}

}  // namespace perinox::equilibrium
