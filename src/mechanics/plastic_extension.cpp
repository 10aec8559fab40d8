#include "perinox/mechanics/plastic_extension.hpp"

#include <algorithm>
#include <cstdlib>
#include <new>

#include "perinox/mechanics/scene.hpp"

namespace perinox::mechanics {

namespace {
constexpr std::size_t lanes = 8;
constexpr std::size_t cache_line = 64;

/// Where a chunk holds e_p of one end of a bond.
std::size_t at(const bonds::LatticeFamilies::Place& place) {
  return (2 * static_cast<std::size_t>(place.offset) + (place.far ? 1 : 0)) * lanes +
         static_cast<std::size_t>(place.lane);
}
std::size_t at(const bonds::PairFamilies& pairs, const bonds::PairFamilies::Place& place) {
  const auto k = static_cast<std::size_t>(place.pair - pairs.begin()[place.near]);
  return (2 * (k / lanes) + (place.far ? 1 : 0)) * lanes + k % lanes;
}

struct Entry {
  GlobalId id;
  double value;
};

void write_sorted(std::vector<Entry>& entries, double* to) {
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.id < b.id; });
  for (std::size_t k = 0; k < entries.size(); ++k) to[k] = entries[k].value;
}
}  // namespace

void PlasticExtension::Free::operator()(double* p) const { std::free(p); }

void PlasticExtension::require(std::size_t k, std::size_t blocks, std::size_t count) {
  if (chunks_.empty()) chunks_.assign(blocks, nullptr);
  if (chunks_[k]) return;
  const std::size_t size = (count * sizeof(double) + cache_line - 1) / cache_line * cache_line;
  auto* memory = static_cast<double*>(std::aligned_alloc(cache_line, size));
  if (!memory) throw std::bad_alloc();
  std::fill(memory, memory + size / sizeof(double), 0.0);
  owned_.emplace_back(memory);
  chunks_[k] = memory;
  bytes_ += size;
}

void PlasticExtension::mark(const std::vector<double>& flow) {
  flowed_.resize(flow.size(), 0);
  for (std::size_t i = 0; i < flow.size(); ++i)
    if (flow[i] != 0) flowed_[i] = 1;
}

double PlasticExtension::of_bond(const Scene& scene, LocalIndex i, LocalIndex j) const {
  if (chunks_.empty()) return 0;
  if (const auto* lattice = scene.lattice()) {
    const bonds::LatticeFamilies::Place place = lattice->find(i, j);
    const double* chunk = chunks_[place.block];
    return chunk ? chunk[at(place)] : 0;
  }
  const bonds::PairFamilies::Place place = scene.pairs()->find(i, j);
  const double* chunk = chunks_[static_cast<std::size_t>(place.near)];
  return chunk ? chunk[at(*scene.pairs(), place)] : 0;
}

std::vector<double> PlasticExtension::per_bond(const Scene& scene) const {
  const bonds::Bonds& bonds = scene.bonds();
  std::vector<double> all(static_cast<std::size_t>(bonds.count()), 0.0);
  if (chunks_.empty()) return all;
  std::vector<Entry> entries;
  if (const auto* lattice = scene.lattice()) {
    std::vector<bonds::LatticeFamilies::Place> places;
    for (LocalIndex i = 0; i < scene.owned(); ++i) {
      lattice->places(i, places);
      entries.clear();
      for (const auto& place : places) {
        const double* chunk = chunks_[place.block];
        entries.push_back({scene.body().id[place.neighbor], chunk ? chunk[at(place)] : 0});
      }
      write_sorted(entries, &all[bonds.offset[i]]);
    }
    return all;
  }
  const auto every = scene.pairs()->places();
  for (LocalIndex i = 0; i < scene.owned(); ++i) {
    entries.clear();
    for (const auto& place : every[i]) {
      const double* chunk = chunks_[place.near];
      entries.push_back({scene.body().id[place.neighbor], chunk ? chunk[at(*scene.pairs(), place)] : 0});
    }
    write_sorted(entries, &all[bonds.offset[i]]);
  }
  return all;
}

}  // namespace perinox::mechanics
