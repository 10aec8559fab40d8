/// The way from a particle's bonds to their plastic extension in the sweeps' own order.
#include <algorithm>

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

/// Sorts entries by id. Neighbouring particles of a lattice have the same order, so the last one's is tried first.
class Sorter {
 public:
  void sort(std::vector<Entry>& entries) {
    if (order_.size() == entries.size()) {
      sorted_.resize(entries.size());
      for (std::size_t k = 0; k < entries.size(); ++k) sorted_[k] = entries[order_[k]];
      if (std::is_sorted(sorted_.begin(), sorted_.end(), by_id)) {
        entries.swap(sorted_);
        return;
      }
    }
    order_.resize(entries.size());
    for (std::size_t k = 0; k < order_.size(); ++k) order_[k] = k;
    std::sort(order_.begin(), order_.end(),
              [&](std::size_t a, std::size_t b) { return by_id(entries[a], entries[b]); });
    sorted_.resize(entries.size());
    for (std::size_t k = 0; k < entries.size(); ++k) sorted_[k] = entries[order_[k]];
    entries.swap(sorted_);
  }

 private:
  std::vector<std::size_t> order_;
  std::vector<Entry> sorted_;
};

/// visit(place) for the bonds of each of the particles in turn; place: null where there is no chunk.
template <class Visit>
void visit_lattice(const Scene& scene, double* const* chunks, const std::vector<LocalIndex>& particles,
                   const Visit& visit) {
  std::vector<Entry> entries;
  std::vector<bonds::LatticeFamilies::Place> places;
  Sorter sorter;
  for (const LocalIndex i : particles) {
    scene.lattice()->places(i, places);
    entries.clear();
    for (const auto& place : places) {
      const std::size_t at = (2 * static_cast<std::size_t>(place.offset) + (place.far ? 1 : 0)) * lanes +
                             static_cast<std::size_t>(place.lane);
      double* chunk = chunks ? chunks[place.block] : nullptr;
      entries.push_back({scene.body().id[place.neighbor], chunk ? chunk + at : nullptr});
    }
    sorter.sort(entries);
    for (const Entry& entry : entries) visit(entry.place);
  }
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
