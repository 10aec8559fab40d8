#include "lattice_loops.hpp"

#include <algorithm>
#include <cmath>

#include "block_entries.hpp"

namespace perinox::mechanics {

namespace {
constexpr std::int64_t line = 8;  // doubles a cache line
/// Numbers of the arrays that the sweeps use together.
namespace place {
constexpr int u = 0, x = 3, law = 6, mean = 10, out = 11, state = 20, change = 26, yielded = 32;
}
}  // namespace

LatticeLoops::LatticeLoops(const Scene& scene, Purpose purpose)
    : FamilyLoops(scene, purpose),
      families_(*scene.lattice()),
      small_(purpose.small_strain),
      plastic_body_(scene.plastic_here()),
      moved_(!small_ || plastic_body_) {
  const bonds::CellGrid& grid = families_.grid();
  const double volume = families_.volume();
  for (const bonds::StencilOffset& offset : families_.offsets()) {
    kernels::Offset o;
    o.cell = offset.step[0] + offset.step[1] * grid.row + offset.step[2] * grid.plane;
    for (int k = 0; k < 3; ++k) o.bond[grid.axis[k]] = offset.step[k] * grid.spacing;
    o.length = offset.length;
    double direction[3] = {};  // along the body's axes
    for (int k = 0; k < 3; ++k) direction[k] = o.bond[k] / offset.length;
    const bonds::Mandel basis = bonds::mandel(d_, direction, offset.length);
    std::copy(basis.begin(), basis.end(), o.basis);
    o.inverse = 1 / offset.length;
    o.influence = offset.influence * offset.share * volume;
    o.radial = o.influence * offset.length;
    o.pair = o.influence * volume;
    offsets_.push_back(o);
    guard_ = std::max(guard_, std::abs(o.cell) + line);
  }
  for (const auto& block : families_.blocks()) blocks_.push_back({block.cell, block.mask});
  find_parts(scene.body().volume);
  fits_ = !fitted_.empty() || !part_.empty();
  if (fits_) find_fitted_blocks();
}

void LatticeLoops::find_parts(const std::vector<double>& volumes) {
  const double whole = families_.volume();
  if (std::none_of(volumes.begin(), volumes.end(), [&](double v) { return std::abs(v - whole) > 1e-12 * whole; }))
    return;
  require(part_, 1, place::yielded + 1);
  for (LocalIndex i = 0; i < local_; ++i)
    part_[0][families_.grid().cell[i]] = volumes[static_cast<std::size_t>(i)] / whole;
}

void LatticeLoops::bonds_changed() {
  for (std::size_t b = 0; b < blocks_.size(); ++b) blocks_[b].mask = families_.blocks()[b].mask;
}

void LatticeLoops::find_fitted_blocks() {
  std::vector<char> fitted(static_cast<std::size_t>(families_.grid().size()), 0);
  for (const LocalIndex i : fitted_) fitted[static_cast<std::size_t>(families_.grid().cell[i])] = 1;
  if (!part_.empty())  // the sweeps ask for them there only
    for (const std::int64_t cell : families_.grid().cell)
      if (std::abs(part_[0][cell] - 1) > 1e-12) fitted[static_cast<std::size_t>(cell)] = 1;
  const auto cells = static_cast<std::int64_t>(fitted.size());
  const auto any = [&](std::int64_t cell) {
    for (std::int64_t k = cell; k < cell + kernels::group; ++k)
      if (k >= 0 && k < cells && fitted[static_cast<std::size_t>(k)]) return true;
    return false;
  };
  for (const kernels::Block& block : blocks_) {
    const bool near = any(block.cell);
    bool found = near;
    const auto first = static_cast<std::int64_t>(fit_marks_.size());
    for (const kernels::Offset& offset : offsets_) {
      const bool mark = near || any(block.cell + offset.cell);
      found = found || mark;
      fit_marks_.push_back(mark ? 1 : 0);
    }
    if (!found) fit_marks_.resize(static_cast<std::size_t>(first));
    fitted_blocks_.push_back(found ? first : -1);
  }
  fit_marks_.shrink_to_fit();
}

void LatticeLoops::put_fits(const bonds::Mandel* values, GridArrays& arrays, int first) {
  if (!fits_) return;
  require(arrays, bonds::mandel_size(d_), first);
  for (std::size_t m = 0; m < fitted_.size(); ++m)
    for (int k = 0; k < bonds::mandel_size(d_); ++k) arrays[k][families_.grid().cell[fitted_[m]]] = values[m][k];
}

bonds::Mandel LatticeLoops::take_fit(std::size_t m, int array) const {
  bonds::Mandel sums{};
  for (int k = 0; k < bonds::mandel_size(d_); ++k) sums[k] = out_[array + k][families_.grid().cell[fitted_[m]]];
  return sums;
}

std::size_t LatticeLoops::bytes() const {
  return u_.bytes() + x_.bytes() + law_.bytes() + mean_.bytes() + out_.bytes() + state_.bytes() + change_.bytes() +
         yielded_.bytes() + part_.bytes() +
         fitted_.size() * (sizeof(LocalIndex) + sizeof(slope_[0]) + sizeof(modulus_[0])) +
         fitted_blocks_.size() * sizeof(fitted_blocks_[0]) + fit_marks_.size() +
         (dilatation_.size() + flow_.size() + ghosts_.size() + plastic_.size()) * sizeof(double) +
         blocks_.size() * sizeof(kernels::Block);
}

LoopMemory LatticeLoops::expected() const {
  const std::int64_t cells = families_.grid().size();
  const auto arrays = [&](int count) { return GridArrays::bytes_of(count, cells, guard_); };
  const std::size_t own = blocks_.size() * sizeof(kernels::Block);
  LoopMemory memory;
  memory.evaluation = arrays(d_) + arrays(1) + arrays(strain_results()) + arrays(2) + own;
  memory.tangent = arrays(d_) + arrays(small_ ? 3 : 4) + arrays(product_results()) + own +
                   static_cast<std::size_t>(cells) * sizeof(double);
  if (moved_) memory.tangent += arrays(d_);
  if (back_stress_) memory.evaluation += arrays(1);
  if (!part_.empty()) memory.evaluation += arrays(1), memory.tangent += arrays(1);
  if (back_stress_ && !small_) memory.tangent += arrays(1);
  if (fits_) {
    const std::size_t lists =
        fitted_.size() * sizeof(LocalIndex) + blocks_.size() * sizeof(fitted_blocks_[0]) + fit_marks_.size();
    memory.evaluation += arrays(bonds::mandel_size(d_)) + lists;
    memory.tangent += (small_ ? 1 : 2) * arrays(bonds::mandel_size(d_)) + lists +
                      fitted_.size() * (sizeof(slope_[0]) + sizeof(modulus_[0]));
  }
  if (local_ > owned_) memory.tangent += static_cast<std::size_t>(local_) * d_ * sizeof(double);
  if (!plastic_body_) return memory;
  memory.tangent += arrays(1) + static_cast<std::size_t>(cells) * sizeof(double) + blocks_.size() * sizeof(double*);
  memory.plastic = blocks_.size() * (offsets_.size() * 2 * kernels::group * sizeof(double) + sizeof(double*));
  return memory;
}

int LatticeLoops::strain_results() const {
  return !fits_ ? 3 : kernels::first_plastic_fit + (plastic_body_ ? bonds::mandel_size(d_) : 0);
}
int LatticeLoops::product_results() const {
  return !fits_ ? std::max(d_, 2) : kernels::first_fit_change + bonds::mandel_size(d_);
}

void LatticeLoops::require(GridArrays& arrays, int count, int first) {
  if (arrays.empty()) arrays.allocate(count, families_.grid().size(), guard_, first);
}

kernels::LatticeView LatticeLoops::view(double* const* plastic, Range range) const {
  const std::size_t first = range == boundary ? families_.interior() : 0;
  const std::size_t last = range == interior ? families_.interior() : blocks_.size();
  kernels::LatticeView view;
  view.offsets = offsets_.data();
  view.offset_count = static_cast<int>(offsets_.size());
  view.blocks = blocks_.data() + first;
  view.block_count = static_cast<std::int64_t>(last - first);
  view.masks = families_.masks().data();
  view.plastic = plastic ? plastic + first : nullptr;
  view.fitted = fitted_blocks_.empty() ? nullptr : fitted_blocks_.data() + first;
  view.fit_marks = fit_marks_.data();
  if (!state_.empty())
    for (int k = 0; k < bonds::mandel_size(d_); ++k) view.state[k] = state_[k];
  if (!change_.empty())
    for (int k = 0; k < bonds::mandel_size(d_); ++k) view.change[k] = change_[k];
  view.volume = families_.volume();
  view.part = part_.empty() ? nullptr : part_[0];
  return view;
}

void LatticeLoops::put_yielded(const double* values) {
  if (!values) return;
  require(yielded_, 1, place::yielded);
  put(values, 1, 0, owned_, yielded_, 0);
}

double LatticeLoops::volume_of(LocalIndex i) const {
  return part_.empty() ? families_.volume() : families_.volume() * part_[0][families_.grid().cell[i]];
}

const double* LatticeLoops::yielded_of_tangent() const { return yielded_.empty() ? law_[kernels::shear] : yielded_[0]; }

void LatticeLoops::put(const double* values, int components, int first, int last, GridArrays& arrays, int array) const {
  const std::vector<std::int64_t>& cell = families_.grid().cell;
  for (int c = 0; c < components; ++c) {
    double* to = arrays[array + c];
    for (int i = first; i < last; ++i) to[cell[i]] = values[static_cast<std::size_t>(i) * components + c];
  }
}

void LatticeLoops::take(const GridArrays& arrays, int array, int components, int first, int last,
                        double* values) const {
  const std::vector<std::int64_t>& cell = families_.grid().cell;
  for (int c = 0; c < components; ++c) {
    const double* from = arrays[array + c];
    for (int i = first; i < last; ++i) values[static_cast<std::size_t>(i) * components + c] = from[cell[i]];
  }
}

void LatticeLoops::sweep(kernels::LatticeSweeps::Sweep run, kernels::LatticeView view) const { run(view, d_, small_); }

void LatticeLoops::begin_strains(const double* shift) {
  require(u_, d_, place::u);
  require(mean_, 1, place::mean);
  require(out_, strain_results(), place::out);
  put(shift, 1, 0, owned_, mean_, 0);
  for (int k = 0; k < strain_results(); ++k) out_.clear(k);
}

void LatticeLoops::put_displacement(const double* displacement, LocalIndex first, LocalIndex last) {
  put(displacement, d_, first, last, u_, 0);
}

void LatticeLoops::sweep_strains(Bonds bonds, const PlasticExtension& plastic) {
  kernels::LatticeView g = view(plastic.chunks(), range_of(bonds));
  for (int c = 0; c < d_; ++c) g.u[c] = u_[c];
  g.mean = mean_[0];
  for (int k = 0; k < strain_results(); ++k) g.out[k] = out_[k];
  sweep(kernels::sweeps().lattice.strain_sums, g);
}

void LatticeLoops::take_strains(bool flowed, StrainSums& sums) const {
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
  take(out_, 0, 1, 0, owned_, sums.extension.data());
  take(out_, 1, 1, 0, owned_, sums.square.data());
  if (flowed) take(out_, 2, 1, 0, owned_, sums.plastic.data());
}

void LatticeLoops::begin_forces(const double* radial, const double* shear, const double* yielded,
                                const bonds::Mandel* state) {
  require(law_, 2, place::law);
  put_yielded(yielded);
  put_fits(state, state_, place::state);
  put(radial, 1, 0, owned_, law_, 0);
  put(shear, 1, 0, owned_, law_, 1);
  for (int c = 0; c < d_; ++c) out_.clear(c);
}

kernels::LatticeView LatticeLoops::force_view(const PlasticExtension& plastic, Range range) const {
  kernels::LatticeView g = view(plastic.chunks(), range);
  for (int c = 0; c < d_; ++c) {
    g.u[c] = u_[c];
    g.out[c] = out_[c];
  }
  g.law[kernels::radial] = law_[0];
  g.law[kernels::shear] = law_[1];
  g.law[kernels::along] = yielded_.empty() ? law_[1] : yielded_[0];
  return g;
}

void LatticeLoops::sweep_forces(Bonds bonds, const PlasticExtension& plastic) {
  sweep(kernels::sweeps().lattice.forces, force_view(plastic, range_of(bonds)));
}

double LatticeLoops::sweep_turning(const PlasticExtension& plastic, const double* step) {
  require(x_, d_, place::x);
  put(step, d_, 0, local_, x_, 0);
  kernels::LatticeView g = force_view(plastic, every);
  for (int c = 0; c < d_; ++c) g.x[c] = x_[c];
  sweep(kernels::sweeps().lattice.turning_work, g);
  double work = 0;
  for (const std::int64_t cell : families_.grid().cell) work += out_[0][cell];
  return work;
}

void LatticeLoops::linearise(const double* displacement, const TangentLaw& law, const PlasticExtension& plastic) {
  if (moved_) {
    require(u_, d_, place::u);
    put(displacement, d_, 0, local_, u_, 0);
  }
  if (plastic_body_) {
    require(mean_, 1, place::mean);
    put(law.mean.data(), 1, 0, owned_, mean_, 0);
  }
  require(x_, d_, place::x);
  require(law_, small_ ? 3 : 4, place::law);
  require(out_, product_results(), place::out);
  if (!small_) put_fits(law.state.data(), state_, place::state);
  if (fits_) require(change_, bonds::mandel_size(d_), place::change);
  keep_fits(law);
  if (!small_) put(law.radial.data(), 1, 0, owned_, law_, kernels::radial);
  put(law.shear.data(), 1, 0, owned_, law_, kernels::shear);
  if (!small_) put_yielded(law.yielded.empty() ? nullptr : law.yielded.data());
  const std::vector<std::int64_t>& cell = families_.grid().cell;
  const auto cells = static_cast<std::size_t>(families_.grid().size());
  const bool flows = std::any_of(law.flow.begin(), law.flow.end(), [](double flow) { return flow != 0; });
  dilatation_.assign(cells, 0.0);
  flow_.assign(flows ? cells : 0, 0.0);
  for (int i = 0; i < owned_; ++i) {
    dilatation_[cell[i]] = law.dilatation[i];
    if (flows) flow_[cell[i]] = law.flow[i];
  }
  for (const LocalIndex i : fitted_) dilatation_[cell[i]] = 0;
  plastic_.clear();
  if (plastic.chunks()) plastic_.assign(plastic.chunks(), plastic.chunks() + blocks_.size());
  if (!flows) {
    law_.clear(kernels::flow);
    return;
  }
  // A family that flows for the first time has its rank-one term already, and no plastic extension yet.
  plastic_.resize(blocks_.size(), nullptr);
  none_.assign(offsets_.size() * 2 * kernels::group, 0.0);
  put(law.flow.data(), 1, 0, owned_, law_, kernels::flow);
  const std::vector<char> flowing = flowing_blocks(law_[kernels::flow]);
  for (std::size_t b = 0; b < blocks_.size(); ++b)
    if (flowing[b] && !plastic_[b]) plastic_[b] = none_.data();
}

std::vector<char> LatticeLoops::flowing_blocks(const double* flow) const {
  const auto any = [&](std::int64_t cell) {
    for (std::int64_t lane = 0; lane < kernels::group; ++lane)
      if (flow[cell + lane] != 0) return true;
    return false;
  };
  std::vector<char> flowing(blocks_.size(), 0);
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    bool found = any(blocks_[b].cell);
    for (std::size_t o = 0; o < offsets_.size() && !found; ++o) found = any(blocks_[b].cell + offsets_[o].cell);
    flowing[b] = found ? 1 : 0;
  }
  return flowing;
}

