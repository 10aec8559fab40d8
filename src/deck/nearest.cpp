#include <algorithm>
#include <cctype>
#include <numeric>

#include "perinox/deck/read.hpp"

namespace perinox::deck {
namespace {

/// The word with letters in lower case and hyphen and blank as underscore. To a reader these make no difference.
std::string plain(const std::string& word) {
  std::string result = word;
  for (char& c : result) {
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (c == '-' || c == ' ') c = '_';
  }
  return result;
}

/// Number of insertions, deletions, replacements and swaps of neighbours that turn one word into the other.
std::size_t edit_distance(const std::string& a, const std::string& b) {
  const std::size_t columns = b.size() + 1;
  std::vector<std::size_t> before(columns), above(columns), row(columns);
  std::iota(above.begin(), above.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j < columns; ++j) {
      const std::size_t change = a[i - 1] == b[j - 1] ? 0 : 1;
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + change});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before = above;
    above = row;
  }
  return above.back();
}

}  // namespace

std::string nearest(const std::string& word, const std::vector<std::string>& candidates) {
  constexpr std::size_t longest = 80;  // nobody mistypes a longer word, and the distance costs length squared
  if (word.empty() || word.size() > longest) return "";
  const std::string wanted = plain(word);
  std::string best;
  std::size_t best_distance = std::max<std::size_t>(1, (wanted.size() + 1) / 4) + 1;
  for (const std::string& candidate : candidates) {
    if (candidate.size() > longest) continue;
    const std::size_t distance = edit_distance(wanted, plain(candidate));
    if (distance < best_distance && distance < std::max(wanted.size(), candidate.size())) {
      best = candidate;
      best_distance = distance;
    }
  }
  if (!best.empty() || wanted.size() < 3) return best;
  // The word may be an abbreviation: `disp` of displacement, `poisson` of poisson_ratio.
  for (const std::string& candidate : candidates) {
    const std::string whole = plain(candidate);
    if (whole.rfind(wanted, 0) == 0 || (wanted.rfind(whole, 0) == 0 && whole.size() >= 3)) return candidate;
  }
  // The word may be some of the words of one candidate alone: `mises` of von_mises_stress.
  for (const std::string& candidate : candidates) {
    if (("_" + plain(candidate) + "_").find("_" + wanted + "_") == std::string::npos) continue;
    if (!best.empty() && best != candidate) return "";
    best = candidate;
  }
  return best;
}

}  // namespace perinox::deck
