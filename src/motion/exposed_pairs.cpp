#include "perinox/motion/exposed_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "perinox/body/neighbor_search.hpp"

namespace perinox::motion {

ExposedPairs::ExposedPairs(const mechanics::Scene& scene, double reach, double margin)
    : scene_(scene), d_(static_cast<std::size_t>(scene.dimension())), reach_(reach), margin_(margin) {
  refresh();
}

void ExposedPairs::refresh() {
  exposed_ = find_exposed(scene_);
  listed_once_ = false;
}

bool ExposedPairs::move(const double* displacement) {
  const auto own = exposed_.particle.size();
  place_.resize(std::max(place_.size(), own * d_));
  for (std::size_t k = 0; k < own; ++k) {
    const auto i = exposed_.particle[k];
    for (std::size_t c = 0; c < d_; ++c)
      place_[k * d_ + c] = scene_.body().position(i)[c] + displacement[static_cast<std::size_t>(i) * d_ + c];
  }
  const Communicator& ranks = scene_.body().communicator;
  const bool stale = !listed_once_ || moved_too_far();
  if (ranks.size() > 1 ? ranks.any(stale) : stale) {
    make_list();
    return true;
  }
  if (ranks.size() == 1) return false;
  place_.resize(own * d_);
  place_ = share(std::move(place_), static_cast<int>(d_));
  return false;
}

bool ExposedPairs::moved_too_far() const {
  double most = 0;
  for (std::size_t k = 0; k < exposed_.particle.size(); ++k) {
    double square = 0;
    for (std::size_t c = 0; c < d_; ++c) {
      const double step = place_[k * d_ + c] - listed_[k * d_ + c];
      square += step * step;
    }
    most = std::max(most, square);
  }
  return !(most <= 0.25 * margin_ * margin_);  // also where it is not a number
}

void ExposedPairs::make_list() {
  ++lists_;
  listed_once_ = true;
  const auto own = exposed_.particle.size();
  place_.resize(own * d_);
  listed_ = place_;
  reference_.resize(own * d_);
  id_.resize(own);
  for (std::size_t k = 0; k < own; ++k) {
    std::copy_n(scene_.body().position(exposed_.particle[k]), d_, &reference_[k * d_]);
    id_[k] = static_cast<double>(scene_.body().id[exposed_.particle[k]]);  // exact up to 2^53
  }
  if (scene_.body().communicator.size() > 1) {
    choose_what_to_send();
    const int d = static_cast<int>(d_);
    place_ = share(std::move(place_), d);
    reference_ = share(std::move(reference_), d);
    id_ = share(std::move(id_), 1);
  }
  pairs_.clear();
  // What is not a number has no place in a tree; the energies tell that the run is over.
  if (place_.empty() || !std::all_of(place_.begin(), place_.end(), [](double x) { return std::isfinite(x); })) return;
  const body::NeighborSearch search(place_, scene_.dimension());
  std::vector<LocalIndex> found;
  for (int i = 0; i < static_cast<int>(own); ++i) {
    search.within(place(i), reach_ + margin_, found);
    const std::vector<GlobalId>& bonded = exposed_.bonded[static_cast<std::size_t>(i)];
    for (const LocalIndex j : found) {
      if (j < static_cast<int>(own) && j <= i) continue;
      if (std::binary_search(bonded.begin(), bonded.end(), static_cast<GlobalId>(id_[j]))) continue;
      pairs_.push_back({i, j});
    }
  }
}

void ExposedPairs::choose_what_to_send() {
  const Communicator& ranks = scene_.body().communicator;
  const auto size = static_cast<std::size_t>(ranks.size()), own = exposed_.particle.size();
  // Boxes of all ranks, wider by the reach of a list; where a rank has no exposed particle its box is empty.
  std::vector<double> box;
  for (std::size_t c = 0; c < d_; ++c) {
    double low = std::numeric_limits<double>::max(), high = -low;
    for (std::size_t k = 0; k < own; ++k) {
      low = std::min(low, place_[k * d_ + c]);
      high = std::max(high, place_[k * d_ + c]);
    }
    box.push_back(low - reach_ - margin_);
    box.push_back(high + reach_ + margin_);
  }
  const std::vector<double> boxes = ranks.gather(box);
  out_.clear();
  out_count_.assign(size, 0);
  in_count_.assign(size, 0);
  for (std::size_t r = 0; r < size; ++r) {
    if (static_cast<int>(r) == ranks.rank()) continue;
    const double* other = &boxes[r * 2 * d_];
    for (std::size_t k = 0; k < own; ++k) {
      bool inside = true;
      for (std::size_t c = 0; c < d_; ++c)
        inside = inside && place_[k * d_ + c] >= other[2 * c] && place_[k * d_ + c] <= other[2 * c + 1];
      if (!inside) continue;
      out_.push_back(static_cast<int>(k));
      ++out_count_[r];
    }
  }
  MPI_Alltoall(out_count_.data(), 1, MPI_INT, in_count_.data(), 1, MPI_INT, ranks.mpi());
}

std::vector<double> ExposedPairs::share(std::vector<double> values, int count) const {
  const Communicator& ranks = scene_.body().communicator;
  if (ranks.size() == 1) return values;
  const auto times_count = [count](std::vector<int> counts) {
    for (int& c : counts) c *= count;
    return counts;
  };
  const auto starts = [](const std::vector<int>& counts) {
    std::vector<int> begin{0};
    for (const int c : counts) begin.push_back(begin.back() + c);
    return begin;
  };
  const auto n = static_cast<std::size_t>(count);
  std::vector<double> out;
  for (const int k : out_) {
    const double* from = &values[static_cast<std::size_t>(k) * n];
    out.insert(out.end(), from, from + n);
  }
  const std::vector<int> out_count = times_count(out_count_), in_count = times_count(in_count_);
  const std::vector<int> from = starts(out_count), to = starts(in_count);
  const std::size_t own = values.size();
  values.resize(own + static_cast<std::size_t>(to.back()));
  MPI_Alltoallv(out.data(), out_count.data(), from.data(), MPI_DOUBLE, values.data() + own, in_count.data(), to.data(),
                MPI_DOUBLE, ranks.mpi());
  return values;
}

std::vector<double> ExposedPairs::listed() const {
  std::vector<double> places(scene_.owned_unknowns(), 0.0);
  for (std::size_t k = 0; k < exposed_.particle.size() && listed_once_; ++k)
    std::copy_n(&listed_[k * d_], d_, &places[static_cast<std::size_t>(exposed_.particle[k]) * d_]);
  return places;
}

void ExposedPairs::list_again(const std::vector<double>& listed) {
  place_.resize(exposed_.particle.size() * d_);
  for (std::size_t k = 0; k < exposed_.particle.size(); ++k)
    std::copy_n(&listed[static_cast<std::size_t>(exposed_.particle[k]) * d_], d_, &place_[k * d_]);
  make_list();
}

}  // namespace perinox::motion
