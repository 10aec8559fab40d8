#include "perinox/output/profile_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace perinox::output {

std::string profile_table(const ProfileReading& reading) {
  std::array<std::size_t, section_count> order{};
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return reading.seconds[a] > reading.seconds[b]; });
  const auto share = [&](double seconds) { return reading.wall > 0 ? 100 * seconds / reading.wall : 0.0; };
  std::string table = fmt::format("{:<18}{:>10}{:>9}{:>11}\n", "time of the run", "seconds", "share", "count");
  for (const std::size_t s : order) {
    if (reading.count[s] == 0) continue;
    table += fmt::format("  {:<16}{:>10.3f}{:>7.1f} %{:>11}\n", name_of(static_cast<Section>(s)), reading.seconds[s],
                         share(reading.seconds[s]), reading.count[s]);
  }
  table += fmt::format("  {:<16}{:>10.3f}{:>7.1f} %\n", "rest", reading.rest(), share(reading.rest()));
  return table + fmt::format("  {:<16}{:>10.3f}\n", "total", reading.wall);
}

}  // namespace perinox::output
