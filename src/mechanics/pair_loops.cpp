#include "pair_loops.hpp"

#include <algorithm>
#include <cmath>

#include "block_entries.hpp"

namespace perinox::mechanics {

PairLoops::PairLoops(const Scene& scene)
    : FamilyLoops(scene),
      families_(*scene.pairs()),
      slot_(families_.slot()),
      small_(scene.small_strain()),
      plastic_body_(scene.plastic()) {
  require(reference_);
  put(scene.body().reference.data(), d_, 0, local_, reference_, 0);
  put(scene.body().volume.data(), 1, 0, local_, reference_, 3);
  // The particle that is not there has no volume, and a place where no other is.
  double largest = 1;
  for (const double x : scene.body().reference) largest = std::max(largest, std::abs(x));
  for (int c = 0; c < d_; ++c) reference_[4 * static_cast<std::size_t>(families_.slots() - 1) + c] = 1e3 * largest;
}

std::size_t PairLoops::bytes() const {
  return (reference_.size() + u_.size() + x_.size() + law_.size() + out_.size() + dilatation_.size() + flow_.size() +
          ghosts_.size() + plastic_.size()) *
         sizeof(double);
}

LoopMemory PairLoops::expected() const {
  const auto values = static_cast<std::size_t>(families_.slots()) * 4 * sizeof(double);
  LoopMemory memory;
  memory.evaluation = 4 * values;
  memory.tangent = 5 * values + 2 * static_cast<std::size_t>(owned_) * sizeof(double);
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
  return view;
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

void PairLoops::strain_sums(const double* displacement, const double* shift, const PlasticExtension& plastic,
                            StrainSums& sums) {
  require(u_);
  require(out_);
  put(displacement, d_, 0, local_, u_, 0);
  put(shift, 1, 0, owned_, u_, 3);
  std::fill(out_.begin(), out_.end(), 0.0);
  kernels::PairView g = view(families_.interior(), plastic.chunks());
  g.place = reference_.data();
  g.u = u_.data();
  g.out[0] = out_.data();
  both(kernels::sweeps().pairs.strain_sums, g);
  const auto owned = static_cast<std::size_t>(owned_);
  sums.extension.resize(owned);
  sums.square.resize(owned);
  sums.plastic.resize(plastic.chunks() ? owned : 0);
  take(out_, 0, 1, 0, owned_, sums.extension.data());
  take(out_, 1, 1, 0, owned_, sums.square.data());
  if (plastic.chunks()) take(out_, 2, 1, 0, owned_, sums.plastic.data());
}

void PairLoops::forces(const double* radial, const double* shear, const PlasticExtension& plastic, double* force) {
  require(law_);
  put(radial, 1, 0, owned_, law_, kernels::radial);
  put(shear, 1, 0, owned_, law_, kernels::shear);
  std::fill(out_.begin(), out_.end(), 0.0);
  kernels::PairView g = view(families_.interior(), plastic.chunks());
  g.place = reference_.data();
  g.u = u_.data();
  g.law = law_.data();
  g.out[0] = out_.data();
  both(kernels::sweeps().pairs.forces, g);
  take(out_, 0, d_, 0, local_, force);
}

void PairLoops::linearise(const double* displacement, const TangentLaw& law, const PlasticExtension& plastic) {
  for (Values* values : {&u_, &x_, &law_, &out_}) require(*values);
  put(displacement, d_, 0, local_, u_, 0);
  put(law.mean.data(), 1, 0, owned_, u_, 3);
  put(law.radial.data(), 1, 0, owned_, law_, kernels::radial);
  put(law.shear.data(), 1, 0, owned_, law_, kernels::shear);
  dilatation_.resize(static_cast<std::size_t>(owned_));
  flow_.resize(static_cast<std::size_t>(owned_));
  bool flows = false;
  for (int i = 0; i < owned_; ++i) {
    dilatation_[slot_[i]] = law.dilatation[i];
    flow_[slot_[i]] = law.flow[i];
    flows = flows || law.flow[i] != 0;
  }
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
  kernels::PairView g = view(bonds == Bonds::inner ? families_.interior() : families_.boundary(),
                             plastic_.empty() ? nullptr : plastic_.data());
  g.place = reference_.data();
  g.u = u_.data();
  g.x = x_.data();
  g.law = law_.data();
  g.out[0] = out_.data();
  return g;
}

void PairLoops::put_direction(const double* x, LocalIndex first, LocalIndex last) { put(x, d_, first, last, x_, 0); }

void PairLoops::clear_sums() { std::fill(out_.begin(), out_.end(), 0.0); }

void PairLoops::product_sums(Bonds bonds) { sweep(kernels::sweeps().pairs.product_sums, product_view(bonds)); }

void PairLoops::product_law() {
  for (int s = 0; s < owned_; ++s) {
    const std::size_t at = 4 * static_cast<std::size_t>(s);
    const double mean = u_[at + 3];
    const double flow = flow_[s] * (out_[at + 1] - mean * out_[at]);
    law_[at + kernels::flow] = flow;
    law_[at + kernels::along] = dilatation_[s] * out_[at] - mean * flow;
  }
  std::fill(out_.begin(), out_.end(), 0.0);
}

void PairLoops::product_forces(Bonds bonds) { sweep(kernels::sweeps().pairs.product_forces, product_view(bonds)); }

void PairLoops::take_forces(LocalIndex first, LocalIndex last, double* y) const { take(out_, 0, d_, first, last, y); }

void PairLoops::diagonal_blocks(const TangentLaw& law, double* blocks) {
  const int results = d_ * (d_ + 1) / 2 + d_ + (plastic_.empty() ? 0 : d_);
  Values out[3];
  for (Values& values : out) require(values);
  put(law.dilatation.data(), 1, 0, owned_, law_, kernels::along);
  put(law.flow.data(), 1, 0, owned_, law_, kernels::flow);
  kernels::PairView g = view(families_.interior(), plastic_.empty() ? nullptr : plastic_.data());
  g.place = reference_.data();
  g.u = u_.data();
  g.law = law_.data();
  for (int k = 0; k < 3; ++k) g.out[k] = out[k].data();
  both(kernels::sweeps().pairs.diagonal_blocks, g);
  double entries[12];
  for (int i = 0; i < local_; ++i) {
    const std::size_t at = 4 * static_cast<std::size_t>(slot_[i]);
    for (int k = 0; k < 12; ++k) entries[k] = out[k / 4][at + k % 4];
    finish_block(d_, i < owned_, entries, results, reference_[at + 3], i < owned_ ? law.dilatation[i] : 0,
                 i < owned_ ? law.flow[i] : 0, blocks + static_cast<std::size_t>(i) * d_ * d_);
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
