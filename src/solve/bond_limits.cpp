#include "perinox/solve/bond_limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace perinox::solve {

namespace {

/// Against horizon over spacing. Constant influence: on double cantilevers, two measurements at one ratio 3 % apart;
/// the others: in the field of a stress intensity (docs/fracture.md).
using Toughness = std::vector<std::pair<double, double>>;
const Toughness toughness_constant{{3, 1.48}, {4, 1.37}, {5, 1.35}, {6, 1.28}, {8, 1.13}};
const Toughness toughness_inverse{{3, 1.45}, {5, 1.28}};
const Toughness toughness_polynomial{{3, 1.51}, {5, 1.14}};
constexpr double toughness_3d = 1.2;  ///< constant influence; of others nothing is known

constexpr double pi = 3.14159265358979323846;

/// Mean of |n . e| over all unit vectors e.
double mean_projection(int dimension) { return dimension == 3 ? 0.5 : 2 / pi; }

CrossedBonds continuum(const deck::Deck& deck, double horizon) {
  const int d = deck::unknowns(deck.dimension), intervals = 2000;  // Simpson's rule
  CrossedBonds sums;
  const double step = horizon / intervals;
  for (int k = 1; k <= intervals; ++k) {
    const double xi = k * step, sphere = d == 3 ? 4 * pi * xi * xi : 2 * pi * xi;
    const double share = (k == intervals ? 1.0 : k % 2 ? 4.0 : 2.0) * step / 3 * sphere;
    const double omega = bonds::influence_value(deck.influence, xi, horizon);
    sums.count += share * mean_projection(d) / 2 * xi;
    sums.square += share * mean_projection(d) / 2 * xi * omega * xi * xi;
    sums.weighted_volume += share * omega * xi * xi;
  }
  return sums;
}

CrossedBonds lattice(const deck::Deck& deck, double horizon, double spacing) {
  const int d = deck::unknowns(deck.dimension);
  const int r = static_cast<int>(bonds::reach(deck, horizon, spacing) / spacing * (1 + 1e-10)), flat = d == 3 ? r : 0;
  const double volume = std::pow(spacing, d);
  CrossedBonds sums;
  for (int z = -flat; z <= flat; ++z)
    for (int y = -r; y <= r; ++y)
      for (int x = -r; x <= r; ++x) {
        const double xi = spacing * std::sqrt(static_cast<double>(x * x + y * y + z * z));
        if (xi == 0) continue;
        const double share = bonds::volume_share(deck.quadrature, xi, horizon, spacing);
        const double weight = share > 0 ? share * bonds::influence_value(deck.influence, xi, horizon) : 0;
        if (weight <= 0) continue;
        sums.count += volume * mean_projection(d) / 2 * xi;
        sums.square += volume * mean_projection(d) / 2 * xi * weight * xi * xi;
        sums.weighted_volume += volume * weight * xi * xi;
      }
  return sums;
}

/// What a crack along a lattice plane takes an area, over what its bonds held at their limits: it moves in jumps, in
/// which bonds go beyond their limits, and between which energy is lost; less so with more particles in a horizon.
/// Measured (docs/fracture.md).
double lattice_toughness(const deck::Deck& deck, double horizon, double spacing) {
  if (spacing == 0) return 1;
  if (deck.dimension == deck::Dimension::three) return deck.influence == deck::Influence::constant ? toughness_3d : 1;
  const Toughness& measured = deck.influence == deck::Influence::constant  ? toughness_constant
                              : deck.influence == deck::Influence::inverse ? toughness_inverse
                                                                           : toughness_polynomial;
  const double ratio = horizon / spacing;
  for (std::size_t k = 1; k < measured.size(); ++k) {
    const auto [high, at_high] = measured[k];
    const auto [low, at_low] = measured[k - 1];
    if (ratio <= high) return at_low + (at_high - at_low) * std::max(0.0, ratio - low) / (high - low);
  }
  return measured.back().second;
}

/// Largest spacing of the lattices made of a material; 0 if one of its bodies is a cloud.
double spacing_of(const deck::Deck& deck, const deck::Material& material) {
  double largest = 0;
  for (const deck::BodyPart& part : deck.body) {
    if (part.material != material.name) continue;
    if (std::holds_alternative<deck::CloudFile>(part.shape.form)) return 0;
    largest = std::max(largest, part.spacing);
  }
  return largest;
}

bool flows(const materials::Material& material) { return material.history().per_bond > 0; }

BondLimit limit_of(const deck::Deck& deck, const deck::Material& said, const mechanics::Scene& scene,
                   const materials::Material& material) {
  if (!said.damage) return {};
  const deck::Damage& damage = *said.damage;
  if (!material.from_sums())
    deck::refuse(damage.location, fmt::format("the model {} has no damage; remove the law", said.model));
  if (damage.ductile) {
    const std::vector<std::string> names = material.history().point;
    if (std::find(names.begin(), names.end(), "equivalent_plastic_strain") == names.end())
      deck::refuse(damage.location,
                   fmt::format("the model {} has no plastic strain for a ductile law to look at; take a plastic model, "
                               "or another law",
                               said.model));
    return {BondLimit::Kind::ductile, 1, *damage.ductile};
  }
  const auto refuse_energy = [&](const char* remedy) {
    if (flows(material))
      deck::refuse(damage.location,
                   fmt::format("the bonds of {} flow, so their energy says little about when they break; {}", said.name,
                               remedy));
  };
  if (damage.critical_stretch) return {BondLimit::Kind::stretch, *damage.critical_stretch, {}};
  if (damage.critical_bond_energy) {
    refuse_energy("take critical_stretch or ductile");
    return {BondLimit::Kind::energy, *damage.critical_bond_energy, {}};
  }
  const bool stretch = damage.criterion == deck::BreakCriterion::stretch ||
                       (damage.criterion == deck::BreakCriterion::automatic && flows(material));
  const double d = scene.dimension();
  const CrossedBonds crossed = crossed_bonds(deck, scene.families().horizon, spacing_of(deck, said));
  if (stretch)
    return {BondLimit::Kind::stretch,
            std::sqrt(*damage.energy_release_rate * crossed.weighted_volume /
                      (d * d * material.elastic_moduli(scene.dimension()).bulk * crossed.square)),
            {}};
  refuse_energy("take criterion: stretch");
  const double toughness = lattice_toughness(deck, scene.families().horizon, spacing_of(deck, said));
  return {BondLimit::Kind::energy, *damage.energy_release_rate / (crossed.count * toughness), {}, toughness};
}

}  // namespace

