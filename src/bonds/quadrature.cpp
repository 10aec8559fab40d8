/// The formulas of a single bond: the influence function, the share of the neighbour's volume and the factor that a
/// lattice needs (docs/theory.md, section 8).
#include <algorithm>
#include <cmath>

#include "perinox/bonds/families.hpp"

namespace perinox::bonds {

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kTie = 1e-10;  ///< a neighbour this much (relative) beyond the horizon is still at the horizon
constexpr double least_factor = 0.05;
constexpr double kSliver = 1e-9;  ///< a share below this is rounding: the cell only touches the horizon

}  // namespace

double reach(const deck::Deck& deck, double horizon, double largest_spacing) {
  constexpr double for_rounding = 1 + 1e-6;
  return for_rounding * (deck.quadrature == deck::Quadrature::partial_volume ? horizon + largest_spacing / 2 : horizon);
}

double influence_value(deck::Influence influence, double length, double horizon) {
  if (influence == deck::Influence::constant) return 1;
  if (influence == deck::Influence::inverse) return 1 / length;
  const double r = length / horizon;
  if (r >= 1 - kTie) return 0;
  return 1 - 3 * r * r + 2 * r * r * r;
}

double continuum_weighted_volume(deck::Influence influence, double horizon, int dimension) {
  const double d = horizon;
  if (dimension == 3) {  // integral of 4 pi r^4 omega(r)
    if (influence == deck::Influence::constant) return 4 * kPi * std::pow(d, 5) / 5;
    if (influence == deck::Influence::inverse) return kPi * std::pow(d, 4);
    return 3 * kPi * std::pow(d, 5) / 35;  // 4 pi d^5 (1/5 - 3/7 + 2/8)
  }
  // integral of 2 pi r^3 omega(r)
  if (influence == deck::Influence::constant) return kPi * std::pow(d, 4) / 2;
  if (influence == deck::Influence::inverse) return 2 * kPi * std::pow(d, 3) / 3;
  return kPi * std::pow(d, 4) / 14;  // 2 pi d^4 (1/4 - 3/6 + 2/7)
}

double volume_share(deck::Quadrature quadrature, double length, double horizon, double spacing) {
  const bool within = length <= horizon * (1 + kTie);
  if (quadrature == deck::Quadrature::whole || quadrature == deck::Quadrature::position_aware ||
      quadrature == deck::Quadrature::surface_energy)
    return within ? 1 : 0;
  const double share = std::clamp(0.5 + (horizon - length) / spacing, 0.0, 1.0);
  if (quadrature == deck::Quadrature::taper_inside) return within ? share : 0;
  return share > kSliver ? share : 0;
}

double CubicFactor::anisotropy(int dimension, const double* bond) {
  double square = 0, fourth = 0;
  for (int c = 0; c < dimension; ++c) {
    square += bond[c] * bond[c];
    fourth += bond[c] * bond[c] * bond[c] * bond[c];
  }
  return fourth / (square * square) - 3.0 / (dimension + 2);
}

void CubicFactor::add(int dimension, const double* bond, double moment) {
  const double g = anisotropy(dimension, bond);
  first_ += moment * g;
  second_ += moment * g * g;
  least_ = std::min(least_, g);
  most_ = std::max(most_, g);
}

void CubicFactor::finish() {
  c_ = second_ > 0 ? -first_ / second_ : 0;
  if (std::min(1 + c_ * least_, 1 + c_ * most_) < least_factor) c_ = 0;
}

double CubicFactor::operator()(int dimension, const double* bond) const {
  return c_ == 0 ? 1 : 1 + c_ * anisotropy(dimension, bond);
}

}  // namespace perinox::bonds
