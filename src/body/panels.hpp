#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace perinox::body {

/// Points and weights of Gauss-Legendre quadrature over [-1, 1].
template <int count>
struct Gauss {
  std::array<double, count> point{}, weight{};
  Gauss() {
    for (int k = 0; k < count; ++k) {
      double x = std::cos(M_PI * (k + 0.75) / (count + 0.5)), slope = 1;
      for (int pass = 0; pass < 50; ++pass) {
        double before = 1, now = x;
        for (int n = 2; n <= count; ++n) {
          const double next = ((2 * n - 1) * x * now - (n - 1) * before) / n;
          before = now;
          now = next;
        }
        slope = count == 1 ? 1 : count * (x * now - before) / (x * x - 1);
        const double step = now / slope;
        x -= step;
        if (std::abs(step) < 1e-16) break;
      }
      point[static_cast<std::size_t>(k)] = x;
      weight[static_cast<std::size_t>(k)] = 2 / ((1 - x * x) * slope * slope);
    }
  }
};

/// The kind of function that is integrated between breaks: a polynomial of at most third degree; a smooth function with
/// square roots of the distance to the breaks; or one that also has breaks that are not known.
enum class Form { polynomial, root, rough };

/// Calls point(x, weight) for the points of a quadrature over [from, to]. None of them is an end.
template <int count, class AtPoint>
void over_panel(double from, double to, Form form, const AtPoint& point) {
  static const Gauss<count> gauss;
  static const Gauss<2> two;
  const double half = (to - from) / 2, middle = (from + to) / 2;
  if (form == Form::polynomial) {
    for (std::size_t k = 0; k < 2; ++k) point(middle + half * two.point[k], half * two.weight[k]);
    return;
  }
  // The substitution x = middle + half sin(angle) makes roots of the distance to either end smooth.
  for (std::size_t k = 0; k < count; ++k) {
    const double angle = M_PI / 2 * gauss.point[k];
    point(middle + half * std::sin(angle), half * M_PI / 2 * gauss.weight[k] * std::cos(angle));
  }
}

/// Calls panel(from, to) for the pieces of [lo, hi] between the breaks within; sorts the breaks.
template <class OfPanel>
void split(std::vector<double>& breaks, double lo, double hi, const OfPanel& panel) {
  std::sort(breaks.begin(), breaks.end());
  const double least = 1e-14 * (hi - lo);
  double from = lo;
  for (const double one : breaks) {
    if (!(one < hi)) break;
    if (!(one - from > least)) continue;
    panel(from, one);
    from = one;
  }
  if (hi > from) panel(from, hi);
}

/// Calls point(x, weight) for the points of a quadrature over [lo, hi] that is split at the breaks within.
template <int count, class AtPoint>
void over_panels(std::vector<double>& breaks, double lo, double hi, Form form, const AtPoint& point) {
  const int pieces = form == Form::rough ? 4 : 1;
  split(breaks, lo, hi, [&](double from, double to) {
    for (int k = 0; k < pieces; ++k)
      over_panel<count>(from + (to - from) * k / pieces, from + (to - from) * (k + 1) / pieces, form, point);
  });
}

/// Adds to `sum` what point(x, weight, sum) adds over [lo, hi], in panels that are halved until both halves agree with
/// the whole within the tolerance. Sum must have += and difference(Sum).
template <int count, class Sum, class AtPoint>
void add_panels(std::vector<double>& breaks, double lo, double hi, Form form, double tolerance, Sum& sum,
                const AtPoint& point) {
  const auto of_panel = [&](double from, double to) {
    Sum part{};
    over_panel<count>(from, to, form, [&](double x, double weight) { point(x, weight, part); });
    return part;
  };
  const auto refine = [&](const auto& self, double from, double to, const Sum& whole, int depth) -> void {
    const double middle = (from + to) / 2;
    const Sum left = of_panel(from, middle), right = of_panel(middle, to);
    Sum both = left;
    both += right;
    if (depth == 0 || both.difference(whole) <= tolerance) {
      sum += both;
      return;
    }
    self(self, from, middle, left, depth - 1);
    self(self, middle, to, right, depth - 1);
  };
  constexpr int deepest = 12;
  split(breaks, lo, hi, [&](double from, double to) {
    const Sum whole = of_panel(from, to);
    if (form == Form::polynomial)
      sum += whole;
    else
      refine(refine, from, to, whole, deepest);
  });
}

}  // namespace perinox::body
