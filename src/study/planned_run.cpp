#include "planned_run.hpp"

#include <fmt/format.h>

#include <cctype>
#include <set>

#include "perinox/core/error.hpp"
#include "perinox/deck/scalar.hpp"

namespace perinox::study {

namespace {
constexpr std::size_t most_runs = 10000;
constexpr std::size_t longest_name = 120;

/// The text as a word that is safe as a part of a file's name.
std::string plain(const std::string& text) {
  std::string result;
  for (const char c : text)
    result += std::isalnum(static_cast<unsigned char>(c)) || c == '.' || c == '-' || c == '+' ? c : '-';
  return result;
}

int ranks_of(const Setting& setting, const std::string& value) {
  const auto number = deck::parse_integer(value);
  if (!number || *number < 1 || *number > 4096)
    deck::refuse(setting.location,
                 fmt::format("ranks must be a whole number from 1 to 4096, but '{}' was found", value));
  return static_cast<int>(*number);
}

void refuse_clashes(const Study& study) {
  std::set<std::string> before;
  for (const Sweep& sweep : study.sweep) {
    std::set<std::string> own;
    for (const SweepPoint& point : sweep.points)
      for (const Setting& setting : point.set) {
        if (before.count(setting.key) > 0)
          deck::refuse(setting.location, fmt::format("two sweeps set {}; remove one", setting.key));
        own.insert(setting.key);
      }
    before.insert(own.begin(), own.end());
  }
}
}  // namespace

std::size_t first_numeric(const Study& study) {
  std::size_t s = 0;
  while (s < study.sweep.size() && !(study.sweep[s].numeric() && study.sweep[s].points.size() > 1)) ++s;
  return s;
}

std::vector<PlannedRun> planned_runs(const Study& study) {
  refuse_clashes(study);
  std::size_t count = 1;
  for (const Sweep& sweep : study.sweep) {
    count *= sweep.points.size();
    if (count > most_runs)
      deck::refuse(sweep.location, fmt::format("the sweeps make more than {} runs; leave some values out", most_runs));
  }
  std::vector<PlannedRun> runs;
  std::set<std::string> names;
  for (std::size_t number = 0; number < count; ++number) {
    PlannedRun run;
    std::size_t rest = number, block = count;
    std::map<std::string, std::string> words;
    for (const Sweep& sweep : study.sweep) {
      block /= sweep.points.size();
      run.point.push_back(rest / block);
      rest %= block;
      const SweepPoint& point = sweep.points[run.point.back()];
      run.label.push_back(point.label);
      words[sweep.name] = point.label;
      if (point.number) run.numbers[sweep.name] = *point.number;
      run.name += (run.name.empty() ? "" : "_") + plain(sweep.name) + "-" + plain(point.label);
    }
    if (run.name.size() > longest_name) run.name.resize(longest_name);
    if (!names.insert(run.name).second) names.insert(run.name += fmt::format("_{}", number));
    const auto apply = [&](const Setting& setting) {
      const std::string value = with_words(setting.value, words, setting.location);
      if (setting.key == "ranks")
        run.ranks = ranks_of(setting, value);
      else
        run.overrides.push_back(setting.key + "=" + value);
    };
    for (const Setting& setting : study.set) apply(setting);
    for (std::size_t s = 0; s < study.sweep.size(); ++s)
      for (const Setting& setting : study.sweep[s].points[run.point[s]].set) apply(setting);
    runs.push_back(std::move(run));
  }
  return runs;
}

}  // namespace perinox::study
