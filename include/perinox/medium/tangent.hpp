#pragma once
#include <cstddef>
#include <stdexcept>
#include <vector>

#include "perinox/body/body.hpp"
#include "perinox/core/tpetra.hpp"
#include "perinox/medium/displacement.hpp"

namespace perinox::medium {

/// The tangent stiffness K = -df/du of a medium at one displacement, as an operator.
class Tangent {
 public:
  virtual ~Tangent() = default;

  /// Linearises at a displacement as seen from the medium's committed state. False if this is known to be the tangent
  /// of the last call. Collective.
  virtual bool linearise(const At& at) = 0;
  /// y = K x for owned unknowns; x, y: [owned * dimension]. Collective.
  virtual void apply(const double* x, double* y) const = 0;
  /// y = K^T x. Throws std::logic_error where the medium does not have it. Collective.
  virtual void apply_transposed(const double* /*x*/, double* /*y*/) const {
    throw std::logic_error("this medium has no transposed tangent");
  }
  /// The dimension x dimension diagonal block of every owned particle, row-major: [owned * dimension^2]. Stiffness
  /// against dilatation counts `dilatation` times, where the medium can tell it from the rest. Collective.
  virtual void diagonal_blocks(double* blocks, double dilatation = 1) const = 0;
  /// What is left of every particle's elastic shear modulus. [owned], or empty where nothing is known.
  virtual const std::vector<double>& shear_left() const {
    static const std::vector<double> nothing;
    return nothing;
  }
};

/// A tangent that is also a sparse matrix, in which rows and columns of prescribed unknowns are replaced by a diagonal.
class SparseTangent : public Tangent {
 public:
  /// Writes the values of the last linearise(), and `prescribed_diagonal` for prescribed unknowns. Collective.
  virtual void fill(double prescribed_diagonal) = 0;
  virtual Teuchos::RCP<tpetra::Matrix> matrix() const = 0;
};

/// Map of the owned unknowns: unknown c of particle g has the global number g * dimension + c.
Teuchos::RCP<const tpetra::Map> unknowns_map(const body::Body& body);
/// The same with the unknowns of ghosts, which come after the owned ones.
Teuchos::RCP<const tpetra::Map> local_unknowns_map(const body::Body& body);

}  // namespace perinox::medium
