#include "perinox/bonds/pair_families.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>

namespace perinox::bonds {

namespace {

/// Spreads the 21 low bits of `value` to every third bit of the result.
std::uint64_t spread(std::uint64_t value) {
  value &= 0x1fffff;
  value = (value | value << 32) & 0x1f00000000ffffULL;
  value = (value | value << 16) & 0x1f0000ff0000ffULL;
  value = (value | value << 8) & 0x100f00f00f00f00fULL;
  value = (value | value << 4) & 0x10c30c30c30c30c3ULL;
  return (value | value << 2) & 0x1249249249249249ULL;
}

/// Particles first to last - 1 in the order of the curve.
std::vector<LocalIndex> curve(const body::Body& body, int first, int last) {
  const int d = body.dimension;
  std::array<double, 3> low{}, high{};
  low.fill(std::numeric_limits<double>::infinity());
  high.fill(-std::numeric_limits<double>::infinity());
  for (int i = first; i < last; ++i)
    for (int c = 0; c < d; ++c) {
      low[c] = std::min(low[c], body.position(i)[c]);
      high[c] = std::max(high[c], body.position(i)[c]);
    }
  double extent = 0;
  for (int c = 0; c < d; ++c) extent = std::max(extent, high[c] - low[c]);
  std::vector<std::pair<std::uint64_t, LocalIndex>> keys;
  for (int i = first; i < last; ++i) {
    std::uint64_t key = 0;
    for (int c = 0; c < d; ++c) {
      const double share = extent > 0 ? (body.position(i)[c] - low[c]) / extent : 0;
      key |= spread(static_cast<std::uint64_t>(share * 0x1fffff)) << c;
    }
    keys.emplace_back(key, i);
  }
  std::sort(keys.begin(), keys.end());
  std::vector<LocalIndex> order;
  for (const auto& [key, i] : keys) order.push_back(i);
  return order;
}

}  // namespace

std::vector<LocalIndex> curve_order(const body::Body& body) { return curve(body, 0, body.owned); }

PairFamilies::PairFamilies(const body::Body& body, std::vector<LocalIndex> order)
    : owned_(body.owned), particle_(std::move(order)), slot_(static_cast<std::size_t>(body.local())) {
  const std::vector<LocalIndex> ghosts = curve(body, body.owned, body.local());
  particle_.insert(particle_.end(), ghosts.begin(), ghosts.end());
  for (std::size_t s = 0; s < particle_.size(); ++s) slot_[particle_[s]] = static_cast<int>(s);
  begin_.push_back(0);
}

void PairFamilies::receive(LocalIndex i, const std::vector<FoundBond>& family, const body::Body& body) {
  const int own = slot_[i];
  bool ghosts = false;
  for (const FoundBond& bond : family) {
    if (slot_[bond.neighbor] < own) continue;
    far_.push_back(slot_[bond.neighbor]);
    length_.push_back(bond.length);
    weight_.push_back(bond.influence * bond.weight / body.volume[bond.neighbor]);
    ghosts = ghosts || bond.neighbor >= owned_;
  }
  while (far_.size() % lanes != 0) {
    far_.push_back(slots() - 1);
    length_.push_back(1);
    weight_.push_back(0);
  }
  begin_.push_back(static_cast<std::int64_t>(far_.size()));
  (ghosts ? boundary_ : interior_).push_back(own);
}

void PairFamilies::complete() {
  bool all_one = true;
  for (std::size_t k = 0; k < far_.size(); ++k)
    all_one = all_one && (far_[k] == slots() - 1 || std::abs(weight_[k] - 1) < 1e-14);
  if (all_one) weight_ = {};
  far_.shrink_to_fit();
  length_.shrink_to_fit();
  weight_.shrink_to_fit();
}

PairFamilies::Place PairFamilies::find(LocalIndex i, LocalIndex j) const {
  const int near = std::min(slot_[i], slot_[j]), other = std::max(slot_[i], slot_[j]);
  const auto first = far_.begin() + begin_[near], last = far_.begin() + begin_[near + 1];
  const auto found = std::find(first, last, other);
  return {found == last ? -1 : j, near, found - far_.begin(), near != slot_[i]};
}

PairFamilies::Removed PairFamilies::remove(LocalIndex i, LocalIndex j) {
  const Place place = find(i, j);
  if (place.neighbor < 0) return {};
  const auto k = static_cast<std::size_t>(place.pair);
  const Removed removed{length_[k], weight_.empty() ? 1.0 : weight_[k]};
  far_[k] = slots() - 1;
  length_[k] = 1;
  if (!weight_.empty()) weight_[k] = 0;
  return removed;
}

std::size_t PairFamilies::bytes() const {
  return particle_.size() * sizeof(LocalIndex) + slot_.size() * sizeof(int) + begin_.size() * sizeof(std::int64_t) +
         far_.size() * sizeof(std::int32_t) + (length_.size() + weight_.size()) * sizeof(double) +
         (interior_.size() + boundary_.size()) * sizeof(std::int32_t);
}

BondGraph PairFamilies::graph() const {
  struct Adjacency {
    std::vector<std::int64_t> begin;
    std::vector<LocalIndex> neighbor;
  };
  auto all = std::make_shared<Adjacency>();
  const int none = slots() - 1;
  all->begin.assign(static_cast<std::size_t>(owned_) + 1, 0);
  const auto each = [&](auto&& visit) {
    for (int s = 0; s < owned_; ++s)
      for (std::int64_t k = begin_[s]; k < begin_[s + 1]; ++k) {
        if (far_[k] == none) continue;
        visit(particle_[s], particle_[far_[k]]);
        if (far_[k] < owned_) visit(particle_[far_[k]], particle_[s]);
      }
  };
  each([&](LocalIndex i, LocalIndex) { ++all->begin[i + 1]; });
  std::partial_sum(all->begin.begin(), all->begin.end(), all->begin.begin());
  all->neighbor.resize(static_cast<std::size_t>(all->begin.back()));
  std::vector<std::int64_t> next(all->begin.begin(), all->begin.end() - 1);
  each([&](LocalIndex i, LocalIndex j) { all->neighbor[next[i]++] = j; });
  return [all](LocalIndex i, std::vector<LocalIndex>& neighbors) {
    neighbors.assign(all->neighbor.begin() + all->begin[i], all->neighbor.begin() + all->begin[i + 1]);
  };
}

std::vector<std::vector<PairFamilies::Place>> PairFamilies::places() const {
  std::vector<std::vector<Place>> all(static_cast<std::size_t>(owned_));
  for (int s = 0; s < owned_; ++s)
    for (std::int64_t k = begin_[s]; k < begin_[s + 1]; ++k) {
      if (far_[k] == slots() - 1) continue;
      const LocalIndex near = particle_[s], other = particle_[far_[k]];
      all[near].push_back({other, s, k, false});
      if (other < owned_) all[other].push_back({near, s, k, true});
    }
  return all;
}

}  // namespace perinox::bonds
