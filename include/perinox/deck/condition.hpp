#pragma once
#include <array>
#include <memory>

#include "perinox/deck/expression.hpp"

namespace perinox::deck {

/// The condition of a set, with slack at its bounds. Each comparison a ? b in it sees a and b as equal where moving the
/// point by `slack` along x, y and z could make them so: `<=`, `>=` and `==` then hold, `<`, `>` and `!=` do not. So a
/// bound through particles takes all of them or none, whatever the rounding of their coordinates, and a condition and
/// its opposite never share a particle.
class Condition {
 public:
  explicit Condition(const Expression& condition);
  ~Condition();
  Condition(Condition&&) noexcept;
  Condition& operator=(Condition&&) noexcept;

  /// True where the value at the point is not zero. slack: length, at least 0. Used by one thread at a time.
  bool holds(const std::array<double, 3>& point, double slack) const;
  /// True where the last holds() hung on something that is not a number at the point: a comparison whose other answer
  /// would have changed the condition's, or the condition itself.
  bool undefined() const;

 private:
  struct Compiled;
  std::unique_ptr<Compiled> compiled_;
};

}  // namespace perinox::deck
