/// Where the loads of a boundary turn back on their way from one load parameter to another.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "perinox/loads/boundary.hpp"

namespace perinox::loads {

namespace {
/// Parts of a way that are looked at, the times of a table besides. A load that turns twice within one of them is not
/// seen to turn.
constexpr int parts = 32;
/// Increments of a load that are shorter than this share of it are rounding.
constexpr double rounding = 1e-12;
/// The turn is looked for until its bracket is so much of the way.
constexpr double precise = 1e-14;
/// A load is told of where a step does not see this share of what it has been.
constexpr double worth_a_remark = 1e-6;
/// Load steps, and values of a formula of the place for all of them, that are looked at for a remark.
constexpr int most_steps = 10000;
constexpr double most_values = 2e6;

double dot(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += a[k] * b[k];
  return sum;
}

std::vector<double> difference(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> c(a.size());
  for (std::size_t k = 0; k < a.size(); ++k) c[k] = a[k] - b[k];
  return c;
}
}  // namespace

/// A load as a function of t alone: one component of an entry, or all of a table.
struct Boundary::LoadHistory {
  const Boundary& boundary;
  const Entry& entry;
  std::size_t component;
  std::size_t stride = 1;  ///< every so-many-th particle of this rank's set is looked at

  bool changes() const {
    if (entry.load->kind == deck::LoadKind::velocity) return false;
    return entry.table ? component == 0
                       : entry.load->component[component] && entry.load->component[component]->uses_time();
  }
  /// One value stands for all where the formula does not ask where.
  bool uniform() const { return !entry.table && !entry.load->component[component]->uses_position(); }

  /// Its values on this rank at t.
  std::vector<double> at(double t) const {
    const body::Body& body = boundary.model_.body();
    const auto d = static_cast<std::size_t>(body.dimension);
    std::vector<double> values;
    if (entry.table) {
      for (std::size_t k = 0; k < entry.set->size(); k += stride) {
        values.resize(values.size() + d);
        entry.table->evaluate(k, t, values.data() + values.size() - d);
      }
      return values;
    }
    const deck::Expression& formula = *entry.load->component[component];
    if (uniform()) return {formula(0, 0, 0, t)};
    for (std::size_t k = 0; k < entry.set->size(); k += stride) {
      const deck::Point x = body.position3((*entry.set)[k]);
      values.push_back(formula(x[0], x[1], x[2], t));
    }
    return values;
  }
  double product(const std::vector<double>& a, const std::vector<double>& b) const {
    return uniform() ? dot(a, b) : boundary.model_.body().communicator.sum(dot(a, b));
  }

  /// Moments of the way from `from` to `to`, in its order, with one just before it if it is to begin as it came.
  std::vector<double> moments(double from, double to, bool as_it_came) const {
    std::vector<double> all;
    for (int k = 0; k <= parts; ++k) all.push_back(k == parts ? to : from + (to - from) * k / parts);
    if (entry.table)
      for (const double time : entry.table->times())
        if (time > std::min(from, to) && time < std::max(from, to)) all.push_back(time);
    std::sort(all.begin(), all.end());
    if (to < from) std::reverse(all.begin(), all.end());
    if (as_it_came) all.insert(all.begin(), from - 1e-6 * (to - from));
    return all;
  }

  /// Between a and c, where the load's part along `way` is the largest (golden section).
  double turn(double a, double c, const std::vector<double>& way) const {
    const double golden = (std::sqrt(5.0) - 1) / 2, size = std::max(std::abs(a), std::abs(c));
    const auto height = [&](double t) { return product(at(t), way); };
    double low = c - golden * (c - a), high = a + golden * (c - a);
    double at_low = height(low), at_high = height(high);
    while (std::abs(c - a) > precise * size) {
      if (at_low < at_high) {
        a = low;
        low = high;
        at_low = at_high;
        high = a + golden * (c - a);
        if (high == low || high == c) break;
        at_high = height(high);
      } else {
        c = high;
        high = low;
        at_high = at_low;
        low = c - golden * (c - a);
        if (low == high || low == a) break;
        at_low = height(low);
      }
    }
    return at_low > at_high ? low : high;
  }

