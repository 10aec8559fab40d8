#pragma once
#include <cstddef>
#include <memory>
#include <vector>

#include "perinox/mechanics/state.hpp"

namespace perinox::mechanics {

/// The tangent stiffness K = -df/du at one state, as an operator. Symmetric where the materials' modulus states are.
class Tangent {
 public:
  explicit Tangent(const Scene& scene) : scene_(scene) {}
  virtual ~Tangent() = default;

  /// Linearises at a displacement [owned * dimension] as seen from the committed state. False if this is known to be
  /// the tangent of the last call, as for an elastic body of bonds that keep their direction. Collective.
  virtual bool linearise(const Committed& committed, const medium::At& at, deck::TangentForm form) = 0;
  /// y = K x for owned unknowns; x, y: [owned * dimension]. Collective.
  virtual void apply(const double* x, double* y) const = 0;
  /// The dimension x dimension diagonal block of every owned particle, row-major: [owned * dimension^2]. The stiffness
  /// against dilatation counts `dilatation` times. Collective.
  virtual void diagonal_blocks(double* blocks, double dilatation = 1) const = 0;
  /// What the linearisation has left of every particle's elastic shear modulus, a mean over directions: 1 where nothing
  /// yields. [owned], or empty where no particle has less than 1 or nothing is known.
  virtual const std::vector<double>& shear_left() const;
  /// Bytes held by the linearisation on this rank.
  virtual std::size_t bytes() const = 0;

  const Scene& scene() const { return scene_; }

 protected:
  const Scene& scene_;
};

/// The tangent for the matrix-free product where there is one (the consistent form, materials made of sums), else the
/// stored one.
/// evaluation: of the scene, shared with whoever asks for the internal force at the same states; null: its own.
std::unique_ptr<Tangent> make_tangent(const Scene& scene, deck::TangentForm form,
                                      std::shared_ptr<Evaluation> evaluation = nullptr);

}  // namespace perinox::mechanics
