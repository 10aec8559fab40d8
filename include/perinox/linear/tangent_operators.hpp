#pragma once
#include <memory>
#include <vector>

#include "perinox/core/saved_state.hpp"
#include "perinox/core/tpetra.hpp"
#include "perinox/medium/medium.hpp"

namespace perinox::linear {

class BlockJacobi;
class ChebyshevAcceleration;
class DirectSolve;
class MaskedTangent;
class TwoLevel;

/// The linear system of one medium: the tangent restricted to the free unknowns (prescribed ones carry a diagonal and
/// are coupled to nothing, which keeps it symmetric), as an operator, and its preconditioner. Both are updated in
/// place.
class TangentSystem {
 public:
  /// prescribed: [local * dimension], ghosts up to date. The medium is kept by reference. Collective.
  TangentSystem(medium::Medium& medium, const std::vector<char>& prescribed, const deck::Solver& solver);
  ~TangentSystem();

  /// Linearises at a displacement [owned * dimension] as seen from the medium's committed state. Collective.
  void update(const medium::At& at);
  /// Brings the preconditioner to the tangent of the last update(). The coarse part of two-level is made at the first
  /// call and kept. Collective.
  void update_preconditioner();

  /// The linear operator is K + share * stiffness_scale() on the free unknowns from now on; nothing of it is in the
  /// preconditioner. Not of an assembled tangent.
  void shift(double share);

  /// What the next step would find here of the steps before, and the way back: the scale of stiffness, and what the
  /// coarse part of two-level is made of, which is made again. Collective.
  void save(StateWriter& writer) const;
  void restore(StateReader& reader);

  const medium::Tangent& tangent() const { return *tangent_; }
  Teuchos::RCP<tpetra::Operator> linear_operator() const { return operator_; }
  /// Null if none is asked for.
  Teuchos::RCP<tpetra::Operator> preconditioner() const { return preconditioner_; }
  Teuchos::RCP<const tpetra::Map> map() const { return map_; }
  /// True if conjugate gradients may be used.
  bool symmetric() const;
  /// Root mean square of the diagonal of K over the free unknowns, force a length: the scale of stiffness. Set by
  /// update().
  double stiffness_scale() const { return stiffness_scale_; }
  /// "block-jacobi", ...: what automatic chose.
  std::string preconditioner_name() const;

 private:
  struct Sparse;
  Teuchos::RCP<tpetra::Operator> make_preconditioner();
  const medium::Model& model_;
  std::vector<char> prescribed_;
  deck::Solver solver_;
  std::unique_ptr<medium::Tangent> tangent_;
  Teuchos::RCP<const tpetra::Map> map_;
  medium::SparseTangent* assembled_ = nullptr;  ///< the tangent, if it is a matrix
  Teuchos::RCP<MaskedTangent> masked_;
  Teuchos::RCP<BlockJacobi> block_jacobi_;
  Teuchos::RCP<TwoLevel> two_level_;
  Teuchos::RCP<ChebyshevAcceleration> accelerated_;  ///< of one of the two; null for one step
  std::unique_ptr<Sparse> sparse_;
  Teuchos::RCP<DirectSolve> direct_;
  Teuchos::RCP<tpetra::Operator> operator_, preconditioner_;
  std::vector<double> blocks_;
  double dilatation_share_ = 1;  ///< of the dilatation in blocks_, which only the two-level preconditioner has less of
  double stiffness_scale_ = 0;
  bool preconditioner_current_ = false;
  long long bonds_broken_ = 0;  ///< when this was made, over all ranks: what it knows of cracks
};

}  // namespace perinox::linear
