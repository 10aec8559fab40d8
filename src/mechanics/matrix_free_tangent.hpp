#pragma once
#include "perinox/mechanics/evaluation.hpp"
#include "perinox/mechanics/tangent.hpp"

namespace perinox::mechanics {

/// The consistent tangent without a word a bond: the displacement, and five coefficients a particle. Directions and
/// force states are recomputed by every product. Linearising at the state of the last internal force costs no sweep.
class MatrixFreeTangent : public Tangent {
 public:
  /// evaluation: as in make_tangent().
  explicit MatrixFreeTangent(const Scene& scene, std::shared_ptr<Evaluation> evaluation = nullptr);

  /// Throws std::logic_error for the printed form, whose third term is none of a point.
  bool linearise(const Committed& committed, const medium::At& at, deck::TangentForm form) override;
  void apply(const double* x, double* y) const override;
  void diagonal_blocks(double* blocks, double dilatation = 1) const override;
  const std::vector<double>& shear_left() const override { return shear_left_; }
  std::size_t bytes() const override;

 private:
  std::shared_ptr<Evaluation> evaluation_;
  std::unique_ptr<FamilyLoops> loops_;
  TangentLaw law_;
  std::vector<double> shear_left_;
  std::shared_ptr<const PlasticExtension> plastic_;
  std::uint64_t bonds_version_ = 0;
  bool linearised_ = false;
};

}  // namespace perinox::mechanics
