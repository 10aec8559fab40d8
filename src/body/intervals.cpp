#include "perinox/body/intervals.hpp"

#include <algorithm>

namespace perinox::body {

Intervals unite(const Intervals& a, const Intervals& b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  Intervals all(a.size() + b.size());
  std::merge(a.begin(), a.end(), b.begin(), b.end(), all.begin());
  std::size_t last = 0;
  for (std::size_t k = 1; k < all.size(); ++k) {
    if (all[k].first <= all[last].second)
      all[last].second = std::max(all[last].second, all[k].second);
    else
      all[++last] = all[k];
  }
  all.resize(last + 1);
  return all;
}

Intervals intersect(const Intervals& a, const Intervals& b) {
  Intervals both;
  for (auto i = a.begin(), j = b.begin(); i != a.end() && j != b.end();) {
    const double begin = std::max(i->first, j->first), end = std::min(i->second, j->second);
    if (begin <= end) both.emplace_back(begin, end);
    if (i->second < j->second)
      ++i;
    else
      ++j;
  }
  return both;
}

Intervals subtract(const Intervals& a, const Intervals& b) {
  Intervals rest;
  auto next = b.begin();
  for (auto [begin, end] : a) {
    while (next != b.end() && next->second <= begin) ++next;
    bool whole = true;  // nothing of this interval has been taken away up to its end
    for (auto hole = next; hole != b.end() && hole->first < end; ++hole) {
      if (!(hole->first < hole->second)) continue;
      if (hole->first >= begin) rest.emplace_back(begin, hole->first);
      begin = hole->second;
      whole = begin <= end;
    }
    if (whole) rest.emplace_back(begin, end);
  }
  return rest;
}

double length(const Intervals& a) {
  double sum = 0;
  for (const auto& [begin, end] : a) sum += end - begin;
  return sum;
}

}  // namespace perinox::body
