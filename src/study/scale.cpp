#include "scale.hpp"

#include <fmt/format.h>

#include <cmath>

namespace perinox::study {

std::string tick_label(double value) {
  const double size = std::abs(value);
  if (size == 0) return "0";
  if (size >= 0.999e-3 && size < 0.999e5) return fmt::format("{:.6g}", value);
  const int exponent = static_cast<int>(std::floor(std::log10(size) + 1e-9));
  return fmt::format("{:.3g}e{}", value / std::pow(10.0, exponent), exponent);
}

Scale::Scale(double smallest, double largest, bool logarithmic)
    : logarithmic_(logarithmic),
      low_(logarithmic ? std::log10(smallest) : smallest),
      high_(logarithmic ? std::log10(largest) : largest) {
  const double empty = logarithmic ? 0.3 : (low_ == 0 ? 1 : 0.1 * std::abs(low_));
  const double length = high_ - low_;
  const double margin = length > 1e-12 * (std::abs(low_) + 1e-300) && length > 0 ? 0.06 * length : empty;
  low_ -= margin;
  high_ += margin;
}

double Scale::position(double value) const {
  return ((logarithmic_ ? std::log10(value) : value) - low_) / (high_ - low_);
}

std::vector<Tick> Scale::ticks() const {
  std::vector<Tick> ticks;
  if (logarithmic_) {
    const double decades = high_ - low_;
    const int every = static_cast<int>(decades / 8) + 1;
    for (int e = static_cast<int>(std::floor(low_)); e <= static_cast<int>(std::ceil(high_)); ++e)
      for (int digit = 1; digit < 10; ++digit) {
        const double value = digit * std::pow(10.0, e);
        if (position(value) < 0 || position(value) > 1) continue;
        const bool decade = digit == 1 && (e % every + every) % every == 0;
        const bool between =
            every == 1 && (decades < 0.8 ? digit != 9 && digit != 7 : decades < 2.5 && (digit == 2 || digit == 5));
        if (digit == 1 || every == 1) ticks.push_back({value, decade || between ? tick_label(value) : ""});
      }
    return ticks;
  }
  const double rough = (high_ - low_) / 6;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  double step = 10 * power;
  for (const double digit : {5.0, 2.0, 1.0})
    if (digit * power >= rough * 0.999) step = digit * power;
  for (double k = std::ceil(low_ / step); k * step <= high_; ++k) ticks.push_back({k * step, tick_label(k * step)});
  return ticks;
}

}  // namespace perinox::study
