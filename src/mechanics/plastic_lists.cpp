#include "plastic_lists.hpp"

#include <algorithm>
#include <array>

#include "perinox/mechanics/scene.hpp"

namespace perinox::mechanics {

namespace {

constexpr std::size_t lanes = 8;
using Lattice = bonds::LatticeFamilies;

struct Entry {
  GlobalId id;
  double* place;  ///< null where there is no chunk
};

void sort_by_id(std::vector<Entry>& entries) {
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.id < b.id; });
}

/// Ends of a lattice's bonds as the steps ascend along the axes in turn, the last most slowly.
std::vector<Lattice::End> ends_along(const Lattice& lattice, const std::array<int, 3>& axes) {
  std::vector<Lattice::End> ends;
  for (int o = 0; o < static_cast<int>(lattice.offsets().size()); ++o)
    for (const bool far : {false, true}) ends.push_back(lattice.end(o, far));
  const auto key = [&](const Lattice::End& end) {
    const std::array<int, 3>& step = lattice.offsets()[static_cast<std::size_t>(end.offset)].step;
    const int sign = end.far ? -1 : 1;
    return std::array<int, 3>{sign * step[axes[2]], sign * step[axes[1]], sign * step[axes[0]]};
  };
  std::sort(ends.begin(), ends.end(), [&](const auto& a, const auto& b) { return key(a) < key(b); });
  return ends;
}

}  // namespace

class PlasticLists::Order {
 public:
  virtual ~Order() = default;
  /// Appends e_p of particle i's bonds.
  virtual void read(double* const* chunks, LocalIndex i, std::vector<double>& values) = 0;
  /// Places of e_p of particle i's bonds.
  virtual const std::vector<Entry>& places(double* const* chunks, LocalIndex i) = 0;
};

/// Lattices are mostly numbered axis by axis: in the right order of these the bonds need no sorting.
class PlasticLists::OfLattice : public Order {
 public:
  explicit OfLattice(const Scene& scene)
      : lattice_(*scene.lattice()), id_(scene.body().id), ends_(ends_along(lattice_, {0, 1, 2})) {}

  void read(double* const* chunks, LocalIndex i, std::vector<double>& values) override {
    family_.resize(ends_.size());
    double* next = family_.data();
    GlobalId last = -1;
    bool ascending = true;
    lattice_.each_of(i, ends_, [&](const Lattice::Place& place) {
      const GlobalId id = id_[place.neighbor];
      ascending = ascending && id > last;
      last = id;
      const double* at = place_of(chunks, place);
      *next++ = at ? *at : 0;
    });
    if (ascending) {
      values.insert(values.end(), family_.data(), next);
      return;
    }
    for (const Entry& entry : places(chunks, i)) values.push_back(entry.place ? *entry.place : 0);
  }

  const std::vector<Entry>& places(double* const* chunks, LocalIndex i) override {
    if (take(chunks, i)) return entries_;
    if (entries_.size() > largest_) {  // a small family may fit several orders
      largest_ = entries_.size();
      std::array<int, 3> axes{0, 1, 2};
      do {
        ends_ = ends_along(lattice_, axes);
        if (take(chunks, i)) return entries_;
      } while (std::next_permutation(axes.begin(), axes.end()));
    }
    sort_by_id(entries_);
    return entries_;
  }

 private:
  static double* place_of(double* const* chunks, const Lattice::Place& place) {
    double* chunk = chunks ? chunks[place.block] : nullptr;
    return chunk ? chunk + (2 * static_cast<std::size_t>(place.offset) + (place.far ? 1 : 0)) * lanes +
                       static_cast<std::size_t>(place.lane)
                 : nullptr;
  }
  /// In the order of the ends; whether that is the one of the ids.
  bool take(double* const* chunks, LocalIndex i) {
    entries_.clear();
    lattice_.each_of(i, ends_, [&](const Lattice::Place& place) {
      entries_.push_back({id_[place.neighbor], place_of(chunks, place)});
    });
    return std::is_sorted(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) { return a.id < b.id; });
  }

  const Lattice& lattice_;
  const std::vector<GlobalId>& id_;
  std::vector<Lattice::End> ends_;
  std::size_t largest_ = 0;  ///< of the families that were out of order
  std::vector<double> family_;
  std::vector<Entry> entries_;
};

