#include "perinox/mechanics/family_loops.hpp"

#include <algorithm>
#include <numeric>

#include "lattice_loops.hpp"
#include "pair_loops.hpp"

namespace perinox::mechanics {

materials::FamilySums family_sums(const Scene& scene, const Committed& committed, const StrainSums& strains,
                                  LocalIndex i, bonds::Mandel of_fit, bonds::Mandel plastic_fit,
                                  materials::StrainFit& fit) {
  materials::FamilySums sums;
  sums.extension = strains.extension[i];
  sums.plastic = strains.plastic.empty() ? 0 : strains.plastic[i];
  sums.square = strains.square[i];
  sums.total = strains.total.empty() ? sums.square : strains.total[i];
  sums.shift = committed.mean()[i];
  sums.dimension = scene.dimension();
  const bonds::Families& families = scene.families();
  if (!families.broken_extension.empty()) {
    const auto at = static_cast<std::size_t>(i);
    const bonds::BrokenExtension& kept = families.broken_extension[at];
    const bonds::BrokenElastic elastic = committed.broken_elastic(scene, i);
    sums.add_broken(families.broken_volume[at], kept, elastic);
    for (std::size_t k = 0; k < kept.fit.size(); ++k) {
      of_fit[k] += kept.fit[k];
      plastic_fit[k] += kept.fit[k] - elastic.fit[k];
    }
  } else if (!families.broken_volume.empty()) {
    sums.add_broken(families.broken_volume[static_cast<std::size_t>(i)], {}, {});
  }
  sums.weighted_volume = families.weighted_volume[i];
  if (!families.deviatoric_volume.empty()) sums.corrected_volume = families.deviatoric_volume[i];
  sums.continuum_weighted_volume = families.continuum_weighted_volume;
  if (const bonds::Moment* moment = families.moment(i)) {
    fit = materials::fit(*moment, of_fit, plastic_fit, sums.square, sums.shift);
    if (scene.material(i).has_back_stress()) {
      fit_total(*moment, of_fit, sums.total, sums.shift, fit);
      sums.total = fit.total;
    }
    sums.fitted = true;
    sums.extension = sums.weighted_volume * fit.dilatation / sums.dimension;
    sums.square = fit.square;
  }
  return sums;
}

std::unique_ptr<FamilyLoops> FamilyLoops::make(const Scene& scene) {
  const Purpose purpose{scene.small_strain(), false};
  if (scene.lattice()) return std::make_unique<LatticeLoops>(scene, purpose);
  return std::make_unique<PairLoops>(scene, purpose);
}

std::unique_ptr<FamilyLoops> FamilyLoops::make_for_tensors(const Scene& scene, bool small_strain) {
  const Purpose purpose{small_strain, true};
  if (scene.lattice()) return std::make_unique<LatticeLoops>(scene, purpose);
  return std::make_unique<PairLoops>(scene, purpose);
}

bool has_back_stress(const Scene& scene) {
  return std::any_of(scene.materials().begin(), scene.materials().end(),
                     [](const auto& material) { return material->has_back_stress(); });
}

FamilyLoops::FamilyLoops(const Scene& scene, Purpose purpose)
    : halo_(scene.body().halo),
      d_(scene.dimension()),
      owned_(scene.owned()),
      local_(scene.local()),
      back_stress_(has_back_stress(scene)) {
  if (purpose.tensors) {
    fitted_.resize(static_cast<std::size_t>(owned_));
    std::iota(fitted_.begin(), fitted_.end(), 0);
    return;
  }
  const bonds::Families& families = scene.families();
  fit_of_ = families.fit;
  fitted_.resize(families.moments.size());
  for (LocalIndex i = 0; i < owned_; ++i)
    if (families.moment(i)) fitted_[static_cast<std::size_t>(families.fit[i])] = i;
}

void FamilyLoops::keep_fits(const TangentLaw& law) {
  slope_ = law.slope;
  modulus_ = law.modulus;
}

FamilyLoops::FitChange FamilyLoops::change_of_fit(std::size_t m, const bonds::Mandel& sums, double second,
                                                  double flow) const {
  const auto n = static_cast<std::size_t>(bonds::mandel_size(d_));
  FitChange result;
  double along = second;
  for (std::size_t k = 0; k < n; ++k) along += slope_[m][k] * sums[k];
  result.flow = flow * along;
  for (std::size_t k = 0; k < n; ++k) {
    double change = slope_[m][k] * result.flow;
    for (std::size_t l = 0; l < n; ++l) change += modulus_[m][k * n + l] * sums[l];
    result.change[k] = change;
  }
  return result;
}

void FamilyLoops::strain_sums(const double* displacement, const double* shift, const PlasticExtension& plastic,
                              StrainSums& sums) {
  begin_strains(shift);
  put_displacement(displacement, 0, local_);
  sweep_strains(Bonds::inner, plastic);
  sweep_strains(Bonds::outer, plastic);
  take_strains(plastic.chunks() != nullptr, sums);
}

void FamilyLoops::forces(const double* radial, const double* shear, const double* yielded, const bonds::Mandel* state,
                         const PlasticExtension& plastic, double* force) {
  begin_forces(radial, shear, yielded, state);
  sweep_forces(Bonds::inner, plastic);
  sweep_forces(Bonds::outer, plastic);
  take_forces(0, local_, force);
}

double FamilyLoops::turning_work(const double* radial, const double* shear, const double* yielded,
                                 const bonds::Mandel* state, const PlasticExtension& plastic, const double* step) {
  begin_forces(radial, shear, yielded, state);
  return sweep_turning(plastic, step);
}

void FamilyLoops::moving_sums(double* displacement, const double* shift, const PlasticExtension& plastic,
                              StrainSums& sums) {
  halo_.begin_update(displacement, d_);
  begin_strains(shift);
  put_displacement(displacement, 0, owned_);
  sweep_strains(Bonds::inner, plastic);
  halo_.end_update(displacement, d_);
  put_displacement(displacement, owned_, local_);
  sweep_strains(Bonds::outer, plastic);
  take_strains(plastic.chunks() != nullptr, sums);
}

void FamilyLoops::moving_forces(const double* radial, const double* shear, const double* yielded,
                                const bonds::Mandel* state, const PlasticExtension& plastic, double* force) {
  begin_forces(radial, shear, yielded, state);
  sweep_forces(Bonds::outer, plastic);
  if (!alone()) {
    ghosts_.resize(static_cast<std::size_t>(local_) * d_);
    take_forces(owned_, local_, ghosts_.data());
    halo_.begin_add(ghosts_.data(), d_);
  }
  sweep_forces(Bonds::inner, plastic);
  take_forces(0, owned_, force);
  if (!alone()) halo_.end_add(force, d_);
}

void FamilyLoops::product(const double* x, double* y) {
  halo_.begin_update(x, d_);
  put_direction(x, 0, owned_);
  clear_sums();
  product_sums(Bonds::inner);
  if (!alone()) {
    ghosts_.resize(static_cast<std::size_t>(local_) * d_);
    halo_.end_update(ghosts_.data(), d_);
    put_direction(ghosts_.data(), owned_, local_);
  }
  product_sums(Bonds::outer);
  product_law();
  product_forces(Bonds::outer);
  if (!alone()) {
    take_forces(owned_, local_, ghosts_.data());
    halo_.begin_add(ghosts_.data(), d_);
  }
  product_forces(Bonds::inner);
  take_forces(0, owned_, y);
  if (!alone()) halo_.end_add(y, d_);
}

}  // namespace perinox::mechanics
