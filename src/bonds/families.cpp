#include "perinox/bonds/families.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "bond_rule.hpp"
#include "candidates.hpp"
#include "gaps.hpp"
#include "perinox/body/together.hpp"
#include "pre_cracks.hpp"

namespace perinox::bonds {

namespace {

/// Collects the fourth moments of the families, for quadratures that need a fit or a factor.
class Fits {
 public:
  Fits(const deck::Deck& deck, const body::Body& body, Families& families)
      : wanted_(deck.quadrature == deck::Quadrature::position_aware),
        scaled_(deck.quadrature == deck::Quadrature::surface_energy),
        body_(body),
        families_(families) {
    if (wanted_) families.fit.assign(static_cast<std::size_t>(body.owned), -1);
    if (scaled_) families.deviatoric_volume.resize(static_cast<std::size_t>(body.owned));
  }
  void add(LocalIndex i, const std::vector<FoundBond>& family) {
    if (!wanted_ && !scaled_) return;
    const int d = body_.dimension, n = mandel_size(d);
    std::array<double, 36> sums{};
    for (const FoundBond& bond : family) {
      double between[3] = {};
      for (int c = 0; c < d; ++c) between[c] = (body_.position(bond.neighbor)[c] - body_.position(i)[c]) / bond.length;
      const Mandel direction = mandel(d, between, 1);
      for (int p = 0; p < n; ++p)
        for (int q = 0; q < n; ++q)
          sums[static_cast<std::size_t>(p * n + q)] += moment(bond) * direction[p] * direction[q];
    }
    if (scaled_) {
      families_.deviatoric_volume[i] = deviatoric_volume(d, sums);
      return;
    }
    Moment made;
    const FamilyKind kind = make_moment(d, sums, 8 * body_.rounding(i) / body_.spacing_of(i), made);
    if (kind == FamilyKind::deficient) ++families_.deficient;
    if (kind != FamilyKind::irregular) return;
    families_.fit[i] = static_cast<std::int32_t>(families_.moments.size());
    families_.moments.push_back(made);
  }
  void finish() {
    families_.moments.shrink_to_fit();
    if (families_.moments.empty()) families_.fit = {};
  }

 private:
  bool wanted_, scaled_;
  const body::Body& body_;
  Families& families_;
};

/// Refuses the body if a particle has no family: it cannot carry any force and the system would be singular.
void refuse_lonely(const deck::Deck& deck, const body::Body& body, const Families& families) {
  std::string sentence;
  deck::Location where;
  GlobalId id = 0;
  for (LocalIndex i = 0; i < body.owned && sentence.empty(); ++i) {
    if (families.size[i] > 0) continue;
    id = body.id[i];
    where = deck.body[static_cast<std::size_t>(body.part[i])].location;
    const deck::Point x = body.position3(i);
    const std::string who = fmt::format("particle {} at ({:g}, {:g}, {:g})", id, x[0], x[1], x[2]);
    if (body.total == 1) {
      sentence = who + " is the only one, so there is no bond; make the spacing smaller or add particles";
    } else if (families.damage[i] > 0) {
      sentence = who + " has lost all its bonds to pre-cracks; move the cracks, or make the horizon larger";
    } else {
      sentence = fmt::format(
          "{} has no neighbour {}within the horizon {:g}; make the horizon larger, or take the "
          "particle out",
          who, deck.bond_bodies ? "" : "of its own body ", families.horizon);
    }
  }
  body::refuse_first(body.communicator, id, sentence.empty() ? sentence : deck::placed(where, sentence));
}

}  // namespace

Families find_families(const deck::Deck& deck, const body::Body& body, double horizon, const CellGrid* grid,
                       const std::vector<LocalIndex>& order, const FamilyReceiver& receive) {
  Families families;
  families.horizon = horizon;
  families.influence = deck.influence;
  families.continuum_weighted_volume = continuum_weighted_volume(deck.influence, horizon, body.dimension);
  // A body made by hand has no reach on record. All its particles are on this rank.
  const double within =
      body.reach > 0 ? body.reach : reach(deck, horizon, body::largest_spacing(deck, body.communicator));
  if (within < horizon * (1 - 1e-12)) throw std::logic_error("the body was built with a reach below the horizon");

  BondRule rule(deck, body, horizon);
  if (!grid) rule.prepare();
  const std::unique_ptr<Candidates> candidates = make_candidates(body, rule, within, grid);
  const Gaps gaps(deck, body, horizon, within);
  PreCracks cracks(deck, body, horizon, within);
  const auto owned = static_cast<std::size_t>(body.owned);
  families.size.resize(owned);
  families.weighted_volume.resize(owned);
  families.damage.resize(owned);
  Fits fits(deck, body, families);
  std::vector<FoundBond> found, whole;
  for (const LocalIndex i : order) {
    candidates->find(i, found);
    families.across_gaps += gaps.remove(i, found);
    cracks.approach(i);
    double uncut = 0, remaining = 0;
    whole.clear();
    for (const FoundBond& bond : found) {
      uncut += moment(bond);
      if (cracks.cut(i, bond.neighbor)) {
        ++families.cut;
        continue;
      }
      remaining += moment(bond);
      whole.push_back(bond);
    }
    families.size[i] = static_cast<int>(whole.size());
    families.directed += families.size[i];
    families.weighted_volume[i] = remaining;
    families.damage[i] = uncut > remaining ? (uncut - remaining) / uncut : 0.0;
    fits.add(i, whole);
    receive(i, whole);
  }
  fits.finish();
  cracks.refuse_unclear();
  refuse_lonely(deck, body, families);
  return families;
}

}  // namespace perinox::bonds
