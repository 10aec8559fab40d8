/// The way from a particle's bonds to their plastic extension in the sweeps' own order.
#include <algorithm>
#include <array>
#include <numeric>

#include "perinox/mechanics/plastic_extension.hpp"
#include "perinox/mechanics/scene.hpp"

namespace perinox::mechanics {

namespace {

constexpr std::size_t lanes = 8;

struct Entry {
  GlobalId id;
  double* place;
};

bool by_id(const Entry& a, const Entry& b) { return a.id < b.id; }

/// Numbers of the bonds of a lattice (LatticeFamilies::each_of) as the steps ascend along the axes in turn, the last
/// most slowly.
std::vector<int> ends_along(const std::vector<bonds::StencilOffset>& offsets, const std::array<int, 3>& axes) {
  std::vector<int> ends(2 * offsets.size());
  std::iota(ends.begin(), ends.end(), 0);
  const auto key = [&](int end) {
    const std::array<int, 3>& step = offsets[static_cast<std::size_t>(end / 2)].step;
    const int sign = end % 2 != 0 ? -1 : 1;
    return std::array<int, 3>{sign * step[axes[2]], sign * step[axes[1]], sign * step[axes[0]]};
  };
  std::sort(ends.begin(), ends.end(), [&](int a, int b) { return key(a) < key(b); });
  return ends;
}

/// The bonds of the particles of a lattice by ascending id of the neighbour. Lattices are mostly numbered axis by axis:
/// in the right order of these the bonds need no sorting.
class LatticeOrder {
 public:
  LatticeOrder(const bonds::LatticeFamilies& lattice, const std::vector<GlobalId>& id)
      : lattice_(lattice), id_(id), ends_(ends_along(lattice.offsets(), {0, 1, 2})) {}

  /// Entries of particle i, their places from place_of(place).
  template <class PlaceOf>
  const std::vector<Entry>& of(LocalIndex i, const PlaceOf& place_of) {
    bool ascending = take(i, place_of);
    if (!ascending && entries_.size() > largest_) {  // a small family may fit several orders
      largest_ = entries_.size();
      std::array<int, 3> axes{0, 1, 2};
      do {
        ends_ = ends_along(lattice_.offsets(), axes);
        ascending = take(i, place_of);
      } while (!ascending && std::next_permutation(axes.begin(), axes.end()));
    }
    if (!ascending) std::sort(entries_.begin(), entries_.end(), by_id);
    return entries_;
  }

 private:
  template <class PlaceOf>
  bool take(LocalIndex i, const PlaceOf& place_of) {
    entries_.clear();
    bool ascending = true;
    GlobalId last = -1;
    lattice_.each_of(i, ends_, [&](const bonds::LatticeFamilies::Place& place) {
      const GlobalId id = id_[place.neighbor];
      ascending = ascending && id > last;
      last = id;
      entries_.push_back({id, place_of(place)});
    });
    return ascending;
  }

  const bonds::LatticeFamilies& lattice_;
  const std::vector<GlobalId>& id_;
  std::vector<int> ends_;
  std::size_t largest_ = 0;  ///< of the families that were out of order
  std::vector<Entry> entries_;
};

/// visit(place) for the bonds of each of the particles in turn; place: null where there is no chunk.
template <class Visit>
void visit_lattice(const Scene& scene, double* const* chunks, const std::vector<LocalIndex>& particles,
                   const Visit& visit) {
  LatticeOrder order(*scene.lattice(), scene.body().id);
  const auto place_of = [&](const bonds::LatticeFamilies::Place& place) {
    double* chunk = chunks ? chunks[place.block] : nullptr;
    return chunk ? chunk + (2 * static_cast<std::size_t>(place.offset) + (place.far ? 1 : 0)) * lanes +
                       static_cast<std::size_t>(place.lane)
                 : nullptr;
  };
  for (const LocalIndex i : particles)
    for (const Entry& entry : order.of(i, place_of)) visit(entry.place);
}

/// One pass over the pairs: a pair does not know where it stands in the family of its far end.
template <class Visit>
void visit_pairs(const Scene& scene, double* const* chunks, const std::vector<LocalIndex>& particles,
                 const Visit& visit) {
  const bonds::PairFamilies& pairs = *scene.pairs();
  const int owned = scene.owned(), none = pairs.slots() - 1;
  std::vector<int> number(static_cast<std::size_t>(owned), -1);  // of each owned slot among the particles
  std::vector<std::size_t> next{0};
  for (std::size_t k = 0; k < particles.size(); ++k) {
    number[static_cast<std::size_t>(pairs.slot()[particles[k]])] = static_cast<int>(k);
    next.push_back(next.back() + static_cast<std::size_t>(scene.families().size[particles[k]]));
  }
  const std::vector<std::size_t> begin = next;
  std::vector<Entry> entries(begin.back());
  const std::vector<GlobalId>& id = scene.body().id;
  for (int s = 0; s < owned; ++s) {
    double* chunk = chunks ? chunks[s] : nullptr;
    const std::int64_t first = pairs.begin()[s], last = pairs.begin()[s + 1];
    for (std::int64_t p = first; p < last; ++p) {
      const int far = pairs.far()[p];
      if (far == none) continue;
      const auto k = static_cast<std::size_t>(p - first);
      double* place = chunk ? chunk + 2 * (k / lanes) * lanes + k % lanes : nullptr;
      if (number[s] >= 0) entries[next[number[s]]++] = {id[pairs.particle()[far]], place};
      if (far < owned && number[far] >= 0)
        entries[next[number[far]]++] = {id[pairs.particle()[s]], place ? place + lanes : nullptr};
    }
  }
  for (std::size_t k = 0; k < particles.size(); ++k)
    std::sort(entries.begin() + static_cast<std::ptrdiff_t>(begin[k]),
              entries.begin() + static_cast<std::ptrdiff_t>(begin[k + 1]), by_id);
  for (const Entry& entry : entries) visit(entry.place);
}

template <class Visit>
void visit_places(const Scene& scene, double* const* chunks, const std::vector<LocalIndex>& particles,
                  const Visit& visit) {
  if (scene.lattice())
    visit_lattice(scene, chunks, particles, visit);
  else
    visit_pairs(scene, chunks, particles, visit);
}

}  // namespace

void PlasticExtension::read(const Scene& scene, const std::vector<LocalIndex>& particles,
                            std::vector<double>& values) const {
  visit_places(scene, chunks(), particles, [&](const double* place) { values.push_back(place ? *place : 0); });
}

void PlasticExtension::write(const Scene& scene, const std::vector<LocalIndex>& particles,
                             const std::vector<double>& values) {
  const double* next = values.data();
  visit_places(scene, chunks(), particles, [&](double* place) {
    if (place) *place = *next;
    ++next;
  });
}

}  // namespace perinox::mechanics
