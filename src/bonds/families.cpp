#include "perinox/bonds/families.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "perinox/body/neighbor_search.hpp"
#include "perinox/body/spacing.hpp"
#include "perinox/body/together.hpp"
#include "perinox/bonds/crack_surface.hpp"

namespace perinox::bonds {

namespace {

/// The rule that makes bonds, with what it needs of the particles.
class Rule {
 public:
  /// grid: of the body, or null.
  Rule(const deck::Deck& deck, const body::Body& body, double horizon, const CellGrid* grid)
      : deck_(deck), body_(body), horizon_(horizon) {
    edge_.reserve(body.volume.size());
    for (const double volume : body.volume) edge_.push_back(body::edge_of(volume, body.dimension));
    if (deck.quadrature == deck::Quadrature::position_aware) find_factor(grid);
  }

  bool may_bond(LocalIndex i, LocalIndex j) const {
    return i != j && (deck_.bond_bodies || body_.part[i] == body_.part[j]);
  }
  FoundBond bond(LocalIndex i, LocalIndex j) const {
    const double *a = body_.position(i), *b = body_.position(j);
    double squared = 0, between[3] = {};
    for (int c = 0; c < body_.dimension; ++c) {
      between[c] = b[c] - a[c];
      squared += between[c] * between[c];
    }
    return bond(j, between, std::sqrt(squared), (edge_[i] + edge_[j]) / 2);
  }
  /// between: reference bond vector, in any unit.
  FoundBond bond(LocalIndex j, const double* between, double length, double spacing) const {
    const double share = volume_share(deck_.quadrature, length, horizon_, spacing);
    const double influence = influence_value(deck_.influence, length, horizon_);
    return {j, length, share * body_.volume[j], influence * factor_(body_.dimension, between)};
  }

 private:
  /// Only where the body is one lattice on all ranks: they have to agree on every bond's weight.
  void find_factor(const CellGrid* grid) {
    std::optional<CellGrid> found;
    if (!grid && body_.local() > 0) {
      found = find_grid(body_);
      if (found) grid = &*found;
    }
    double spacing = grid ? grid->spacing : 0;
    const bool other = grid ? false : body_.local() > 0;
    const double largest = body_.communicator.max(spacing);
    if (body_.communicator.any(other || (grid && std::abs(spacing - largest) > 1e-10 * largest)) || largest == 0)
      return;
    spacing = largest;
    const int r = static_cast<int>(horizon_ / spacing * (1 + 1e-10)), flat = body_.dimension == 3 ? r : 0;
    for (int z = -flat; z <= flat; ++z)
      for (int y = -r; y <= r; ++y)
        for (int x = -r; x <= r; ++x) {
          const double step[3] = {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
          const double length = spacing * std::sqrt(step[0] * step[0] + step[1] * step[1] + step[2] * step[2]);
          if (length == 0) continue;
          factor_.add(body_.dimension, step,
                      volume_share(deck_.quadrature, length, horizon_, spacing) *
                          influence_value(deck_.influence, length, horizon_) * length * length);
        }
    factor_.finish();
  }

  const deck::Deck& deck_;
  const body::Body& body_;
  double horizon_;
  std::vector<double> edge_;  ///< [owned + ghosts] V^(1/d), length
  CubicFactor factor_;
};

/// Its contribution to the weighted volume; a bond without one carries nothing and is left out.
double moment(const FoundBond& bond) { return bond.influence * bond.length * bond.length * bond.weight; }

/// Fourth moments of the families, for those that need a fit or a factor.
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
    const FamilyKind kind = make_moment(d, sums, made);
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

/// Possible bonds of a particle, in ascending id of the neighbour.
class Candidates {
 public:
  virtual ~Candidates() = default;
  virtual void find(LocalIndex i, std::vector<FoundBond>& found) = 0;
};

/// By a k-d tree.
class Search : public Candidates {
 public:
  Search(const body::Body& body, const Rule& rule, double reach)
      : body_(body), rule_(rule), reach_(reach), tree_(body.reference, body.dimension) {}
  void find(LocalIndex i, std::vector<FoundBond>& found) override {
    found.clear();
    tree_.within(body_.position(i), reach_, near_);
    if (body_.ghosts > 0)
      std::sort(near_.begin(), near_.end(), [&](LocalIndex a, LocalIndex b) { return body_.id[a] < body_.id[b]; });
    for (const LocalIndex j : near_) {
      if (!rule_.may_bond(i, j)) continue;
      const FoundBond bond = rule_.bond(i, j);
      if (moment(bond) > 0) found.push_back(bond);
    }
  }

