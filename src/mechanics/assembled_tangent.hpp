#pragma once
#include <cstdint>
#include <vector>

#include "perinox/core/tpetra.hpp"
#include "stored_tangent.hpp"

namespace perinox::mechanics {

/// The tangent as a sparse matrix of dimension x dimension blocks: particle a is coupled to every particle that shares
/// a family with it. The pattern is built once; fill() only writes values. Rows and columns of prescribed unknowns are
/// replaced by a diagonal.
class AssembledTangent {
 public:
  /// prescribed: [local * dimension], ghosts up to date. Collective.
  AssembledTangent(const Scene& scene, const std::vector<char>& prescribed);

  /// Values of K at the tangent's state; `prescribed_diagonal` on the diagonal of prescribed unknowns. Collective.
  void fill(const StoredTangent& tangent, double prescribed_diagonal);

  Teuchos::RCP<tpetra::Matrix> matrix() const { return matrix_; }
  /// Stored entries over all ranks.
  long long nonzeros() const;

 private:
  void build_pattern();
  template <int d>
  void fill_rows(const StoredTangent& tangent, double prescribed_diagonal, double* values) const;

  const Scene& scene_;
  std::vector<char> prescribed_;
  // Block pattern over local rows (owned, then ghosts): what this rank's own families contribute.
  std::vector<std::size_t> row_begin_;       ///< [local + 1]
  std::vector<LocalIndex> column_;           ///< ascending within a row
  std::vector<std::size_t> touching_begin_;  ///< [local + 1]
  /// Families that contain particle a: (centre, place in its family; -1: a is the centre).
  struct Touch {
    LocalIndex centre;
    int place;
  };
  std::vector<Touch> touching_;

  Teuchos::RCP<tpetra::Matrix> contributions_;  ///< rows of owned and ghost particles
  Teuchos::RCP<tpetra::Matrix> matrix_;         ///< rows of owned particles; the same object on one rank
  Teuchos::RCP<const tpetra::Export> to_owners_;
};

}  // namespace perinox::mechanics