kernels::LatticeView LatticeLoops::product_view(Bonds bonds) const {
  double* const* plastic = plastic_.empty() ? nullptr : plastic_.data();
  kernels::LatticeView g = view(plastic, bonds == Bonds::inner ? interior : boundary);
  for (int c = 0; c < d_; ++c) {
    g.u[c] = moved_ ? u_[c] : nullptr;
    g.x[c] = x_[c];
  }
  g.x[3] = yielded_of_tangent();
  for (int k = 0; k < (small_ ? 3 : 4); ++k) g.law[k] = law_[k];
  for (int k = 0; k < product_results(); ++k) g.out[k] = out_[k];
  return g;
}

void LatticeLoops::put_direction(const double* x, LocalIndex first, LocalIndex last) { put(x, d_, first, last, x_, 0); }

void LatticeLoops::clear_sums() {
  const int sums = !fits_ ? 2 : product_results();
  for (int k = 0; k < sums; ++k) out_.clear(k);
}

void LatticeLoops::product_sums(Bonds bonds) { sweep(kernels::sweeps().lattice.product_sums, product_view(bonds)); }

void LatticeLoops::product_law() {
  const std::int64_t cells = families_.grid().size();
  double *along = law_[kernels::along], *flow = law_[kernels::flow];
  const double *first = out_[0], *second = out_[1];
  if (flow_.empty()) {
    for (std::int64_t c = 0; c < cells; ++c) along[c] = dilatation_[c] * first[c];
  } else {
    const double* mean = mean_[0];
    for (std::int64_t c = 0; c < cells; ++c) {
      flow[c] = flow_[c] * (second[c] - mean[c] * first[c]);
      along[c] = dilatation_[c] * first[c] - mean[c] * flow[c];
    }
  }
  for (std::size_t m = 0; m < fitted_.size(); ++m) {
    const std::int64_t c = families_.grid().cell[fitted_[m]];
    const FitChange fit =
        change_of_fit(m, take_fit(m, kernels::first_fit_change), second[c], flow_.empty() ? 0 : flow_[c]);
    along[c] = 0;
    flow[c] = fit.flow;
    for (int k = 0; k < bonds::mandel_size(d_); ++k) change_[k][c] = fit.change[k];
  }
  for (int c = 0; c < d_; ++c) out_.clear(c);
}