 private:
  const body::Body& body_;
  const Rule& rule_;
  double reach_;
  body::NeighborSearch tree_;
  std::vector<LocalIndex> near_;
};

/// On a lattice every particle has the same candidates: the bonds are worked out once.
class Stencil : public Candidates {
 public:
  Stencil(const body::Body& body, const Rule& rule, double reach, const CellGrid& grid)
      : body_(body), rule_(rule), grid_(grid) {
    const int r = static_cast<int>(reach / grid.spacing * (1 + 1e-10));
    const int flat = grid.dimension == 3 ? r : 0;
    for (int z = -flat; z <= flat; ++z)
      for (int y = -r; y <= r; ++y)
        for (int x = -r; x <= r; ++x) {
          if (x == 0 && y == 0 && z == 0) continue;
          const double length = grid.spacing * std::sqrt(static_cast<double>(x * x + y * y + z * z));
          if (length > reach * (1 + 1e-10)) continue;
          const double between[3] = {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
          FoundBond bond = rule.bond(0, between, length, grid.spacing);
          if (moment(bond) <= 0) continue;
          bond.weight /= body.volume[0];  // the share, until the neighbour is known
          steps_.push_back({x, y, z});
          bonds_.push_back(bond);
        }
  }
  void find(LocalIndex i, std::vector<FoundBond>& found) override {
    found.clear();
    const auto at = grid_.position(grid_.cell[i]);
    bool ascending = true;
    for (std::size_t k = 0; k < steps_.size(); ++k) {
      const LocalIndex j = grid_.neighbor(at, steps_[k]);
      if (j < 0 || !rule_.may_bond(i, j)) continue;
      ascending = ascending && (found.empty() || body_.id[found.back().neighbor] < body_.id[j]);
      found.push_back(bonds_[k]);
      found.back().neighbor = j;
      found.back().weight *= body_.volume[j];
    }
    if (ascending) return;
    std::sort(found.begin(), found.end(),
              [&](const FoundBond& a, const FoundBond& b) { return body_.id[a.neighbor] < body_.id[b.neighbor]; });
  }

 private:
  const body::Body& body_;
  const Rule& rule_;
  const CellGrid& grid_;
  std::vector<std::array<int, 3>> steps_;
  std::vector<FoundBond> bonds_;
};

/// The pre-cracks, and how many bonds each has cut.
class Cracks {
 public:
  Cracks(const deck::Deck& deck, const body::Body& body, double horizon, double reach) : deck_(deck), body_(body) {
    for (const deck::Crack& crack : deck.cracks) {
      surfaces_.emplace_back(crack, 1e-9 * horizon);
      cut_by_.push_back(0);
    }
    reach_ = reach * (1 + 1e-6);
  }
  /// Which surfaces come near particle i.
  void approach(LocalIndex i) {
    near_.clear();
    for (std::size_t k = 0; k < surfaces_.size(); ++k)
      if (surfaces_[k].within(body_.position3(i), reach_)) near_.push_back(k);
  }
  bool cut(LocalIndex i, LocalIndex j) {
    bool any = false;
    for (const std::size_t k : near_) {
      if (!surfaces_[k].cuts(body_.position3(i), body_.position3(j))) continue;
      ++cut_by_[k];
      any = true;
    }
    return any;
  }
  void refuse_idle() const {
    for (std::size_t k = 0; k < surfaces_.size(); ++k) {
      if (body_.communicator.sum(cut_by_[k]) > 0) continue;
      deck::refuse(deck_.cracks[k].location,
                   "this crack cuts no bond; move it into the body, make it larger than the "
                   "spacing, or take it out");
    }
  }

 private:
  const deck::Deck& deck_;
  const body::Body& body_;
  double reach_ = 0;
  std::vector<CrackSurface> surfaces_;
  std::vector<long long> cut_by_;
  std::vector<std::size_t> near_;
};

/// The first particle without a family cannot carry any force: the system would be singular.
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
  // A body made by hand has no reach on record; all its particles are at hand.
  const double within =
      body.reach > 0 ? body.reach : reach(deck, horizon, body::largest_spacing(deck, body.communicator));
  if (within < horizon * (1 - 1e-12)) throw std::logic_error("the body was built with a reach below the horizon");

  const Rule rule(deck, body, horizon, grid);
  std::unique_ptr<Candidates> candidates;
  if (grid)
    candidates = std::make_unique<Stencil>(body, rule, within, *grid);
  else
    candidates = std::make_unique<Search>(body, rule, within);
  Cracks cracks(deck, body, horizon, within);
  const auto owned = static_cast<std::size_t>(body.owned);
  families.size.resize(owned);
  families.weighted_volume.resize(owned);
  families.damage.resize(owned);
  Fits fits(deck, body, families);
  std::vector<FoundBond> found, whole;
  for (const LocalIndex i : order) {
    candidates->find(i, found);
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
  cracks.refuse_idle();
  refuse_lonely(deck, body, families);
  return families;
}

}  // namespace perinox::bonds
