#include "perinox/mechanics/peridynamic_medium.hpp"

#include <optional>

#include "assembled_tangent.hpp"
#include "path_work.hpp"
#include "perinox/core/profile.hpp"
#include "perinox/mechanics/internal_force.hpp"
#include "perinox/mechanics/tangent.hpp"
#include "stored_tangent.hpp"

namespace perinox::mechanics {

namespace {

/// A tangent of the scene as seen from the medium's committed state.
template <class Interface, class Kind>
class Linearised : public Interface {
 public:
  Linearised(const Committed& committed, std::unique_ptr<Kind> tangent, deck::TangentForm form)
      : committed_(committed), tangent_(std::move(tangent)), form_(form) {}
  bool linearise(const medium::At& at) override { return tangent_->linearise(committed_, at, form_); }
  void apply(const double* x, double* y) const override { tangent_->apply(x, y); }
  void diagonal_blocks(double* blocks, double dilatation) const override {
    tangent_->diagonal_blocks(blocks, dilatation);
  }
  const std::vector<double>& shear_left() const override { return tangent_->shear_left(); }

 protected:
  const Kind& tangent() const { return *tangent_; }

 private:
  const Committed& committed_;
  std::unique_ptr<Kind> tangent_;
  deck::TangentForm form_;
};

using MediumTangent = Linearised<medium::Tangent, mechanics::Tangent>;

class MediumMatrix : public Linearised<medium::SparseTangent, StoredTangent> {
 public:
  MediumMatrix(const Scene& scene, const Committed& committed, deck::TangentForm form,
               const std::vector<char>& prescribed)
      : Linearised(committed, std::make_unique<StoredTangent>(scene), form), assembled_(scene, prescribed) {}
  void fill(double prescribed_diagonal) override { assembled_.fill(tangent(), prescribed_diagonal); }
  Teuchos::RCP<tpetra::Matrix> matrix() const override { return assembled_.matrix(); }

 private:
  AssembledTangent assembled_;
};

}  // namespace

PeridynamicMedium::PeridynamicMedium(Scene& scene, const std::vector<std::string>& fields)
    : scene_(scene),
      evaluation_(std::make_shared<Evaluation>(scene)),
      committed_(scene),
      dilatation_(static_cast<std::size_t>(scene.owned()), 0.0),
      stored_energy_(static_cast<std::size_t>(scene.owned()), 0.0),
      fields_(scene, fields) {}

void PeridynamicMedium::evaluate(double t, const medium::At& at, double* force) {
  const Profile::Scope timed(scene_.body().communicator.profile(), Section::force);
  internal_force(*evaluation_, committed_, at, trial_, force);
  trial_.t = t;
}

std::string PeridynamicMedium::first_not_finite(const double* force) const {
  return mechanics::first_not_finite(scene_, trial_, force);
}

double PeridynamicMedium::commit(bool followed) {
  std::optional<PathWork> path;
  if (followed) path.emplace(*evaluation_, committed_, trial_);
  std::swap(dilatation_, trial_.dilatation);
  std::swap(stored_energy_, trial_.stored_energy);
  committed_.advance(*evaluation_, std::move(trial_));
  return path ? path->beyond_chord(*evaluation_, committed_) : 0;
}

std::unique_ptr<medium::Tangent> PeridynamicMedium::make_tangent(deck::TangentForm form) {
  return std::make_unique<MediumTangent>(committed_, mechanics::make_tangent(scene_, form, evaluation_), form);
}

std::unique_ptr<medium::SparseTangent> PeridynamicMedium::make_sparse_tangent(deck::TangentForm form,
                                                                              const std::vector<char>& prescribed) {
  return std::make_unique<MediumMatrix>(scene_, committed_, form, prescribed);
}

std::vector<Field> PeridynamicMedium::fields(bool written) {
  return fields_.of(committed_, dilatation_, stored_energy_, written);
}

void PeridynamicMedium::save(StateWriter& writer) const { committed_.save(scene_, writer); }

void PeridynamicMedium::save_fields(StateWriter& writer) const {
  writer.particles("stepper/dilatation", dilatation_.data(), 1);
  writer.particles("stepper/stored_energy_density", stored_energy_.data(), 1);
}

void PeridynamicMedium::restore(StateReader& reader) {
  dilatation_ = reader.particles("stepper/dilatation", 1);
  stored_energy_ = reader.particles("stepper/stored_energy_density", 1);
  committed_.restore(*evaluation_, reader);
}

}  // namespace perinox::mechanics