void LatticeLoops::product_forces(Bonds bonds) { sweep(kernels::sweeps().lattice.product_forces, product_view(bonds)); }

void LatticeLoops::take_forces(LocalIndex first, LocalIndex last, double* y) const {
  take(out_, 0, d_, first, last, y);
}

void LatticeLoops::diagonal_blocks(const TangentLaw& law, double* blocks) {
  const int n = bonds::mandel_size(d_);
  const int results = !fits_ ? n + d_ + (plastic_.empty() ? 0 : d_) : kernels::first_fit_gradient + n * d_;
  GridArrays out;
  require(out, results, place::x);
  put(law.dilatation.data(), 1, 0, owned_, law_, kernels::along);
  put(law.flow.data(), 1, 0, owned_, law_, kernels::flow);
  kernels::LatticeView g = view(plastic_.empty() ? nullptr : plastic_.data(), every);
  for (int c = 0; c < d_; ++c) g.u[c] = moved_ ? u_[c] : nullptr;
  for (int k = 0; k < (small_ ? 3 : 4); ++k) g.law[k] = law_[k];
  g.x[3] = yielded_of_tangent();
  if (plastic_body_) g.mean = mean_[0];
  for (int k = 0; k < results; ++k) g.out[k] = out[k];
  sweep(kernels::sweeps().lattice.diagonal_blocks, g);
  std::vector<double> entries(static_cast<std::size_t>(results));
  for (int i = 0; i < local_; ++i) {
    for (int k = 0; k < results; ++k) entries[k] = out[k][families_.grid().cell[i]];
    const OwnTerms own = i < owned_ ? own_terms(law, i, fit_of(i), volume_of(i)) : OwnTerms();
    finish_block(d_, entries.data(), !plastic_.empty(), i < owned_ ? &own : nullptr,
                 blocks + static_cast<std::size_t>(i) * d_ * d_);
  }
}

void LatticeLoops::advance(const double* displacement, const double* mean, const double* flow,
                           PlasticExtension& plastic) {
  require(u_, d_, place::u);
  require(mean_, 1, place::mean);
  GridArrays flowing;
  require(flowing, 1, place::law);
  put(displacement, d_, 0, local_, u_, 0);
  put(mean, 1, 0, owned_, mean_, 0);
  put(flow, 1, 0, owned_, flowing, 0);
  const std::vector<char> needed = flowing_blocks(flowing[0]);
  for (std::size_t b = 0; b < blocks_.size(); ++b)
    if (needed[b]) plastic.require(b, blocks_.size(), offsets_.size() * 2 * kernels::group);
  kernels::LatticeView g = view(plastic.chunks(), every);
  for (int c = 0; c < d_; ++c) g.u[c] = u_[c];
  g.mean = mean_[0];
  g.law[kernels::flow] = flowing[0];
  sweep(kernels::sweeps().lattice.advance, g);
}

}  // namespace perinox::mechanics
