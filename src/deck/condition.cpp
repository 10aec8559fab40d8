#include "perinox/deck/condition.hpp"

#include <fmt/format.h>
#include <muParser.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace perinox::deck {

namespace {

constexpr std::array<const char*, 6> operators{"<=", ">=", "==", "!=", "<", ">"};  // two characters first

/// The values that the comparisons of a condition have been given, and how they decide.
struct Comparisons {
  std::vector<double> difference;  ///< differences in the last evaluation; not a number: not reached
  std::vector<double> slack;       ///< slack of each comparison
  bool odd = false;                ///< something that was compared in the last evaluation is not a number
  double for_odd = 0;              ///< what such a comparison gives
  bool undefined = false;          ///< the last condition depends on what such a comparison gives
};
thread_local Comparisons* now = nullptr;

/// Evaluates one comparison for muParser. number: that of the comparison; kind: that of its operator.
double compare(double number, double kind, double a, double b) {
  const auto k = static_cast<std::size_t>(number);
  const double difference = a - b;
  now->difference[k] = difference;
  if (std::isnan(difference) && !(a == b)) {
    now->odd = true;
    return now->for_odd;
  }
  const bool equal = a == b || std::abs(difference) <= now->slack[k];
  switch (static_cast<int>(kind)) {
    case 0:
      return equal || a < b ? 1 : 0;
    case 1:
      return equal || a > b ? 1 : 0;
    case 2:
      return equal ? 1 : 0;
    case 3:
      return equal ? 0 : 1;
    case 4:
      return !equal && a < b ? 1 : 0;
    default:
      return !equal && a > b ? 1 : 0;
  }
}

/// Rewrites a checked formula with compare(number, kind, a, b) for every comparison of a and b.
class Rewritten {
 public:
  explicit Rewritten(const std::string& formula) : formula_(formula) { text_ = level(); }
  const std::string& text() const { return text_; }
  std::size_t count() const { return count_; }

 private:
  /// Rewrites the text up to the parenthesis that closes this level, or up to the end.
  std::string level() {
    std::string done, part, left;
    int kind = -1;
    const auto finish = [&] {
      done += kind < 0 ? part : fmt::format("compare({},{},{},{})", count_++, kind, left, part);
      part.clear();
      kind = -1;
    };
    while (at_ < formula_.size() && formula_[at_] != ')') {
      if (formula_[at_] == '(') {
        ++at_;
        part += "(" + level() + ")";
        ++at_;
        continue;
      }
      const auto found = std::find_if(operators.begin(), operators.end(), [&](const char* one) {
        return formula_.compare(at_, std::char_traits<char>::length(one), one) == 0;
      });
      if (found != operators.end()) {
        kind = static_cast<int>(found - operators.begin());
        at_ += std::char_traits<char>::length(*found);
        left = std::move(part);
        part.clear();
        continue;
      }
      const bool joins = formula_.compare(at_, 2, "&&") == 0 || formula_.compare(at_, 2, "||") == 0;
      const char c = formula_[at_];
      if (joins || c == ',' || c == '?' || c == ':') {
        finish();
        const std::size_t size = joins ? 2 : 1;
        done += formula_.substr(at_, size);
        at_ += size;
        continue;
      }
      part += c;
      ++at_;
    }
    finish();
    return done;
  }

  const std::string& formula_;
  std::string text_;
  std::size_t at_ = 0, count_ = 0;
};

}  // namespace

struct Condition::Compiled {
  double x = 0, y = 0, z = 0, t = 0;
  mu::Parser parser;
  mutable Comparisons comparisons;

  explicit Compiled(const std::string& formula) {
    const Rewritten rewritten(formula);
    comparisons.difference.resize(rewritten.count());
    comparisons.slack.resize(rewritten.count());
    parser.ClearConst();
    parser.DefineVar("x", &x);
    parser.DefineVar("y", &y);
    parser.DefineVar("z", &z);
    parser.DefineVar("t", &t);
    parser.DefineConst("pi", 3.14159265358979323846);
    parser.DefineFun("compare", compare, false);
    parser.SetExpr(rewritten.text());
  }

  bool holds(const std::array<double, 3>& point) {
    x = point[0];
    y = point[1];
    z = point[2];
    now = &comparisons;
    std::fill(comparisons.difference.begin(), comparisons.difference.end(), std::nan(""));
    comparisons.odd = false;
    comparisons.for_odd = 0;
    const double value = parser.Eval();
    comparisons.undefined = std::isnan(value);
    if (comparisons.odd) {  // all of && and || is evaluated, so it must be found out whether this matters
      comparisons.for_odd = 1;
      const double other = parser.Eval();
      comparisons.undefined = std::isnan(value) || (other != 0) != (value != 0);
    }
    return value != 0;
  }
};

Condition::Condition(const Expression& condition) : compiled_(std::make_unique<Compiled>(condition.text())) {}
Condition::~Condition() = default;
Condition::Condition(Condition&&) noexcept = default;
Condition& Condition::operator=(Condition&&) noexcept = default;

bool Condition::undefined() const { return compiled_->comparisons.undefined; }

bool Condition::holds(const std::array<double, 3>& point, double slack) const {
  Comparisons& comparisons = compiled_->comparisons;
  std::fill(comparisons.slack.begin(), comparisons.slack.end(), 0.0);
  const bool exactly = compiled_->holds(point);
  if (comparisons.slack.empty()) return exactly;
  const std::vector<double> here = comparisons.difference;
  std::vector<double> change(here.size(), 0.0);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::vector<double> most(here.size(), 0.0);
    for (const double side : {-1.0, 1.0}) {
      std::array<double, 3> moved = point;
      moved[axis] += side * slack;
      compiled_->holds(moved);
      for (std::size_t k = 0; k < here.size(); ++k) {
        const double by = std::abs(comparisons.difference[k] - here[k]);
        if (std::isfinite(by)) most[k] = std::max(most[k], by);
      }
    }
    for (std::size_t k = 0; k < here.size(); ++k) change[k] += most[k];
  }
  comparisons.slack = std::move(change);
  return compiled_->holds(point);
}

}  // namespace perinox::deck
