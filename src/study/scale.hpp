#pragma once
#include <string>
#include <vector>

namespace perinox::study {

struct Tick {
  double value;
  std::string label;  ///< empty: a minor tick
};

/// Text of a tick: 0.01 rather than 1e-2, but 1e-6.
std::string tick_label(double value);

/// Maps values to lengths along an axis.
class Scale {
 public:
  /// Widens the range by 6 % of its length, and where it is empty to something that can be drawn.
  Scale(double smallest, double largest, bool logarithmic);

  bool logarithmic() const { return logarithmic_; }
  /// Position of a value: 0 at the lower end, 1 at the upper.
  double position(double value) const;
  /// Ticks of the axis. A logarithmic one has decades, with 2 and 5 labelled where there are few, and every digit as a
  /// minor tick. A linear one has steps of 1, 2 or 5 times a power of ten.
  std::vector<Tick> ticks() const;

 private:
  bool logarithmic_;
  double low_, high_;  ///< of the logarithm on a logarithmic axis
};

}  // namespace perinox::study
