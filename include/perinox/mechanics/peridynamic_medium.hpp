#pragma once
#include <memory>
#include <string>
#include <vector>

#include "perinox/mechanics/evaluation.hpp"
#include "perinox/mechanics/point_fields.hpp"
#include "perinox/medium/medium.hpp"

namespace perinox::mechanics {

/// A peridynamic scene with its state. Who breaks bonds or goes on in time works on the parts that are shown here.
class PeridynamicMedium : public medium::Medium {
 public:
  /// The undeformed body. fields: names that fields() is asked for. The scene is kept by reference.
  explicit PeridynamicMedium(Scene& scene, const std::vector<std::string>& fields = {});

  Scene& scene() { return scene_; }
  /// Shared with whoever evaluates the scene at the same states.
  const std::shared_ptr<Evaluation>& evaluation() { return evaluation_; }
  const Committed& committed() const { return committed_; }
  /// To be taken by who goes on in time and to be given back.
  Committed& committed() { return committed_; }

  const Scene& model() const override { return scene_; }
  double t() const override { return committed_.t(); }
  const std::vector<double>& displacement() const override { return committed_.displacement(); }
  medium::At at() const override { return committed_.at(); }
  void evaluate(double t, const medium::At& at, double* force) override;
  const Trial& trial() const override { return trial_; }
  std::string first_not_finite(const double* force) const override;
  double commit(bool followed) override;
  std::unique_ptr<medium::Tangent> make_tangent(deck::TangentForm form) override;
  std::unique_ptr<medium::SparseTangent> make_sparse_tangent(deck::TangentForm form,
                                                             const std::vector<char>& prescribed) override;
  std::vector<Field> fields(bool written) override;
  bool has_flowed(LocalIndex i) const override { return fields_.has_flowed(i); }
  void save(StateWriter& writer) const override;
  void save_fields(StateWriter& writer) const override;
  void restore(StateReader& reader) override;

 private:
  Scene& scene_;
  std::shared_ptr<Evaluation> evaluation_;
  Committed committed_;
  Trial trial_;
  std::vector<double> dilatation_, stored_energy_;  ///< [owned] of the committed state
  PointFields fields_;
};

}  // namespace perinox::mechanics
