#include "evaluation.hpp"

#include <algorithm>

namespace perinox::mechanics {

void Evaluation::at(const Scene& scene, const Committed& committed, const double* displacement) {
  const bool same = version_ == committed.version() && bonds_version_ == scene.bonds_version() &&
                    displacement_.size() == scene.local_unknowns() &&
                    std::equal(displacement, displacement + scene.owned_unknowns(), displacement_.begin());
  if (!scene.body().communicator.any(!same)) return;
  displacement_.resize(scene.local_unknowns());
  std::copy(displacement, displacement + scene.owned_unknowns(), displacement_.begin());
  scene.body().halo.update_ghosts(displacement_.data(), scene.dimension());
  follow_bonds(scene);
  sums_.total.clear();
  if (back_stress_ && committed.plastic().chunks()) {  // a sweep more, so that the others need no sum more
    loops_->strain_sums(displacement_.data(), committed.mean().data(), PlasticExtension(), sums_);
    sums_.total = sums_.square;
  }
  loops_->strain_sums(displacement_.data(), committed.mean().data(), committed.plastic(), sums_);
  version_ = committed.version();
}

void Evaluation::follow_bonds(const Scene& scene) {
  if (bonds_version_ != scene.bonds_version()) loops_->bonds_changed();
  bonds_version_ = scene.bonds_version();
}

void Evaluation::moved(const Scene& scene, const Committed& committed, double* displacement) {
  displacement_.clear();
  follow_bonds(scene);
  loops_->moving_sums(displacement, committed.mean().data(), committed.plastic(), sums_);
  sums_.total.clear();
  if (!back_stress_ || !committed.plastic().chunks()) return;
  loops_->strain_sums(displacement, committed.mean().data(), PlasticExtension(), whole_);
  sums_.total = whole_.square;
}

materials::FamilySums Evaluation::sums(const Scene& scene, const Committed& committed, LocalIndex i,
                                       materials::StrainFit& fit) const {
  const bonds::Mandel none{};
  const auto m = static_cast<std::size_t>(scene.families().moment(i) ? scene.families().fit[i] : 0);
  return scene.families().moment(i) ? family_sums(scene, committed, sums_, i, sums_.fit[m], sums_.plastic_fit[m], fit)
                                    : family_sums(scene, committed, sums_, i, none, none, fit);
}

Evaluation::Law& Evaluation::answers(const Scene& scene, const Committed& committed, Trial& trial) {
  const auto owned = static_cast<std::size_t>(scene.owned());
  law_.radial.resize(owned);
  law_.shear.resize(owned);
  law_.yielded.resize(back_stress_ ? owned : 0);
  law_.state.resize(scene.families().moments.size());
  materials::StrainFit fit;
  for (LocalIndex i = 0; i < scene.owned(); ++i) {
    const materials::PointState point =
        scene.material(i).state(sums(scene, committed, i, fit), committed.point_history(scene, i),
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
