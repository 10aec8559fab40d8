#pragma once
#include <array>
#include <memory>

#include "perinox/deck/expression.hpp"

namespace perinox::deck {

/// The condition of a set, with slack at its bounds. Each comparison of two terms a and b in it takes a and b as equal
/// if moving the point by `slack` along x, y and z could make them so: `<=`, `>=` and `==` then hold, `<`, `>` and `!=`
/// do not. A bound through particles therefore takes all of them or none, whatever the rounding of their coordinates,
/// and a condition and its opposite never share a particle.
class Condition {
 public:
  /// Compiles the condition.
  explicit Condition(const Expression& condition);
  ~Condition();
  Condition(Condition&&) noexcept;
  Condition& operator=(Condition&&) noexcept;

  /// True if the value at the point is not zero. slack: length, at least 0. To be used by one thread at a time.
  bool holds(const std::array<double, 3>& point, double slack) const;
  /// True if the last call of holds() depended on something that is not a number at the point: on a comparison whose
  /// other answer would have changed that of the condition, or on the condition itself.
  bool undefined() const;

 private:
  struct Compiled;
  std::unique_ptr<Compiled> compiled_;
};

}  // namespace perinox::deck
