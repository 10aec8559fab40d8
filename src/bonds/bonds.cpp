#include "perinox/bonds/bonds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "perinox/body/neighbor_search.hpp"
#include "perinox/body/spacing.hpp"
#include "perinox/body/together.hpp"
#include "perinox/bonds/crack_surface.hpp"

namespace perinox::bonds {

namespace {

/// What one bond is made of, before cracks.
struct Bond {
  double length;
  double weight;
  double influence;
  /// Its contribution to the weighted volume; a bond without one carries nothing and is left out.
  double moment() const { return influence * length * length * weight; }
};

/// The rule that makes bonds, with what it needs of the particles.
class Rule {
 public:
  Rule(const deck::Deck& deck, const body::Body& body, double horizon) : deck_(deck), body_(body), horizon_(horizon) {
    edge_.reserve(body.volume.size());
    for (const double volume : body.volume) edge_.push_back(body::edge_of(volume, body.dimension));
  }

  bool may_bond(LocalIndex i, LocalIndex j) const {
    return i != j && (deck_.bond_bodies || body_.part[i] == body_.part[j]);
  }
  Bond bond(LocalIndex i, LocalIndex j) const {
    const double *a = body_.position(i), *b = body_.position(j);
    double squared = 0;
    for (int c = 0; c < body_.dimension; ++c) squared += (b[c] - a[c]) * (b[c] - a[c]);
    const double length = std::sqrt(squared);
    const double share = volume_share(deck_.quadrature, length, horizon_, (edge_[i] + edge_[j]) / 2);
    return {length, share * body_.volume[j], influence_value(deck_.influence, length, horizon_)};
  }

 private:
  const deck::Deck& deck_;
  const body::Body& body_;
  double horizon_;
  std::vector<double> edge_;  ///< [owned + ghosts] V^(1/d), length
};

std::vector<CrackSurface> surfaces(const deck::Deck& deck, double horizon) {
  std::vector<CrackSurface> all;
  for (const deck::Crack& crack : deck.cracks) all.emplace_back(crack, 1e-9 * horizon);
  return all;
}

/// Finds the families and what the cracks cut from them; weights are filled in later, in arrays of the exact size,
/// because bonds are most of the memory of a run.
void find_families(const deck::Deck& deck, const body::Body& body, const Rule& rule, double reach, Bonds& bonds) {
  const std::vector<CrackSurface> cracks = surfaces(deck, bonds.horizon);
  std::vector<long long> cut_by(cracks.size());
  const body::NeighborSearch search(body.reference, body.dimension);
  const auto ascending_id = [&](LocalIndex a, LocalIndex b) { return body.id[a] < body.id[b]; };
  bonds.offset.reserve(static_cast<std::size_t>(body.owned) + 1);
  bonds.offset.push_back(0);
  std::vector<LocalIndex> found;
  for (LocalIndex i = 0; i < body.owned; ++i) {
    search.within(body.position(i), reach, found);
    if (body.ghosts > 0) std::sort(found.begin(), found.end(), ascending_id);
    double uncut = 0, remaining = 0;
    for (const LocalIndex j : found) {
      if (!rule.may_bond(i, j)) continue;
      const double moment = rule.bond(i, j).moment();
      if (moment <= 0) continue;
      uncut += moment;
      bool cut = false;
      for (std::size_t k = 0; k < cracks.size(); ++k) {
        if (!cracks[k].cuts(body.position3(i), body.position3(j))) continue;
        ++cut_by[k];
        cut = true;
      }
      if (cut) {
        ++bonds.cut;
        continue;
      }
      remaining += moment;
      bonds.neighbor.push_back(j);
    }
    bonds.offset.push_back(static_cast<std::int64_t>(bonds.neighbor.size()));
    bonds.weighted_volume.push_back(remaining);
    bonds.damage.push_back(uncut > remaining ? (uncut - remaining) / uncut : 0.0);
  }
  bonds.neighbor.shrink_to_fit();
  for (std::size_t k = 0; k < cracks.size(); ++k) {
    if (body.communicator.sum(cut_by[k]) > 0) continue;
    deck::refuse(deck.cracks[k].location,
                 "this crack cuts no bond; move it into the body, make it larger than the "
                 "spacing, or take it out");
  }
}

/// The first particle without a family cannot carry any force: the system would be singular.
void refuse_lonely(const deck::Deck& deck, const body::Body& body, const Bonds& bonds) {
  std::string sentence;
  deck::Location where;
  GlobalId id = 0;
  for (LocalIndex i = 0; i < body.owned && sentence.empty(); ++i) {
    if (bonds.family_size(i) > 0) continue;
    id = body.id[i];
    where = deck.body[static_cast<std::size_t>(body.part[i])].location;
    const deck::Point x = body.position3(i);
    const std::string who = fmt::format("particle {} at ({:g}, {:g}, {:g})", id, x[0], x[1], x[2]);
    if (body.total == 1) {
      sentence = who + " is the only one, so there is no bond; make the spacing smaller or add particles";
    } else if (bonds.damage[i] > 0) {
      sentence = who + " has lost all its bonds to pre-cracks; move the cracks, or make the horizon larger";
    } else {
      sentence = fmt::format(
          "{} has no neighbour {}within the horizon {:g}; make the horizon larger, or take the "
          "particle out",
          who, deck.bond_bodies ? "" : "of its own body ", bonds.horizon);
    }
  }
  body::refuse_first(body.communicator, id, sentence.empty() ? sentence : deck::placed(where, sentence));
}

}  // namespace

Bonds build(const deck::Deck& deck, const body::Body& body, double horizon) {
  Bonds bonds;
  bonds.horizon = horizon;
  bonds.continuum_weighted_volume = continuum_weighted_volume(deck.influence, horizon, body.dimension);
  // A body made by hand has no reach on record; all its particles are at hand.
  const double within =
      body.reach > 0 ? body.reach : reach(deck, horizon, body::largest_spacing(deck, body.communicator));
  if (within < horizon * (1 - 1e-12)) throw std::logic_error("the body was built with a reach below the horizon");

  const Rule rule(deck, body, horizon);
  find_families(deck, body, rule, within, bonds);
  refuse_lonely(deck, body, bonds);
  bonds.length.resize(bonds.neighbor.size());
  bonds.weight.resize(bonds.neighbor.size());
  bonds.influence.resize(bonds.neighbor.size());
  for (LocalIndex i = 0; i < body.owned; ++i) {
    for (std::int64_t k = bonds.offset[i]; k < bonds.offset[i + 1]; ++k) {
      const Bond bond = rule.bond(i, bonds.neighbor[k]);
      bonds.length[k] = bond.length;
      bonds.weight[k] = bond.weight;
      bonds.influence[k] = bond.influence;
    }
  }
  return bonds;
}

}  // namespace perinox::bonds
