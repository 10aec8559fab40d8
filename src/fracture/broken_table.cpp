#include "broken_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace perinox::fracture {

namespace {

/// `value` as a whole number of [least, most), -1 if it is none.
long long whole(double value, GlobalId least, GlobalId most) {
  const bool fits = value >= static_cast<double>(least) && value < static_cast<double>(most);  // false for NaN
  return fits && std::floor(value) == value ? static_cast<long long>(value) : -1;
}

std::string first_fault(const std::vector<BrokenEntry>& table) {
  const auto rounds = static_cast<long long>(table.size());
  for (std::size_t k = 0; k < table.size(); ++k) {
    const BrokenEntry& entry = table[k];
    if (entry[2] >= rounds)
      return fmt::format("it holds a bond that broke in round {}, and {} broken bonds", entry[2], rounds);
    if (k > 0 && entry[0] == table[k - 1][0] && entry[1] == table[k - 1][1])
      return fmt::format("it holds the broken bond of the particles {} and {} twice", entry[0], entry[1]);
  }
  return "";
}

}  // namespace

std::vector<BrokenEntry> read_broken_table(const body::Body& body, const StateReader& reader) {
  const std::vector<int> count = reader.list_counts(broken_name);
  const bool odd = std::any_of(count.begin(), count.end(), [](int n) { return n % 2 != 0; });
  reader.refuse_if(odd ? "its list of broken bonds has half a bond" : "");
  // More rounds than pairs of particles there cannot be; how many bonds there are is known when all are read.
  constexpr GlobalId most_rounds = GlobalId{1} << 53;
  bool sound = true;
  std::vector<long long> mine;
  reader.lists(broken_name, [&](const std::vector<LocalIndex>& particles, const std::vector<double>& values) {
    auto value = values.begin();
    for (const LocalIndex i : particles)
      for (int k = 0; k < count[static_cast<std::size_t>(i)]; k += 2) {
        const long long other = whole(*value++, body.id[i] + 1, body.total), round = whole(*value++, 0, most_rounds);
        sound = sound && other >= 0 && round >= 0;
        mine.insert(mine.end(), {body.id[i], other, round});
      }
  });
  reader.refuse_if(sound ? "" : "its list of broken bonds holds numbers that are no particles or no rounds");
  const std::vector<long long> all = body.communicator.gather(mine);
  std::vector<BrokenEntry> table;
  for (std::size_t k = 0; k < all.size(); k += 3) table.push_back({all[k], all[k + 1], all[k + 2]});
  std::sort(table.begin(), table.end());
  reader.refuse_if(first_fault(table));
  return table;
}

std::vector<bonds::BrokenExtension> read_broken_extension(const StateReader& reader) {
  const std::vector<int> count = reader.list_counts(broken_extension_name);
  std::vector<bonds::BrokenExtension> all;
  const bool bad = std::any_of(count.begin(), count.end(), [](int n) { return n != 0 && n != broken_extension_size; });
  reader.refuse_if(bad ? "what it holds of the plastic extension of broken bonds has another length" : "");
  if (std::any_of(count.begin(), count.end(), [](int n) { return n > 0; })) all.resize(count.size());
  reader.lists(broken_extension_name, [&](const std::vector<LocalIndex>& particles, const std::vector<double>& values) {
    auto value = values.begin();
    for (const LocalIndex i : particles) {
      if (count[static_cast<std::size_t>(i)] == 0) continue;
      bonds::BrokenExtension& of = all[static_cast<std::size_t>(i)];
      for (double& number : of.fit) number = *value++;
      of.square = *value++;
      for (double& number : of.second) number = *value++;
    }
  });
  return all;
}

}  // namespace perinox::fracture
