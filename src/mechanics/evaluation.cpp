#include "evaluation.hpp"

#include <algorithm>

namespace perinox::mechanics {

void Evaluation::at(const Scene& scene, const Committed& committed, const double* displacement) {
  const bool same = version_ == committed.version() && displacement_.size() == scene.local_unknowns() &&
                    std::equal(displacement, displacement + scene.owned_unknowns(), displacement_.begin());
  if (!scene.body().communicator.any(!same)) return;
  displacement_.resize(scene.local_unknowns());
  std::copy(displacement, displacement + scene.owned_unknowns(), displacement_.begin());
  scene.body().halo.update_ghosts(displacement_.data(), scene.dimension());
  loops_->strain_sums(displacement_.data(), committed.mean().data(), committed.plastic(), sums_);
  version_ = committed.version();
}

materials::FamilySums Evaluation::sums(const Scene& scene, const Committed& committed, LocalIndex i,
                                       materials::StrainFit& fit) const {
  materials::FamilySums sums;
  sums.extension = sums_.extension[i];
  sums.plastic = sums_.plastic.empty() ? 0 : sums_.plastic[i];
  sums.square = sums_.square[i];
  sums.shift = committed.mean()[i];
  sums.weighted_volume = scene.families().weighted_volume[i];
  sums.continuum_weighted_volume = scene.families().continuum_weighted_volume;
  sums.dimension = scene.dimension();
  if (const bonds::Moment* moment = scene.families().moment(i)) {
    const auto m = static_cast<std::size_t>(scene.families().fit[i]);
    fit = materials::fit(*moment, sums_.fit[m], sums_.plastic_fit[m], sums.square, sums.shift);
    sums.fitted = true;
    sums.extension = sums.weighted_volume * fit.dilatation / sums.dimension;
    sums.square = fit.square;
  }
  return sums;
}

}  // namespace perinox::mechanics
