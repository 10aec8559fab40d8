#include "pair_loops.hpp"

#include <algorithm>
#include <cmath>

#include "block_entries.hpp"

namespace perinox::mechanics {

PairLoops::PairLoops(const Scene& scene, Purpose purpose)
    : FamilyLoops(scene, purpose),
      families_(*scene.pairs()),
      slot_(families_.slot()),
      small_(purpose.small_strain),
      plastic_body_(scene.plastic_here()) {
  require(reference_);
  put(scene.body().reference.data(), d_, 0, local_, reference_, 0);
  put(scene.body().volume.data(), 1, 0, local_, reference_, 3);
  // The particle that is not there has no volume, and a place where no other is.
  if (!fitted_.empty()) {
    std::vector<std::uint8_t> fitted(static_cast<std::size_t>(families_.slots()), 0);
    for (const LocalIndex i : fitted_) fitted[static_cast<std::size_t>(slot_[i])] = 1;
    fitted_slots_.assign(fitted.begin(), fitted.begin() + owned_);
    for (int s = 0; s < owned_; ++s)
      for (std::int64_t k = families_.begin()[s]; k < families_.begin()[s + 1] && !fitted_slots_[s]; ++k)
        fitted_slots_[s] = fitted[static_cast<std::size_t>(families_.far()[k])];
  }
  double largest = 1;
  for (const double x : scene.body().reference) largest = std::max(largest, std::abs(x));
  for (int c = 0; c < d_; ++c) reference_[4 * static_cast<std::size_t>(families_.slots() - 1) + c] = 1e3 * largest;
}

int PairLoops::strain_results() const {
  return fitted_.empty() ? 3 : kernels::first_plastic_fit + (plastic_body_ ? bonds::mandel_size(d_) : 0);
}
int PairLoops::product_results() const {
  return fitted_.empty() ? 3 : kernels::first_fit_change + bonds::mandel_size(d_);
}

void PairLoops::clear_results(int count) {
  for (int part = 0; part < parts_of(count); ++part) {
    require(out_[part]);
    std::fill(out_[part].begin(), out_[part].end(), 0.0);
  }
}

void PairLoops::set_results(kernels::PairView& view, std::array<Values, 8>& results) {
  for (std::size_t part = 0; part < results.size(); ++part)
    view.out[part] = results[part].empty() ? nullptr : results[part].data();
}

void PairLoops::put_fits(const bonds::Mandel* values, std::array<Values, 2>& to) const {
  if (fitted_.empty()) return;
  for (Values& part : to) require(part);
  for (std::size_t m = 0; m < fitted_.size(); ++m)
    for (int k = 0; k < bonds::mandel_size(d_); ++k)
      to[k / 4][4 * static_cast<std::size_t>(slot_[fitted_[m]]) + k % 4] = values[m][k];
}

bonds::Mandel PairLoops::take_fit(std::size_t m, int first) const {
  bonds::Mandel sums{};
  const std::size_t at = 4 * static_cast<std::size_t>(slot_[fitted_[m]]);
  for (int k = 0; k < bonds::mandel_size(d_); ++k) sums[k] = out_[(first + k) / 4][at + (first + k) % 4];
  return sums;
}

void PairLoops::set_fits(kernels::PairView& view) const {
  view.fitted = fitted_slots_.empty() ? nullptr : fitted_slots_.data();
  for (std::size_t part = 0; part < 2; ++part) {
    if (!state_[part].empty()) view.state[part] = state_[part].data();
    if (!change_[part].empty()) view.change[part] = change_[part].data();
  }
}

std::size_t PairLoops::bytes() const {
  std::size_t values = reference_.size() + u_.size() + x_.size() + law_.size() + dilatation_.size() + flow_.size() +
                       ghosts_.size() + plastic_.size();
  for (const Values& part : out_) values += part.size();
  for (const auto* fits : {&state_, &change_})
    for (const Values& part : *fits) values += part.size();
  return values * sizeof(double) + fitted_slots_.size() +
         fitted_.size() * (sizeof(LocalIndex) + sizeof(slope_[0]) + sizeof(modulus_[0]));
}

LoopMemory PairLoops::expected() const {
  const auto values = static_cast<std::size_t>(families_.slots()) * 4 * sizeof(double);
  LoopMemory memory;
  memory.evaluation = (3 + parts_of(strain_results())) * values;
  memory.tangent = (4 + parts_of(product_results())) * values + 2 * static_cast<std::size_t>(owned_) * sizeof(double);
  if (!fitted_.empty()) {
    const std::size_t lists = fitted_.size() * sizeof(LocalIndex) + static_cast<std::size_t>(owned_);
    memory.evaluation += 2 * values + lists;
    memory.tangent += (small_ ? 2 : 4) * values + lists + fitted_.size() * (sizeof(slope_[0]) + sizeof(modulus_[0]));
  }
  if (local_ > owned_) memory.tangent += static_cast<std::size_t>(local_) * d_ * sizeof(double);
  if (!plastic_body_) return memory;
  memory.tangent += static_cast<std::size_t>(owned_) * sizeof(double*);
  memory.plastic = 2 * families_.far().size() * sizeof(double) + static_cast<std::size_t>(owned_) * sizeof(double*);
  return memory;
}

void PairLoops::require(Values& values) const { values.resize(static_cast<std::size_t>(families_.slots()) * 4, 0.0); }

kernels::PairView PairLoops::view(const std::vector<std::int32_t>& slots, double* const* plastic) const {
  kernels::PairView view;
  view.slots = slots.data();
  view.slot_count = static_cast<std::int64_t>(slots.size());
  view.begin = families_.begin().data();
  view.far = families_.far().data();
  view.length = families_.length().data();
  view.weight = families_.weight().empty() ? nullptr : families_.weight().data();
  view.plastic = plastic;
  // What a sweep does not use it does not read, but it may form the address.
  view.place = view.u = view.x = view.law = reference_.data();
  for (const double*& part : view.state) part = reference_.data();
  for (const double*& part : view.change) part = reference_.data();
  set_fits(view);
  return view;
}

const std::vector<std::int32_t>& PairLoops::slots_of(Bonds bonds) const {
  return bonds == Bonds::inner ? families_.interior() : families_.boundary();
}

void PairLoops::both(kernels::PairSweeps::Sweep run, kernels::PairView g) const {
  sweep(run, g);
  g.slots = families_.boundary().data();
  g.slot_count = static_cast<std::int64_t>(families_.boundary().size());
  sweep(run, g);
}

void PairLoops::put(const double* values, int components, int first, int last, Values& to, int component) const {
  for (int i = first; i < last; ++i)
    for (int c = 0; c < components; ++c)
      to[4 * static_cast<std::size_t>(slot_[i]) + component + c] = values[static_cast<std::size_t>(i) * components + c];
}

void PairLoops::take(const Values& from, int component, int components, int first, int last, double* values) const {
  for (int i = first; i < last; ++i)
    for (int c = 0; c < components; ++c)
      values[static_cast<std::size_t>(i) * components + c] =
          from[4 * static_cast<std::size_t>(slot_[i]) + component + c];
}

void PairLoops::begin_strains(const double* shift) {
  require(u_);
  put(shift, 1, 0, owned_, u_, 3);
  clear_results(strain_results());
}

void PairLoops::put_displacement(const double* displacement, LocalIndex first, LocalIndex last) {
  put(displacement, d_, first, last, u_, 0);
}

void PairLoops::sweep_strains(Bonds bonds, const PlasticExtension& plastic) {
  kernels::PairView g = view(slots_of(bonds), plastic.chunks());
  g.place = reference_.data();
  g.u = u_.data();
  set_results(g, out_);
  sweep(kernels::sweeps().pairs.strain_sums, g);
}

void PairLoops::take_strains(bool flowed, StrainSums& sums) const {
  sums.fit.resize(fitted_.size());
  sums.plastic_fit.resize(fitted_.size());
  for (std::size_t m = 0; m < fitted_.size(); ++m) {
    sums.fit[m] = take_fit(m, kernels::first_fit);
    sums.plastic_fit[m] = flowed ? take_fit(m, kernels::first_plastic_fit) : bonds::Mandel{};
  }
  const auto owned = static_cast<std::size_t>(owned_);
  sums.extension.resize(owned);
  sums.square.resize(owned);
  sums.plastic.resize(flowed ? owned : 0);
  take(out_[0], 0, 1, 0, owned_, sums.extension.data());
  take(out_[0], 1, 1, 0, owned_, sums.square.data());
  if (flowed) take(out_[0], 2, 1, 0, owned_, sums.plastic.data());
}

void PairLoops::begin_forces(const double* radial, const double* shear, const double* yielded,
                             const bonds::Mandel* state) {
  require(law_);
  put_fits(state, state_);
  put(radial, 1, 0, owned_, law_, kernels::radial);
  put(shear, 1, 0, owned_, law_, kernels::shear);
  if (plastic_body_) put(yielded ? yielded : shear, 1, 0, owned_, law_, kernels::along);
  clear_results(d_);
}

kernels::PairView PairLoops::force_view(const std::vector<std::int32_t>& slots, const PlasticExtension& plastic) {
  kernels::PairView g = view(slots, plastic.chunks());
  g.place = reference_.data();
  g.u = u_.data();
  g.law = law_.data();
  set_results(g, out_);
  return g;
}

void PairLoops::sweep_forces(Bonds bonds, const PlasticExtension& plastic) {
  sweep(kernels::sweeps().pairs.forces, force_view(slots_of(bonds), plastic));
}

double PairLoops::sweep_turning(const PlasticExtension& plastic, const double* step) {
  require(x_);
  put(step, d_, 0, local_, x_, 0);
  kernels::PairView g = force_view(families_.interior(), plastic);
  g.x = x_.data();
  both(kernels::sweeps().pairs.turning_work, g);
  double work = 0;
  for (int i = 0; i < local_; ++i) work += out_[0][4 * static_cast<std::size_t>(slot_[i])];
  return work;
}

void PairLoops::linearise(const double* displacement, const TangentLaw& law, const PlasticExtension& plastic) {
  for (Values* values : {&u_, &x_, &law_}) require(*values);
  if (!small_) put_fits(law.state.data(), state_);
  if (!fitted_.empty())
    for (Values& part : change_) require(part);
  keep_fits(law);
  put(displacement, d_, 0, local_, u_, 0);
  put(law.mean.data(), 1, 0, owned_, u_, 3);
  put(law.radial.data(), 1, 0, owned_, law_, kernels::radial);
  put(law.shear.data(), 1, 0, owned_, law_, kernels::shear);
  if (plastic_body_ && !small_) put((law.yielded.empty() ? law.shear : law.yielded).data(), 1, 0, owned_, x_, 3);
  dilatation_.resize(static_cast<std::size_t>(owned_));
  flow_.resize(static_cast<std::size_t>(owned_));
  bool flows = false;
  for (int i = 0; i < owned_; ++i) {
    dilatation_[slot_[i]] = law.dilatation[i];
    flow_[slot_[i]] = law.flow[i];
    flows = flows || law.flow[i] != 0;
  }
  for (const LocalIndex i : fitted_) dilatation_[slot_[i]] = 0;
  plastic_.clear();
  if (plastic.chunks()) plastic_.assign(plastic.chunks(), plastic.chunks() + owned_);
  put(law.flow.data(), 1, 0, owned_, law_, kernels::flow);
  if (!flows) return;
  // A family that flows for the first time has its rank-one term already, and no plastic extension yet.
  plastic_.resize(static_cast<std::size_t>(owned_), nullptr);
  std::int64_t largest = 0;
  for (int s = 0; s < owned_; ++s) largest = std::max(largest, families_.begin()[s + 1] - families_.begin()[s]);
  none_.assign(static_cast<std::size_t>(2 * largest), 0.0);
  const std::vector<char> flowing = flowing_slots(law_, kernels::flow);
  for (int s = 0; s < owned_; ++s)
    if (flowing[s] && !plastic_[s]) plastic_[s] = none_.data();
}

std::vector<char> PairLoops::flowing_slots(const Values& values, int component) const {
  std::vector<char> flowing(static_cast<std::size_t>(owned_), 0);
  for (std::size_t s = 0; s < flowing.size(); ++s) {
    bool found = values[4 * s + component] != 0;
    for (std::int64_t k = families_.begin()[s]; k < families_.begin()[s + 1] && !found; ++k)
      found = values[4 * static_cast<std::size_t>(families_.far()[k]) + component] != 0;
    flowing[s] = found ? 1 : 0;
  }
  return flowing;
}

kernels::PairView PairLoops::product_view(Bonds bonds) {
  kernels::PairView g = view(slots_of(bonds), plastic_.empty() ? nullptr : plastic_.data());
  g.place = reference_.data();
  g.u = u_.data();
  g.x = x_.data();
  g.law = law_.data();
  set_results(g, out_);
  return g;
}

void PairLoops::put_direction(const double* x, LocalIndex first, LocalIndex last) { put(x, d_, first, last, x_, 0); }

void PairLoops::clear_sums() { clear_results(product_results()); }

void PairLoops::product_sums(Bonds bonds) { sweep(kernels::sweeps().pairs.product_sums, product_view(bonds)); }

void PairLoops::product_law() {
  for (int s = 0; s < owned_; ++s) {
    const std::size_t at = 4 * static_cast<std::size_t>(s);
    const double mean = u_[at + 3];
    const double flow = flow_[s] * (out_[0][at + 1] - mean * out_[0][at]);
    law_[at + kernels::flow] = flow;
    law_[at + kernels::along] = dilatation_[s] * out_[0][at] - mean * flow;
  }
  for (std::size_t m = 0; m < fitted_.size(); ++m) {
    const int s = slot_[fitted_[m]];
    const std::size_t at = 4 * static_cast<std::size_t>(s);
    const FitChange fit = change_of_fit(m, take_fit(m, kernels::first_fit_change), out_[0][at + 1], flow_[s]);
    law_[at + kernels::flow] = fit.flow;
    law_[at + kernels::along] = 0;
    for (int k = 0; k < bonds::mandel_size(d_); ++k) change_[k / 4][at + k % 4] = fit.change[k];
  }
  clear_results(d_);
}

void PairLoops::product_forces(Bonds bonds) { sweep(kernels::sweeps().pairs.product_forces, product_view(bonds)); }

void PairLoops::take_forces(LocalIndex first, LocalIndex last, double* y) const {
  take(out_[0], 0, d_, first, last, y);
}

void PairLoops::diagonal_blocks(const TangentLaw& law, double* blocks) {
  const int n = bonds::mandel_size(d_);
  const int results = fitted_.empty() ? n + 2 * d_ : kernels::first_fit_gradient + n * d_;
  std::array<Values, 8> out;
  for (int part = 0; part < parts_of(results); ++part) require(out[part]);
  put(law.dilatation.data(), 1, 0, owned_, law_, kernels::along);
  put(law.flow.data(), 1, 0, owned_, law_, kernels::flow);
  kernels::PairView g = view(families_.interior(), plastic_.empty() ? nullptr : plastic_.data());
  g.place = reference_.data();
  g.u = u_.data();
  g.x = x_.data();
  g.law = law_.data();
  set_results(g, out);
  both(kernels::sweeps().pairs.diagonal_blocks, g);
  double entries[kernels::most_results];
  for (int i = 0; i < local_; ++i) {
    const std::size_t at = 4 * static_cast<std::size_t>(slot_[i]);
    for (int k = 0; k < results; ++k) entries[k] = out[k / 4][at + k % 4];
    const OwnTerms own = i < owned_ ? own_terms(law, i, fit_of(i), reference_[at + 3]) : OwnTerms();
    finish_block(d_, entries, !plastic_.empty(), i < owned_ ? &own : nullptr,
                 blocks + static_cast<std::size_t>(i) * d_ * d_);
  }
}

void PairLoops::advance(const double* displacement, const double* mean, const double* flow, PlasticExtension& plastic) {
  require(u_);
  Values flowing;
  require(flowing);
  put(displacement, d_, 0, local_, u_, 0);
  put(mean, 1, 0, owned_, u_, 3);
  put(flow, 1, 0, owned_, flowing, kernels::flow);
  const std::vector<char> needed = flowing_slots(flowing, kernels::flow);
  for (std::size_t s = 0; s < needed.size(); ++s)
    if (needed[s])
      plastic.require(s, needed.size(),
                      static_cast<std::size_t>(2 * (families_.begin()[s + 1] - families_.begin()[s])));
  kernels::PairView g = view(families_.interior(), plastic.chunks());
  g.place = reference_.data();
  g.u = u_.data();
  g.law = flowing.data();
  both(kernels::sweeps().pairs.advance, g);
}

}  // namespace perinox::mechanics
