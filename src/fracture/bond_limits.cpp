#include "perinox/fracture/bond_limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace perinox::fracture {

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

std::size_t material_of(const deck::Deck& deck, const deck::BodyPart& part) {
  const auto found = std::find_if(deck.materials.begin(), deck.materials.end(),
                                  [&](const deck::Material& material) { return material.name == part.material; });
  return static_cast<std::size_t>(found - deck.materials.begin());
}

/// What is said of a limit; "" of one that never breaks.
std::string in_words(const BondLimit& limit) {
  switch (limit.kind) {
    case BondLimit::Kind::none:
      return "";
    case BondLimit::Kind::stretch:
      return fmt::format("bonds break at a stretch of {:.6g}", limit.limit);
    case BondLimit::Kind::energy:
      return fmt::format("bonds break at {:.6g} energy a volume squared{}", limit.limit,
                         limit.toughness == 1
                             ? std::string()
                             : fmt::format(", those of G_c/{:.3g}: a crack in a lattice takes more than its bonds hold",
                                           limit.toughness));
    case BondLimit::Kind::ductile:
      return fmt::format("bonds break at a plastic strain of {:g} exp(-{:g} triaxiality)", limit.ductile.strain,
                         limit.ductile.slope);
  }
  return "";
}

bool flows(const materials::Material& material) { return material.history().per_bond > 0; }

/// spacing: of the body's lattice; 0: a cloud.
BondLimit limit_of(const deck::Deck& deck, const deck::Material& said, const mechanics::Scene& scene,
                   const materials::Material& material, double spacing) {
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
  const CrossedBonds crossed = crossed_bonds(deck, scene.families().horizon, spacing);
  if (stretch)
    return {BondLimit::Kind::stretch,
            std::sqrt(*damage.energy_release_rate * crossed.weighted_volume /
                      (d * d * material.elastic_moduli(scene.dimension()).bulk * crossed.square)),
            {}};
  refuse_energy("take criterion: stretch");
  const double toughness = lattice_toughness(deck, scene.families().horizon, spacing);
  return {BondLimit::Kind::energy, *damage.energy_release_rate / (crossed.count * toughness), {}, toughness};
}

}  // namespace

CrossedBonds crossed_bonds(const deck::Deck& deck, double horizon, double spacing) {
  return spacing > 0 ? lattice(deck, horizon, spacing) : continuum(deck, horizon);
}

std::vector<BondLimit> bond_limits(const deck::Deck& deck, const mechanics::Scene& scene) {
  std::vector<BondLimit> limits;
  for (std::size_t part = 0; part < deck.body.size(); ++part) {
    const std::size_t m = material_of(deck, deck.body[part]);
    limits.push_back(
        limit_of(deck, deck.materials[m], scene, *scene.materials()[m], scene.body().lattice_spacing[part]));
  }
  return limits;
}

std::vector<std::string> describe(const std::vector<BondLimit>& limits, const deck::Deck& deck) {
  std::vector<std::string> lines;
  for (const deck::Material& material : deck.materials) {
    std::vector<std::pair<std::string, std::string>> said;  // body, what is said of it
    for (std::size_t part = 0; part < limits.size(); ++part)
      if (deck.body[part].material == material.name && limits[part].kind != BondLimit::Kind::none)
        said.emplace_back(deck.body[part].name, in_words(limits[part]));
    const bool alike =
        std::all_of(said.begin(), said.end(), [&](const auto& one) { return one.second == said[0].second; });
    for (std::size_t k = 0; k < (alike ? std::min<std::size_t>(1, said.size()) : said.size()); ++k)
      lines.push_back(alike ? fmt::format("{}: {}", material.name, said[k].second)
                            : fmt::format("{} in {}: {}", material.name, said[k].first, said[k].second));
  }
  return lines;
}

}  // namespace perinox::fracture
