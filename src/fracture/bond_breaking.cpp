#include "perinox/fracture/bond_breaking.hpp"

#include <algorithm>
#include <cmath>

#include "perinox/fracture/broken_bonds.hpp"
#include "perinox/fracture/loose_pieces.hpp"

namespace perinox::fracture {

namespace {
std::size_t point_size(int dimension) { return 2 + static_cast<std::size_t>(bonds::mandel_size(dimension)); }
}  // namespace

BondBreaking::BondBreaking(const deck::Deck& deck, mechanics::Scene& scene,
                           std::shared_ptr<mechanics::Evaluation> evaluation)
    : scene_(scene),
      evaluation_(std::move(evaluation)),
      limits_(bond_limits(deck, scene)),
      unbreakable_(static_cast<std::size_t>(scene.local()), 0) {
  const body::Body& body = scene.body();
  std::vector<double> mark(static_cast<std::size_t>(scene.local()), 0.0);
  for (const std::string& set : deck.fracture.unbreakable)
    for (const LocalIndex i : body.sets.at(set)) mark[i] = 1;
  body.halo.update_ghosts(mark.data(), 1);
  std::transform(mark.begin(), mark.end(), unbreakable_.begin(), [](double m) { return static_cast<char>(m != 0); });
  bonds_ = body.communicator.sum(scene.families().directed) / 2;
  for (const BondLimit& limit : limits_) {
    energies_ = energies_ || limit.kind == BondLimit::Kind::energy;
    ductile_ = ductile_ || limit.kind == BondLimit::Kind::ductile;
  }
  for (const auto& material : scene.materials()) {
    const std::vector<std::string> names = material->history().point;
    strain_place_.push_back(
        static_cast<std::size_t>(std::find(names.begin(), names.end(), "equivalent_plastic_strain") - names.begin()));
  }
  if (ductile_) stress_ = std::make_unique<mechanics::Stress>(scene);
}

void BondBreaking::find_points(const mechanics::Committed& state) {
  const body::Body& body = scene_.body();
  if (energies_) {
    const std::size_t n = point_size(scene_.dimension());
    points_.assign(n * static_cast<std::size_t>(scene_.local()), 0.0);
    if (!evaluation_) evaluation_ = std::make_shared<mechanics::Evaluation>(scene_);
    mechanics::force_states(*evaluation_, state, points_.data());
    body.halo.update_ghosts(points_.data(), static_cast<int>(n));
  }
  if (!ductile_) return;
  stress_->evaluate(state);
  failure_.assign(static_cast<std::size_t>(scene_.local()), -1.0);
  for (LocalIndex i = 0; i < scene_.owned(); ++i) {
    const BondLimit& limit = limits_[static_cast<std::size_t>(body.part[i])];
    if (limit.kind != BondLimit::Kind::ductile) continue;
    const double strain = state.point_history(scene_, i)[strain_place_[static_cast<std::size_t>(body.material[i])]];
    const double* s = &stress_->stress()[6 * static_cast<std::size_t>(i)];
    const double von_mises = stress_->von_mises()[i];
    const double triaxiality = von_mises > 0 ? (s[0] + s[3] + s[5]) / (3 * von_mises) : 0;
    failure_[i] = strain / (limit.ductile.strain * std::exp(-limit.ductile.slope * triaxiality));
  }
  body.halo.update_ghosts(failure_.data(), 1);
}

/// What the stored energy loses when the bond goes and nothing moves, to first order in its share of the family:
/// t e - omega shear e^2/2 at either end, t = omega (radial xi + shear e + xi N . H), the quadrature's share in omega.
/// Half of t e would leave out that the dilatation goes with it.
double BondBreaking::energy(LocalIndex lower, LocalIndex upper, double length, double weight, double extension) const {
  const int d = scene_.dimension(), n = bonds::mandel_size(d);
  double direction[3] = {};
  for (int c = 0; c < d; ++c)
    direction[c] = (scene_.body().position(upper)[c] - scene_.body().position(lower)[c]) / length;
  const bonds::Mandel basis = bonds::mandel(d, direction, length);
  double sum = 0;
  for (const LocalIndex i : {lower, upper}) {
    const double* point = &points_[point_size(d) * static_cast<std::size_t>(i)];
    double t = point[0] * length + point[1] * extension / 2;
    for (int k = 0; k < n; ++k) t += basis[static_cast<std::size_t>(k)] * point[2 + k];
    sum += t;
  }
  return weight * sum * extension;
}

double BondBreaking::ratio(LocalIndex lower, LocalIndex upper, double length, double weight,
                           const double* displacement) const {
  const body::Body& body = scene_.body();
  const BondLimit* ends[2] = {&limits_[static_cast<std::size_t>(body.part[lower])],
                              &limits_[static_cast<std::size_t>(body.part[upper])]};
  const int d = scene_.dimension();
  double square = 0, change = 0;  // |Y|^2 - xi^2 = (2 X + U) . U without cancellation
  for (int c = 0; c < d; ++c) {
    const double reference = body.position(upper)[c] - body.position(lower)[c];
    const double relative =
        displacement[static_cast<std::size_t>(upper) * d + c] - displacement[static_cast<std::size_t>(lower) * d + c];
    square += (reference + relative) * (reference + relative);
    change += scene_.small_strain() ? reference * relative / length : (2 * reference + relative) * relative;
  }
  const double extension = scene_.small_strain() ? change : change / (std::sqrt(square) + length);
  if (!(extension > 0)) return 0;
  double worst = 0;
  for (const BondLimit* end : ends) {
    if (end->kind == BondLimit::Kind::stretch) worst = std::max(worst, extension / length / end->limit);
    if (end->kind == BondLimit::Kind::energy)
      worst = std::max(worst, energy(lower, upper, length, weight, extension) / end->limit);
  }
  if (!ductile_) return worst;
  const double one = failure_[lower], other = failure_[upper];
  if (one >= 0 || other >= 0) worst = std::max(worst, one < 0 ? other : other < 0 ? one : (one + other) / 2);
  return worst;
}

void BondBreaking::count_also(const LoosePieces& loose) {
  broken_ += loose.broken;
  rounds_.insert(rounds_.end(), loose.rounds.begin(), loose.rounds.end());
}

void BondBreaking::resume(const BrokenBonds& broken) {
  broken_ = broken.count();
  rounds_ = broken.rounds();
}

BondBreaking::Result BondBreaking::break_worst(const mechanics::Committed& state, long long most) {
  find_points(state);
  const double* displacement = state.displacement().data();
  Judged judged;
  if (scene_.lattice())
    scene_.lattice()->each([&](LocalIndex near, LocalIndex far, const bonds::StencilOffset& offset) {
      judge(near, far, offset.length, offset.influence * offset.share, displacement, judged);
    });
  else
    scene_.pairs()->each([&](LocalIndex near, LocalIndex far, double length, double weight) {
      judge(near, far, length, weight, displacement, judged);
    });
  return break_above(judged, most, state.plastic());
}

long long BondBreaking::break_all(MovingState& motion) {
  if (ductile_) {
    find_points(motion.committed());
  } else if (energies_) {
    points_.resize(point_size(scene_.dimension()) * static_cast<std::size_t>(scene_.local()));
    motion.force_states(points_.data());
    scene_.body().halo.update_ghosts(points_.data(), static_cast<int>(point_size(scene_.dimension())));
  }
  const double* displacement = motion.displacement().data();
  if (!screen_) screen_ = std::make_unique<BondScreen>(scene_, limits_);
  Judged judged;
  for (const BondScreen::Candidate& bond : screen_->find(displacement, energies_ ? points_.data() : nullptr))
    judge(bond.near, bond.far, bond.length, bond.weight, displacement, judged);
  const long long broken = break_above(judged, bonds_, motion.plastic()).broken;
  if (broken > 0) motion.bonds_have_broken();
  return broken;
}

void BondBreaking::judge(LocalIndex near, LocalIndex far, double length, double weight, const double* displacement,
                         Judged& judged) const {
  if (unbreakable_[near] || unbreakable_[far]) return;
  const bool swap = scene_.body().id[near] > scene_.body().id[far];
  const LocalIndex lower = swap ? far : near, upper = swap ? near : far;
  const double value = ratio(lower, upper, length, weight, displacement);
  judged.worst = std::max(judged.worst, value);
  if (value < 1 - tie) return;
  judged.critical.push_back({value, {lower, upper}});
  if (lower < scene_.owned()) judged.counted.push_back(value);
}

BondBreaking::Result BondBreaking::break_above(const Judged& judged, long long most,
                                               const mechanics::PlasticExtension& plastic) {
  const body::Body& body = scene_.body();
  Result result;
  result.worst = body.communicator.max(judged.worst);
  if (result.worst < 1 - tie) return result;

  std::vector<double> all = body.communicator.gather(judged.counted);
  std::sort(all.begin(), all.end(), std::greater<>());
  result.critical = static_cast<long long>(all.size());
  if (most == 0) return result;
  const auto last = static_cast<std::size_t>(std::clamp(most, 1LL, result.critical)) - 1;
  const double least = all[last] * (1 - tie);
  std::vector<mechanics::BondEnds> ends;
  for (const Critical& bond : judged.critical)
    if (bond.ratio >= least) ends.push_back(bond.ends);
  rounds_.push_back(scene_.broken().size());
  scene_.break_bonds(ends, &plastic);
  result.broken = std::count_if(all.begin(), all.end(), [&](double value) { return value >= least; });
  broken_ += result.broken;
  return result;
}

}  // namespace perinox::fracture
