#include "stored_tangent.hpp"

#include <algorithm>

#include "kinematics.hpp"

namespace perinox::mechanics {

namespace {
constexpr std::size_t pool_block_values = std::size_t{1} << 20;
}

StoredTangent::StoredTangent(const Scene& scene)
    : Tangent(scene),
      direction_(static_cast<std::size_t>(scene.bonds().count() * scene.dimension())),
      diagonal_(static_cast<std::size_t>(scene.bonds().count())),
      geometric_(static_cast<std::size_t>(scene.bonds().count())),
      x_(scene.local_unknowns()),
      y_(scene.local_unknowns()) {}

std::size_t StoredTangent::bytes() const {
  std::size_t values = direction_.size() + diagonal_.size() + geometric_.size() + x_.size() + y_.size();
  for (const auto& block : pool_) values += block.size();
  return values * sizeof(double) + terms_.size() * sizeof(Term) + term_begin_.size() * sizeof(std::int64_t);
}

double* StoredTangent::keep(const double* values, int count) {
  const auto need = static_cast<std::size_t>(count);
  while (pool_block_ < pool_.size() && pool_used_ + need > pool_[pool_block_].size()) {
    ++pool_block_;
    pool_used_ = 0;
  }
  if (pool_block_ == pool_.size()) pool_.emplace_back(std::max(need, pool_block_values));
  double* place = pool_[pool_block_].data() + pool_used_;
  std::copy(values, values + count, place);
  pool_used_ += need;
  return place;
}

bool StoredTangent::linearise(const Committed& committed, const medium::At& at, deck::TangentForm form) {
  const double* displacement = at.displacement;
  std::copy(displacement, displacement + scene_.owned_unknowns(), x_.begin());
  scene_.body().halo.update_ghosts(x_.data(), scene_.dimension());
  pool_block_ = pool_used_ = 0;
  terms_.clear();
  term_begin_.assign(1, 0);
  if (scene_.dimension() == 3)
    linearise_points<3>(committed, form);
  else
    linearise_points<2>(committed, form);
  return true;
}

template <int d>
void StoredTangent::linearise_points(const Committed& committed, deck::TangentForm form) {
  const auto largest = static_cast<std::size_t>(scene_.largest_family());
  std::vector<double> extension(largest), stretched(largest), force_state(largest), trial_point, trial_bond;
  const std::vector<double> plastic = scene_.plastic() ? committed.plastic().per_bond(scene_) : std::vector<double>();
  materials::ModulusState modulus;
  for (LocalIndex i = 0; i < scene_.owned(); ++i) {
    materials::Family family = scene_.family(i);
    family.broken_elastic = committed.broken_elastic(scene_, i);
    const auto first = static_cast<std::size_t>(scene_.bonds().offset[i]);
    family_kinematics<d>(scene_, i, x_.data(), extension.data(), &direction_[first * d], stretched.data());
    trial_point.resize(static_cast<std::size_t>(scene_.point_history()[i + 1] - scene_.point_history()[i]));
    const double* bond_history = plastic.empty() ? nullptr : plastic.data() + first;
    std::size_t bond_values = plastic.empty() ? 0 : largest;
    if (!scene_.from_sums()) {
      bond_history = committed.bond_history().data() + scene_.bond_history()[i];
      bond_values = static_cast<std::size_t>(scene_.bond_history()[i + 1] - scene_.bond_history()[i]);
    }
    trial_bond.resize(bond_values);
    const materials::CommittedHistory history{committed.point_history(scene_, i), bond_history};
    scene_.material(i).respond(family, extension.data(), history, force_state.data(),
                               {trial_point.data(), trial_bond.data()});
    scene_.material(i).modulus(family, extension.data(), history, form, modulus);
    std::copy(modulus.diagonal(), modulus.diagonal() + family.count, &diagonal_[first]);
    for (int j = 0; j < family.count; ++j)
      geometric_[first + j] = scene_.small_strain() ? 0 : force_state[j] / stretched[j];
    for (int r = 0; r < modulus.rank(); ++r) {
      const materials::ModulusState::Term& term = modulus.term(r);
      if (term.radial) {
        terms_.push_back({term.coefficient, nullptr, nullptr});
        continue;
      }
      const double* p = keep(term.p, family.count);
      terms_.push_back({term.coefficient, p, term.q == term.p ? p : keep(term.q, family.count)});
    }
    term_begin_.push_back(static_cast<std::int64_t>(terms_.size()));
  }
}

void StoredTangent::apply(const double* x, double* y) const {
  const Profile::Scope timed(scene_.body().communicator.profile(), Section::product);
  std::copy(x, x + scene_.owned_unknowns(), x_.begin());
  scene_.body().halo.update_ghosts(x_.data(), scene_.dimension());
  std::fill(y_.begin(), y_.end(), 0.0);
  if (scene_.dimension() == 3)
    apply_points<3>(y_.data());
  else
    apply_points<2>(y_.data());
  scene_.body().halo.add_to_owners(y_.data(), scene_.dimension());
  std::copy(y_.begin(), y_.begin() + static_cast<std::ptrdiff_t>(scene_.owned_unknowns()), y);
}

template <int d>
void StoredTangent::apply_points(double* y) const {
  const bonds::Bonds& bonds = scene_.bonds();
  const auto largest = static_cast<std::size_t>(scene_.largest_family());
  std::vector<double> change(largest), relative(largest * d), state_change(largest);
  for (LocalIndex i = 0; i < scene_.owned(); ++i) {
    const auto first = static_cast<std::size_t>(bonds.offset[i]);
    const int count = bonds.family_size(i);
    const LocalIndex* neighbor = &bonds.neighbor[first];
    const double* weight = &bonds.weight[first];
    const double* xi = &x_[static_cast<std::size_t>(i) * d];
    for (int j = 0; j < count; ++j) {  // de = M . dU, and D de
      const double* xj = &x_[static_cast<std::size_t>(neighbor[j]) * d];
      const double* m = &direction_[(first + j) * d];
      double sum = 0;
      for (int c = 0; c < d; ++c) {
        relative[j * d + c] = xj[c] - xi[c];
        sum += m[c] * (xj[c] - xi[c]);
      }
      change[j] = sum;
      state_change[j] = diagonal_[first + j] * sum;
    }
    for (std::int64_t r = term_begin_[i]; r < term_begin_[i + 1]; ++r) {
      const Term& term = terms_[r];
      double contraction = 0;
      for (int j = 0; j < count; ++j) contraction += entry(term.q, bonds, bonds.offset[i], j) * change[j] * weight[j];
      contraction *= term.coefficient;
      for (int j = 0; j < count; ++j) state_change[j] += contraction * entry(term.p, bonds, bonds.offset[i], j);
    }
    double own[d] = {};
    const double volume = scene_.body().volume[i];
    for (int j = 0; j < count; ++j) {  // dT = dt M + (t/|Y|)(dU - M de)
      const double* m = &direction_[(first + j) * d];
      const double g = geometric_[first + j];
      const double along = state_change[j] - g * change[j];
      double* yj = y + static_cast<std::size_t>(neighbor[j]) * d;
      for (int c = 0; c < d; ++c) {
        const double pull = volume * weight[j] * (along * m[c] + g * relative[j * d + c]);
        own[c] += pull;
        yj[c] += pull;
      }
    }
    for (int c = 0; c < d; ++c) y[static_cast<std::size_t>(i) * d + c] -= own[c];
  }
}

void StoredTangent::diagonal_blocks(double* blocks, double dilatation) const {
  const int d = scene_.dimension();
  const auto values = static_cast<std::size_t>(d * d);
  std::vector<double> all(static_cast<std::size_t>(scene_.local()) * values, 0.0);
  if (d == 3)
    block_points<3>(all.data(), dilatation);
  else
    block_points<2>(all.data(), dilatation);
  scene_.body().halo.add_to_owners(all.data(), d * d);
  std::copy(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(scene_.owned() * values), blocks);
}

template <int d>
void StoredTangent::block_points(double* blocks, double dilatation) const {
  const bonds::Bonds& bonds = scene_.bonds();
  for (LocalIndex i = 0; i < scene_.owned(); ++i) {
    const auto first = static_cast<std::size_t>(bonds.offset[i]);
    const int count = bonds.family_size(i);
    const double volume = scene_.body().volume[i];
    double* own = blocks + static_cast<std::size_t>(i) * d * d;
    const int terms = rank(i);
    double p_sum[materials::ModulusState::max_rank][d] = {};
    double q_sum[materials::ModulusState::max_rank][d] = {};
    const auto coefficient = [&](int r) { return term(i, r).coefficient * (term(i, r).p ? 1 : dilatation); };
    for (int j = 0; j < count; ++j) {
      const std::size_t b = first + j;
      const double* m = &direction_[b * d];
      const double w = bonds.weight[b];
      double low_rank = 0;  // the neighbour's own entry of the rank-one terms
      for (int r = 0; r < terms; ++r) {
        const Term& one = term(i, r);
        const double p = entry(one.p, bonds, bonds.offset[i], j) * w;
        const double q = entry(one.q, bonds, bonds.offset[i], j) * w;
        low_rank += coefficient(r) * p * q;
        for (int c = 0; c < d; ++c) {
          p_sum[r][c] += p * m[c];
          q_sum[r][c] += q * m[c];
        }
      }
      double* other = blocks + static_cast<std::size_t>(bonds.neighbor[b]) * d * d;
      const double g = geometric_[b];
      for (int c = 0; c < d; ++c)
        for (int e = 0; e < d; ++e) {
          const double local = w * ((diagonal_[b] - g) * m[c] * m[e] + (c == e ? g : 0.0));
          own[c * d + e] += volume * local;
          other[c * d + e] += volume * (local + low_rank * m[c] * m[e]);
        }
    }
    for (int r = 0; r < terms; ++r)
      for (int c = 0; c < d; ++c)
        for (int e = 0; e < d; ++e) own[c * d + e] += volume * coefficient(r) * p_sum[r][c] * q_sum[r][e];
  }
}

}  // namespace perinox::mechanics
