#include "perinox/fracture/broken_bonds.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "broken_table.hpp"
#include "perinox/mechanics/each_bond.hpp"

namespace perinox::fracture {

namespace {

using Entry = BrokenEntry;

bool lower_first(const Entry& a, const Entry& b) { return a[0] < b[0]; }

/// Entries of a particle, the table being sorted.
std::pair<std::size_t, std::size_t> range_of(const std::vector<Entry>& table, GlobalId id) {
  const auto [first, last] = std::equal_range(table.begin(), table.end(), Entry{id, 0, 0}, lower_first);
  return {static_cast<std::size_t>(first - table.begin()), static_cast<std::size_t>(last - table.begin())};
}

void save_broken_extension(const mechanics::Scene& scene, StateWriter& writer) {
  const std::vector<bonds::BrokenExtension>& all = scene.families().broken_extension;
  std::vector<int> count(static_cast<std::size_t>(scene.owned()), 0);
  for (std::size_t i = 0; i < all.size(); ++i)
    if (all[i].second != bonds::Mandel{}) count[i] = broken_extension_size;
  writer.lists(broken_extension_name, count,
               [&](const std::vector<LocalIndex>& particles, std::vector<double>& values) {
                 for (const LocalIndex i : particles) {
                   if (count[static_cast<std::size_t>(i)] == 0) continue;
                   const bonds::BrokenExtension& of = all[static_cast<std::size_t>(i)];
                   values.insert(values.end(), of.fit.begin(), of.fit.end());
                   values.push_back(of.square);
                   values.insert(values.end(), of.second.begin(), of.second.end());
                 }
               });
}

}  // namespace

void save_broken_bonds(const mechanics::Scene& scene, const std::vector<std::size_t>& rounds, StateWriter& writer) {
  std::vector<Entry> table;
  const auto& broken = scene.broken();
  for (std::size_t k = 0; k < broken.size(); ++k) {
    const auto after = std::upper_bound(rounds.begin(), rounds.end(), k);
    table.push_back({broken[k][0], broken[k][1], after - rounds.begin() - 1});
  }
  std::stable_sort(table.begin(), table.end(), lower_first);
  std::vector<int> count(static_cast<std::size_t>(scene.owned()), 0);
  for (LocalIndex i = 0; i < scene.owned() && !table.empty(); ++i) {
    const auto [first, last] = range_of(table, scene.body().id[i]);
    count[static_cast<std::size_t>(i)] = static_cast<int>(2 * (last - first));
  }
  writer.lists(broken_name, count, [&](const std::vector<LocalIndex>& particles, std::vector<double>& values) {
    for (const LocalIndex i : particles) {
      const auto [first, last] = range_of(table, scene.body().id[i]);
      for (std::size_t k = first; k < last; ++k) {
        values.push_back(static_cast<double>(table[k][1]));
        values.push_back(static_cast<double>(table[k][2]));
      }
    }
  });
  save_broken_extension(scene, writer);
}

BrokenBonds::BrokenBonds(mechanics::Scene& scene, const StateReader& reader)
    : scene_(scene), extension_(read_broken_extension(reader)) {
  const std::vector<Entry> table = read_broken_table(scene.body(), reader);
  count_ = static_cast<long long>(table.size());
  for (const Entry& entry : table) {
    const auto round = static_cast<std::size_t>(entry[2]);
    if (round >= broken_.size()) broken_.resize(round + 1, 0);
    ++broken_[round];
  }
  if (table.empty()) return;
  const body::Body& body = scene.body();
  std::vector<std::pair<std::size_t, std::size_t>> ranges;  // [local]
  for (LocalIndex i = 0; i < body.local(); ++i) ranges.push_back(range_of(table, body.id[i]));
  long long found = 0;
  mechanics::each_bond(scene, [&](LocalIndex i, LocalIndex j) {
    const bool first = body.id[i] < body.id[j];
    const LocalIndex lower = first ? i : j;
    const GlobalId upper = body.id[first ? j : i];
    const auto [begin, end] = ranges[static_cast<std::size_t>(lower)];
    for (std::size_t k = begin; k < end; ++k) {
      if (table[k][1] != upper) continue;
      bonds_.push_back({static_cast<std::size_t>(table[k][2]), {i, j}});
      if (lower < body.owned) ++found;
    }
  });
  const long long missing = count_ - body.communicator.sum(found);
  reader.refuse_if(missing == 0 ? std::string()
                                : fmt::format("it holds {} broken bonds that this deck's bodies do not have", missing));
  std::stable_sort(bonds_.begin(), bonds_.end(), [](const Bond& a, const Bond& b) { return a.round < b.round; });
}

void BrokenBonds::break_first(long long bonds) {
  std::vector<mechanics::BondEnds> ends;
  while (done_ < bonds && rounds_.size() < broken_.size()) {
    const std::size_t round = rounds_.size();
    rounds_.push_back(scene_.broken().size());
    ends.clear();
    for (; next_ < bonds_.size() && bonds_[next_].round == round; ++next_) ends.push_back(bonds_[next_].ends);
    scene_.break_bonds(ends);
    done_ += broken_[round];
  }
  if (done_ == count_) scene_.set_broken_extension(extension_);
}

}  // namespace perinox::fracture
