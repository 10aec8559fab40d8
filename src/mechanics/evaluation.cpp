#include "perinox/mechanics/evaluation.hpp"

#include <algorithm>

namespace perinox::mechanics {

Evaluation::Evaluation(const Scene& scene)
    : scene_(scene), loops_(FamilyLoops::make(scene)), back_stress_(mechanics::has_back_stress(scene)) {}

void Evaluation::at(const Committed& committed, const medium::At& at) {
  if (version_ == at.version && committed_version_ == committed.version() && bonds_version_ == scene_.bonds_version())
    return;
  version_ = 0;  // until the sweeps are through
  displacement_.resize(scene_.local_unknowns());
  std::copy(at.displacement, at.displacement + scene_.owned_unknowns(), displacement_.begin());
  scene_.body().halo.update_ghosts(displacement_.data(), scene_.dimension());
  follow_bonds();
  sums_.total.clear();
  if (back_stress_ && committed.plastic().chunks()) {  // a sweep more, so that the others need no sum more
    loops_->strain_sums(displacement_.data(), committed.mean().data(), PlasticExtension(), sums_);
    sums_.total = sums_.square;
  }
  loops_->strain_sums(displacement_.data(), committed.mean().data(), committed.plastic(), sums_);
  committed_version_ = committed.version();
  version_ = at.version;
}

void Evaluation::follow_bonds() {
  if (bonds_version_ != scene_.bonds_version()) loops_->bonds_changed();
  bonds_version_ = scene_.bonds_version();
}

void Evaluation::moved(const Committed& committed, double* displacement) {
  version_ = 0;
  follow_bonds();
  loops_->moving_sums(displacement, committed.mean().data(), committed.plastic(), sums_);
  sums_.total.clear();
  if (!back_stress_ || !committed.plastic().chunks()) return;
  loops_->strain_sums(displacement, committed.mean().data(), PlasticExtension(), whole_);
  sums_.total = whole_.square;
}

materials::FamilySums Evaluation::sums(const Committed& committed, LocalIndex i, materials::StrainFit& fit) const {
  const bonds::Mandel none{};
  const bonds::Families& families = scene_.families();
  if (!families.moment(i)) return family_sums(scene_, committed, sums_, i, none, none, fit);
  const auto m = static_cast<std::size_t>(families.fit[i]);
  return family_sums(scene_, committed, sums_, i, sums_.fit[m], sums_.plastic_fit[m], fit);
}

const Evaluation::Law& Evaluation::answers(const Committed& committed, Trial& trial) {
  const Scene& scene = scene_;
  const auto owned = static_cast<std::size_t>(scene.owned());
  law_.radial.resize(owned);
  law_.shear.resize(owned);
  law_.yielded.resize(back_stress_ ? owned : 0);
  law_.state.resize(scene.families().moments.size());
  materials::StrainFit fit;
  for (LocalIndex i = 0; i < scene.owned(); ++i) {
    const materials::PointState point =
        scene.material(i).state(sums(committed, i, fit), committed.point_history(scene, i),
                                trial.point_history.data() + scene.point_history()[i]);
    const bonds::Moment* moment = scene.families().moment(i);
    law_.radial[i] = moment ? 0 : point.radial;
    law_.shear[i] = point.shear;
    if (!law_.yielded.empty()) law_.yielded[i] = point.shear - point.back;
    if (moment) law_.state[static_cast<std::size_t>(scene.families().fit[i])] = force_of_fit(*moment, fit, point);
    trial.mean[i] = point.mean;
    if (!trial.flow.empty()) trial.flow[i] = point.flow;
    trial.dilatation[i] = point.response.dilatation;
    trial.stored_energy[i] = point.response.stored_energy;
    trial.stored += scene.body().volume[i] * point.response.stored_energy;
    trial.unflowed += scene.body().volume[i] * point.response.unflowed_energy;
    trial.dissipated += scene.body().volume[i] * point.response.dissipation;
    trial.yielding += point.response.yielding ? 1 : 0;
  }
  return law_;
}

}  // namespace perinox::mechanics
