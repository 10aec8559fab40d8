#include "perinox/linear/tangent_operators.hpp"

#include <Ifpack2_Factory.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include "block_jacobi.hpp"
#include "chebyshev_acceleration.hpp"
#include "direct_solve.hpp"
#include "masked_tangent.hpp"
#include "perinox/linear/coarse_spacing.hpp"
#include "timed_operator.hpp"
#include "two_level.hpp"

namespace perinox::linear {

/// An Ifpack2 preconditioner of the assembled matrix.
struct TangentSystem::Sparse {
  Teuchos::RCP<Ifpack2::Preconditioner<double, LocalIndex, GlobalId>> preconditioner;
  bool initialised = false;
};

namespace {

std::string name_of(deck::Preconditioner kind) {
  switch (kind) {
    case deck::Preconditioner::none:
      return "none";
    case deck::Preconditioner::two_level:
      return "two-level";
    case deck::Preconditioner::block_jacobi:
      return "block-jacobi";
    case deck::Preconditioner::jacobi:
      return "jacobi";
    case deck::Preconditioner::symmetric_gauss_seidel:
      return "symmetric-gauss-seidel";
    case deck::Preconditioner::chebyshev:
      return "chebyshev";
    case deck::Preconditioner::ilu:
      return "ilu";
    case deck::Preconditioner::automatic:
      break;
  }
  return "automatic";
}

Teuchos::RCP<Ifpack2::Preconditioner<double, LocalIndex, GlobalId>> make_sparse(
    deck::Preconditioner kind, const Teuchos::RCP<tpetra::Matrix>& matrix) {
  std::string type = "RELAXATION";
  Teuchos::ParameterList parameters;
  if (kind == deck::Preconditioner::jacobi) {
    parameters.set("relaxation: type", "Jacobi");
  } else if (kind == deck::Preconditioner::symmetric_gauss_seidel) {
    parameters.set("relaxation: type", "Symmetric Gauss-Seidel");
  } else if (kind == deck::Preconditioner::chebyshev) {
    type = "CHEBYSHEV";
    parameters.set("chebyshev: degree", 3);
    parameters.set("chebyshev: ratio eigenvalue", 30.0);
  } else {
    type = "SCHWARZ";  // additive Schwarz without overlap keeps ILU(0) of a symmetric matrix symmetric
    parameters.set("schwarz: overlap level", 0);
    parameters.set("schwarz: inner preconditioner name", "RILUK");
    parameters.sublist("schwarz: inner preconditioner parameters").set("fact: iluk level-of-fill", 0.0);
  }
  auto made = Ifpack2::Factory::create<Tpetra::RowMatrix<double, LocalIndex, GlobalId>>(type, matrix);
  made->setParameters(parameters);
  return made;
}

}  // namespace

TangentSystem::TangentSystem(medium::Medium& medium, const std::vector<char>& prescribed, const deck::Solver& solver)
    : model_(medium.model()),
      prescribed_(prescribed),
      solver_(solver),
      map_(medium::unknowns_map(model_.body())),
      blocks_(model_.owned_unknowns() * static_cast<std::size_t>(model_.dimension())) {
  bonds_broken_ = model_.body().communicator.sum(model_.bonds_gone());
  Profile& profile = model_.body().communicator.profile();
  const bool assembled = solver_.assembled(), coarse = model_.local_elasticity().has_value();
  deck::Preconditioner& kind = solver_.linear.preconditioner;
  if (kind == deck::Preconditioner::automatic)
    kind = assembled                                    ? deck::Preconditioner::symmetric_gauss_seidel
           : coarse && TwoLevel::worth_its_cost(model_) ? deck::Preconditioner::two_level
                                                        : deck::Preconditioner::block_jacobi;
  if (assembled) {
    auto sparse = medium.make_sparse_tangent(solver_.form, prescribed_);
    assembled_ = sparse.get();
    tangent_ = std::move(sparse);
  } else {
    tangent_ = medium.make_tangent(solver_.form);
  }
  masked_ = Teuchos::rcp(new MaskedTangent(map_, *tangent_, prescribed_));
  operator_ = masked_;
  if (assembled_) operator_ = Teuchos::rcp(new TimedOperator(assembled_->matrix(), profile, Section::product));
  preconditioner_ = make_preconditioner();
  if (!preconditioner_.is_null())
    preconditioner_ = Teuchos::rcp(new TimedOperator(preconditioner_, profile, Section::preconditioner));
}

/// Null where none is asked for.
Teuchos::RCP<tpetra::Operator> TangentSystem::make_preconditioner() {
  const deck::Preconditioner kind = solver_.linear.preconditioner;
  const Communicator& ranks = model_.body().communicator;
  if (solver_.linear.method == deck::LinearMethod::direct) {
    if (!assembled_) throw std::logic_error("a direct solve without the assembled matrix: the deck refuses it");
    direct_ = Teuchos::rcp(new DirectSolve(assembled_->matrix(), ranks));
    return direct_;
  }
  if (kind == deck::Preconditioner::none) return Teuchos::null;
  if (kind == deck::Preconditioner::block_jacobi) {
    block_jacobi_ = Teuchos::rcp(new BlockJacobi(map_, model_.dimension(), prescribed_));
  } else if (kind == deck::Preconditioner::two_level) {
    if (!model_.local_elasticity())
      throw std::logic_error("a two-level preconditioner of a medium that knows no elastic moduli");
    two_level_ = Teuchos::rcp(new TwoLevel(map_, model_, prescribed_, model_.bond_graph(), {}));
    dilatation_share_ = TwoLevel::dilatation_share(model_);
  } else {
    if (!assembled_)
      throw std::logic_error("a sparse preconditioner without the assembled matrix: the deck refuses it");
    sparse_ = std::make_unique<Sparse>();
    sparse_->preconditioner = make_sparse(kind, assembled_->matrix());
    return sparse_->preconditioner;
  }
  const OwnedOperator& one_step = two_level_ ? static_cast<const OwnedOperator&>(*two_level_) : *block_jacobi_;
  const int steps = solver_.linear.chebyshev_steps > 0 ? solver_.linear.chebyshev_steps
                    : two_level_                       ? chebyshev_steps(model_)
                                                       : 1;
  if (steps > 1) {
    accelerated_ = Teuchos::rcp(new ChebyshevAcceleration(map_, model_.body(), prescribed_, *masked_, one_step, steps));
    return accelerated_;
  }
  if (two_level_) return two_level_;
  return block_jacobi_;
}

TangentSystem::~TangentSystem() = default;

bool TangentSystem::symmetric() const { return model_.symmetric(); }
std::string TangentSystem::preconditioner_name() const {
  if (direct_) return "direct";
  return name_of(solver_.linear.preconditioner);
}

void TangentSystem::update(const medium::At& at) {
  Profile& profile = model_.body().communicator.profile();
  const Profile::Scope timed(profile, Section::linearise);
  if (!tangent_->linearise(at)) return;
  preconditioner_current_ = false;
  tangent_->diagonal_blocks(blocks_.data());
  const int d = model_.dimension();
  double square = 0, count = 0;
  for (std::size_t u = 0; u < model_.owned_unknowns(); ++u) {
    if (prescribed_[u]) continue;
    const double value = blocks_[u * d + u % d];
    square += value * value;
    count += 1;
  }
  std::vector<double> sums{square, count};
  model_.body().communicator.sum(sums);
  stiffness_scale_ = sums[1] > 0 && sums[0] > 0 ? std::sqrt(sums[0] / sums[1]) : 1;
  masked_->diagonal = stiffness_scale_;
  if (dilatation_share_ != 1) tangent_->diagonal_blocks(blocks_.data(), dilatation_share_);
  if (!assembled_) return;
  const Profile::Scope filling(profile, Section::assembly);
  assembled_->fill(stiffness_scale_);
}

void TangentSystem::shift(double share) { masked_->shift = share; }

void TangentSystem::save(StateWriter& writer) const {
  writer.number("tangent/stiffness_scale", stiffness_scale_);
  writer.integer("tangent/bonds_broken", bonds_broken_);
  if (two_level_) two_level_->save(writer);
  if (!accelerated_) return;
  writer.number("tangent/lowest_eigenvalue", accelerated_->interval().lowest);
  writer.number("tangent/highest_eigenvalue", accelerated_->interval().highest);
}

void TangentSystem::restore(StateReader& reader) {
  stiffness_scale_ = reader.number("tangent/stiffness_scale");
  if (two_level_) two_level_->restore(reader);
  if (accelerated_ && reader.has("tangent/highest_eigenvalue"))
    accelerated_->set_interval(
        {reader.number("tangent/lowest_eigenvalue"), reader.number("tangent/highest_eigenvalue")});
}

void TangentSystem::update_preconditioner() {
  if (preconditioner_current_) return;
  preconditioner_current_ = true;
  const Profile::Scope timed(model_.body().communicator.profile(), Section::preconditioner);
  if (direct_) direct_->factorise();
  if (block_jacobi_) block_jacobi_->set(blocks_, stiffness_scale_);
  const bool renewed = two_level_ && two_level_->set(blocks_, stiffness_scale_, tangent_->shear_left());
  if (accelerated_ && (renewed || accelerated_->interval().highest == 0)) accelerated_->estimate();
  if (!sparse_) return;
  if (!sparse_->initialised) sparse_->preconditioner->initialize();
  sparse_->initialised = true;
  // Estimates of eigenvalues start from random vectors, and Tpetra's go on from the C library's random numbers: from
  // here they are the same in every call, whatever came before.
  std::srand(1);
  sparse_->preconditioner->compute();
}

}  // namespace perinox::linear