CrossedBonds crossed_bonds(const deck::Deck& deck, double horizon, double spacing) {
  return spacing > 0 ? lattice(deck, horizon, spacing) : continuum(deck, horizon);
}

std::vector<BondLimit> bond_limits(const deck::Deck& deck, const mechanics::Scene& scene) {
  std::vector<BondLimit> limits;
  for (std::size_t m = 0; m < deck.materials.size(); ++m)
    limits.push_back(limit_of(deck, deck.materials[m], scene, *scene.materials()[m]));
  return limits;
}

std::vector<std::string> describe(const std::vector<BondLimit>& limits, const deck::Deck& deck) {
  std::vector<std::string> lines;
  for (std::size_t m = 0; m < limits.size(); ++m) {
    const BondLimit& limit = limits[m];
    const std::string& name = deck.materials[m].name;
    if (limit.kind == BondLimit::Kind::stretch)
      lines.push_back(fmt::format("{}: bonds break at a stretch of {:.6g}", name, limit.limit));
    if (limit.kind == BondLimit::Kind::energy)
      lines.push_back(
          fmt::format("{}: bonds break at {:.6g} energy a volume squared{}", name, limit.limit,
                      limit.toughness == 1
                          ? std::string()
                          : fmt::format(", those of G_c/{:.3g}: a crack in a lattice takes more than its bonds hold",
                                        limit.toughness)));
    if (limit.kind == BondLimit::Kind::ductile)
      lines.push_back(fmt::format("{}: bonds break at a plastic strain of {:g} exp(-{:g} triaxiality)", name,
                                  limit.ductile.strain, limit.ductile.slope));
  }
  return lines;
}

}  // namespace perinox::solve
