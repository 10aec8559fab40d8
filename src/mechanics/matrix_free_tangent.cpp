#include "matrix_free_tangent.hpp"

#include <algorithm>
#include <stdexcept>

#include "stored_tangent.hpp"

namespace perinox::mechanics {

namespace {

/// The modulus state is shear (e_d - share q (q . e_d)), q the unit vector along the point's own deviatoric extension.
/// A yielding point loses its stiffness along q only, so the mean over directions counts half of that loss (of 0.4, 0.5
/// and 0.65 half does best in the preconditioner).
double left_of_shear(const materials::FamilySums& sums, const materials::PointModulus& modulus, double elastic_shear) {
  if (modulus.shear <= 0) return 0;
  const double d = sums.dimension, elastic = d * (d + 2) * elastic_shear / sums.deviatoric_volume();
  const double lost = -modulus.flow * sums.square_about(modulus.mean) / modulus.shear;
  return std::min(1.0, modulus.shear / elastic * (1 - std::clamp(lost, 0.0, 1.0) / 2));
}

}  // namespace

const std::vector<double>& Tangent::shear_left() const {
  static const std::vector<double> all;
  return all;
}

MatrixFreeTangent::MatrixFreeTangent(const Scene& scene, std::shared_ptr<Evaluation> evaluation)
    : Tangent(scene),
      evaluation_(evaluation ? std::move(evaluation) : std::make_shared<Evaluation>(scene)),
      loops_(FamilyLoops::make(scene)) {}

bool MatrixFreeTangent::linearise(const Committed& committed, const medium::At& at, deck::TangentForm form) {
  Evaluation& evaluation = *evaluation_;
  evaluation.at(committed, at);
  const auto owned = static_cast<std::size_t>(scene_.owned());
  for (std::vector<double>* values : {&law_.radial, &law_.shear, &law_.mean, &law_.dilatation, &law_.flow})
    values->resize(owned);
  law_.yielded.resize(evaluation.has_back_stress() ? owned : 0);
  shear_left_.clear();
  const bonds::Families& families = scene_.families();
  law_.state.resize(families.moments.size());
  law_.slope.resize(families.moments.size());
  law_.modulus.resize(families.moments.size());
  materials::StrainFit fit;
  std::vector<double> trial;
  // Bonds that keep their direction, in a body where nothing has flowed: nothing of the tangent but its moduli depends
  // on where the body is, and those of an elastic one stay what they are.
  bool same = linearised_ && scene_.small_strain() && bonds_version_ == scene_.bonds_version() && !plastic_->chunks() &&
              !committed.plastic().chunks();
  const auto take = [&same](auto& held, const auto& now) {
    same = same && held == now;
    held = now;
  };
  for (LocalIndex i = 0; i < scene_.owned(); ++i) {
    const materials::FamilySums sums = evaluation.sums(committed, i, fit);
    const double* history = committed.point_history(scene_, i);
    trial.resize(static_cast<std::size_t>(scene_.point_history()[i + 1] - scene_.point_history()[i]));
    const materials::PointState state = scene_.material(i).state(sums, history, trial.data());
    const materials::PointModulus modulus = scene_.material(i).modulus(sums, history, form);
    if (modulus.diagonal_only) throw std::logic_error("the printed tangent has no matrix-free product");
    law_.radial[i] = state.radial;
    take(law_.shear[i], state.shear);
    if (!law_.yielded.empty()) law_.yielded[i] = state.shear - state.back;
    law_.mean[i] = modulus.mean;  // matters to a point that flows only
    take(law_.dilatation[i], modulus.radial);
    take(law_.flow[i], modulus.flow);
    if (const bonds::Moment* moment = families.moment(i)) {
      const auto m = static_cast<std::size_t>(families.fit[i]);
      law_.radial[i] = 0;
      law_.state[m] = force_of_fit(*moment, fit, state);
      law_.slope[m] = slope_of_fit(*moment, fit, modulus);
      take(law_.modulus[m], materials::strain_modulus(*moment, modulus.bulk, modulus.shear));
    }
    if (modulus.flow == 0) continue;
    same = false;
    shear_left_.resize(owned, 1.0);
    shear_left_[i] = left_of_shear(sums, modulus, scene_.material(i).elastic_moduli(scene_.dimension()).shear);
  }
  if (scene_.small_strain() && !scene_.body().communicator.any(!same)) return false;
  linearised_ = true;
  if (bonds_version_ != scene_.bonds_version()) loops_->bonds_changed();
  bonds_version_ = scene_.bonds_version();
  plastic_ = committed.shared_plastic();
  loops_->linearise(evaluation.displacement().data(), law_, *plastic_);
  return true;
}

void MatrixFreeTangent::apply(const double* x, double* y) const {
  const Profile::Scope timed(scene_.body().communicator.profile(), Section::product);
  loops_->product(x, y);
}

void MatrixFreeTangent::diagonal_blocks(double* blocks, double dilatation) const {
  const int size = scene_.dimension() * scene_.dimension();
  std::vector<double> all(static_cast<std::size_t>(scene_.local()) * size);
  if (dilatation == 1) {
    loops_->diagonal_blocks(law_, all.data());
  } else {
    TangentLaw law = law_;
    for (double& coefficient : law.dilatation) coefficient *= dilatation;
    for (auto& modulus : law.modulus)
      for (double& coefficient : modulus) coefficient *= dilatation;
    loops_->diagonal_blocks(law, all.data());
  }
  scene_.body().halo.add_to_owners(all.data(), size);
  std::copy(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(scene_.owned()) * size, blocks);
}

std::size_t MatrixFreeTangent::bytes() const {
  const std::size_t fits = law_.state.size() * (2 * sizeof(bonds::Mandel) + sizeof(law_.modulus[0]));
  return loops_->bytes() + (5 * law_.radial.size() + law_.yielded.size() + shear_left_.size()) * sizeof(double) + fits;
}

std::unique_ptr<Tangent> make_tangent(const Scene& scene, deck::TangentForm form,
                                      std::shared_ptr<Evaluation> evaluation) {
  if (form == deck::TangentForm::consistent && scene.from_sums())
    return std::make_unique<MatrixFreeTangent>(scene, std::move(evaluation));
  return std::make_unique<StoredTangent>(scene);
}

}  // namespace perinox::mechanics
