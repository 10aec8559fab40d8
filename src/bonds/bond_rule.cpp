#include "bond_rule.hpp"

#include <algorithm>
#include <cmath>

namespace perinox::bonds {

namespace {

constexpr double tie = 1e-10;  // of the horizon

/// The factor of a whole family on a lattice of this spacing.
CubicFactor factor_of(const deck::Deck& deck, double spacing, double horizon) {
  const int dimension = deck::unknowns(deck.dimension);
  const int r = static_cast<int>(horizon / spacing * (1 + tie)), flat = dimension == 3 ? r : 0;
  CubicFactor factor;
  for (int z = -flat; z <= flat; ++z)
    for (int y = -r; y <= r; ++y)
      for (int x = -r; x <= r; ++x) {
        const double step[3] = {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
        const double length = spacing * std::sqrt(step[0] * step[0] + step[1] * step[1] + step[2] * step[2]);
        if (length == 0) continue;
        factor.add(dimension, step,
                   volume_share(deck.quadrature, length, horizon, spacing) *
                       influence_value(deck.influence, length, horizon) * length * length);
      }
  factor.finish();
  return factor;
}

}  // namespace

BondRule::BondRule(const deck::Deck& deck, const body::Body& body, double horizon)
    : deck_(deck), body_(body), horizon_(horizon), factor_(1), factor_of_(body.lattice_spacing.size(), 0) {
  if (deck.quadrature == deck::Quadrature::position_aware) make_factors();
}

void BondRule::prepare() {
  for (LocalIndex i = 0; i < body_.local(); ++i) {
    spacing_.push_back(body_.spacing_of(i));
    rounding_.push_back(body_.rounding(i));
  }
}

void BondRule::make_factors() {
  std::vector<double> spacings{0};
  for (std::size_t part = 0; part < factor_of_.size(); ++part) {
    const double spacing = body_.lattice_spacing[part];
    const auto known = std::find(spacings.begin(), spacings.end(), spacing);
    factor_of_[part] = static_cast<int>(known - spacings.begin());
    if (known != spacings.end()) continue;
    spacings.push_back(spacing);
    factor_.push_back(factor_of(deck_, spacing, horizon_));
  }
}

/// Between bodies of different lattices the factor is the mean of both, so that a bond weighs the same from either end.
double BondRule::factor(int part, int other, const double* between) const {
  const int one = factor_of_[static_cast<std::size_t>(part)], two = factor_of_[static_cast<std::size_t>(other)];
  const double first = factor_[static_cast<std::size_t>(one)](body_.dimension, between);
  return one == two ? first : (first + factor_[static_cast<std::size_t>(two)](body_.dimension, between)) / 2;
}

FoundBond BondRule::bond(LocalIndex i, LocalIndex j) const {
  const double *a = body_.position(i), *b = body_.position(j);
  double squared = 0, between[3] = {};
  for (int c = 0; c < body_.dimension; ++c) {
    between[c] = b[c] - a[c];
    squared += between[c] * between[c];
  }
  const double length = std::sqrt(squared);
  const bool at_horizon = std::abs(length - horizon_) <= tie * horizon_ + rounding_[i] + rounding_[j];
  const double counted = at_horizon ? horizon_ : length;
  const double share = volume_share(deck_.quadrature, counted, horizon_, (spacing_[i] + spacing_[j]) / 2);
  const double influence = influence_value(deck_.influence, counted, horizon_);
  return {j, length, share * body_.volume[j], influence * factor(body_.part[i], body_.part[j], between)};
}

FoundBond BondRule::lattice_bond(LocalIndex of, const std::array<int, 3>& step) const {
  double square = 0, between[3] = {};
  for (std::size_t c = 0; c < 3; ++c) {
    between[c] = static_cast<double>(step[c]);
    square += between[c] * between[c];
  }
  const double spacing = body_.spacing_of(of), length = spacing * std::sqrt(square);
  const int part = body_.part[static_cast<std::size_t>(of)];
  return {0, length, volume_share(deck_.quadrature, length, horizon_, spacing),
          influence_value(deck_.influence, length, horizon_) * factor(part, part, between)};
}

}  // namespace perinox::bonds
