#pragma once
/// Draws numbers by lot. They are the same on every machine, while the distributions of <random> differ between
/// libraries.
#include <cstdint>
#include <random>
#include <vector>

namespace perinox::invariance {

class Lot {
 public:
  explicit Lot(unsigned seed) : engine_(seed) {}
  /// A number between two bounds.
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_()) + 0.5) / 4294967296.0;
  }
  /// A whole number from low to high, both included.
  int whole(int low, int high) {
    return low + static_cast<int>(engine_() % static_cast<std::uint32_t>(high - low + 1));
  }
  bool chance(double share) { return between(0, 1) < share; }
  template <class T>
  T one_of(const std::vector<T>& choices) {
    return choices[static_cast<std::size_t>(whole(0, static_cast<int>(choices.size()) - 1))];
  }
  double sign() { return chance(0.5) ? 1 : -1; }

 private:
  std::mt19937 engine_;
};

}  // namespace perinox::invariance