  /// t where the load turns back first on its way.
  std::optional<double> first_turn(double from, double to, bool as_it_came) const {
    const std::vector<double> moments = this->moments(from, to, as_it_came);
    std::vector<double> last = at(moments.front()), way;
    double size = product(last, last), length = 0, begin = 0;
    for (std::size_t k = 1; k < moments.size(); ++k) {
      std::vector<double> now = at(moments[k]);
      std::vector<double> increment = difference(now, last);
      const double square = product(increment, increment);
      size = std::max(size, product(now, now));
      if (!(square > rounding * rounding * size)) continue;  // as well where it is not finite
      // Not whether `way` is empty: a rank that has no particle of the set has to join in the sum all the same.
      if (length > 0 && product(increment, way) < -1e-9 * std::sqrt(square) * length)
        return turn(begin, moments[k], way);
      way = std::move(increment);
      length = std::sqrt(square);
      begin = moments[k - 1];
      last = std::move(now);
    }
    return {};
  }
};

std::vector<Boundary::LoadHistory> Boundary::changing_loads() const {
  std::vector<LoadHistory> all;
  for (const Entry& entry : entries_)
    for (std::size_t c = 0; c < 3; ++c)
      if (const LoadHistory load{*this, entry, c}; load.changes()) all.push_back(load);
  return all;
}

std::optional<double> Boundary::first_reversal(double from, double to, bool as_it_came) const {
  std::optional<double> first;
  for (const LoadHistory& load : changing_loads())
    if (const auto t = load.first_turn(from, to, as_it_came);
        t && (!first || std::abs(*t - from) < std::abs(*first - from)))
      first = t;
  return first;
}

void Boundary::remark_on_reversals(const deck::Deck& deck) {
  const deck::Steps& steps = deck.steps;
  if (deck.dynamics != deck::Dynamics::quasi_static || steps.control != deck::Control::load || steps.count > most_steps)
    return;
  if (!deck.breaks() && !model_.remembers()) return;
  const double each = static_cast<double>(parts) * steps.count;
  for (LoadHistory load : changing_loads()) {
    if (!load.uniform()) {
      const auto particles = static_cast<double>(load.entry.set->size());
      load.stride = static_cast<std::size_t>(std::ceil(std::max(1.0, each * particles / most_values)));
    }
    int found = 0;
    double first = 0, begin = 0, end = 0, missed = 0;
    for (int k = 0; k < steps.count; ++k) {
      const double from = steps.end * k / steps.count, to = steps.end * (k + 1) / steps.count;
      const auto t = load.first_turn(from, to, false);
      if (!t) continue;
      const std::vector<double> peak = load.at(*t);
      const auto gap = [&](double other) {
        const std::vector<double> rest = difference(peak, load.at(other));
        return load.product(rest, rest);
      };
      const double size = std::max({load.product(peak, peak), gap(from), gap(to)});
      const double share = size > 0 ? std::sqrt(std::min(gap(from), gap(to)) / size) : 0;
      if (!(share > worth_a_remark)) continue;
      if (found++ > 0) continue;
      first = *t;
      begin = from;
      end = to;
      missed = share;
    }
    if (found == 0) continue;
    const bool pressure = load.entry.load->kind == deck::LoadKind::pressure;
    remarks_.push_back(fmt::format(
        "{}: {} turns back at t = {:.6g}, within the load step from {:.6g} to {:.6g}, which does not see {:.2g} % of "
        "it{}; "
        "what flows or breaks remembers the way of its load: choose steps so that one ends there",
        load.entry.load->location.text(),
        load.entry.table ? std::string("the table")
        : pressure       ? std::string("the pressure")
                         : fmt::format("the {} component", "xyz"[load.component]),
        first, begin, end, 100 * missed, found > 1 ? fmt::format(", and so it is in {} more", found - 1) : ""));
  }
}

}  // namespace perinox::loads