/// A pair stands with its near end; who keeps the pairs whose far end a particle is has to be noted first.
class PlasticLists::OfPairs : public Order {
 public:
  explicit OfPairs(const Scene& scene)
      : pairs_(*scene.pairs()), id_(scene.body().id), begin_(static_cast<std::size_t>(scene.owned()) + 1, 0) {
    const int owned = scene.owned();
    for (const std::int32_t far : pairs_.far())
      if (far < owned) ++begin_[static_cast<std::size_t>(far) + 1];
    for (std::size_t s = 1; s < begin_.size(); ++s) begin_[s] += begin_[s - 1];
    near_.resize(static_cast<std::size_t>(begin_.back()));
    std::vector<std::int64_t> next(begin_.begin(), begin_.end() - 1);
    for (int s = 0; s < owned; ++s)
      for (std::int64_t p = pairs_.begin()[s]; p < pairs_.begin()[s + 1]; ++p)
        if (pairs_.far()[p] < owned) near_[next[pairs_.far()[p]]++] = s;
  }

  void read(double* const* chunks, LocalIndex i, std::vector<double>& values) override {
    for (const Entry& entry : places(chunks, i)) values.push_back(entry.place ? *entry.place : 0);
  }

  const std::vector<Entry>& places(double* const* chunks, LocalIndex i) override {
    entries_.clear();
    const int own = pairs_.slot()[i], none = pairs_.slots() - 1;
    for (std::int64_t p = pairs_.begin()[own]; p < pairs_.begin()[own + 1]; ++p)
      if (pairs_.far()[p] != none) take(chunks, own, p, pairs_.far()[p], false);
    for (std::int64_t k = begin_[own]; k < begin_[own + 1]; ++k) {
      const std::int32_t* const far = pairs_.far().data();
      const int near = near_[k];
      const std::int32_t* const found = std::find(far + pairs_.begin()[near], far + pairs_.begin()[near + 1], own);
      take(chunks, near, found - far, near, true);
    }
    sort_by_id(entries_);
    return entries_;
  }

 private:
  void take(double* const* chunks, int near, std::int64_t pair, int other, bool far_end) {
    double* chunk = chunks ? chunks[near] : nullptr;
    const auto k = static_cast<std::size_t>(pair - pairs_.begin()[near]);
    entries_.push_back({id_[pairs_.particle()[other]],
                        chunk ? chunk + (2 * (k / lanes) + (far_end ? 1 : 0)) * lanes + k % lanes : nullptr});
  }

  const bonds::PairFamilies& pairs_;
  const std::vector<GlobalId>& id_;
  std::vector<std::int64_t> begin_;  ///< [owned slots + 1] into near_
  std::vector<int> near_;            ///< slots that keep the pairs whose far end a slot is
  std::vector<Entry> entries_;
};

PlasticLists::PlasticLists(const Scene& scene) {
  if (scene.lattice())
    order_ = std::make_unique<OfLattice>(scene);
  else
    order_ = std::make_unique<OfPairs>(scene);
}

PlasticLists::~PlasticLists() = default;
PlasticLists::PlasticLists(PlasticLists&&) noexcept = default;

void PlasticLists::read(const PlasticExtension& extension, const std::vector<LocalIndex>& particles,
                        std::vector<double>& values) {
  for (const LocalIndex i : particles) order_->read(extension.chunks(), i, values);
}

void PlasticLists::write(PlasticExtension& extension, const std::vector<LocalIndex>& particles,
                         const std::vector<double>& values) {
  const double* next = values.data();
  for (const LocalIndex i : particles)
    for (const Entry& entry : order_->places(extension.chunks(), i)) {
      if (entry.place) *entry.place = *next;
      ++next;
    }
}

}  // namespace perinox::mechanics
