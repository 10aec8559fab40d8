#include "perinox/fracture/loose_pieces.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "perinox/bonds/components.hpp"
#include "perinox/loads/rigid_modes.hpp"
#include "perinox/mechanics/each_bond.hpp"

namespace perinox::fracture {

namespace {

/// Least eigenvalue of the sum of n (x) n over a family, relative to its largest, that holds a particle.
constexpr double least_resistance = 1e-3;
/// Families that have lost less than this are not looked at.
constexpr double much_damage = 0.5;
/// Single pieces named in the log; the others are counted.
constexpr int most_named = 3;
/// Loads push a piece along a motion where their power is more than this share of what it would be, did they all point
/// that way: in between is what rounding leaves of loads that balance.
constexpr double least_push = 1e-9;

/// Marks [local] the particles whose families hold them against less than every motion.
std::vector<double> find_hanging(const mechanics::Scene& scene) {
  const body::Body& body = scene.body();
  const int d = scene.dimension();
  const std::vector<double>& damage = scene.families().damage;
  std::vector<double> hanging(static_cast<std::size_t>(scene.local()), 0.0);
  std::vector<int> number(static_cast<std::size_t>(scene.owned()), -1);
  std::vector<Eigen::Matrix3d> sums;
  for (LocalIndex i = 0; i < scene.owned(); ++i) {
    if (damage[i] < much_damage || scene.families().size[i] == 0) continue;
    number[i] = static_cast<int>(sums.size());
    sums.emplace_back(Eigen::Matrix3d::Zero());
  }
  if (body.communicator.any(!sums.empty()))
    mechanics::each_bond(scene, [&](LocalIndex i, LocalIndex j) {
      Eigen::Vector3d n = Eigen::Vector3d::Zero();
      for (int c = 0; c < d; ++c) n(c) = body.position(j)[c] - body.position(i)[c];
      n.normalize();
      for (const LocalIndex end : {i, j})
        if (end < scene.owned() && number[end] >= 0) sums[static_cast<std::size_t>(number[end])] += n * n.transpose();
    });
  for (LocalIndex i = 0; i < scene.owned(); ++i) {
    if (number[i] < 0) continue;
    const Eigen::MatrixXd sum = sums[static_cast<std::size_t>(number[i])].topLeftCorner(d, d);
    const Eigen::VectorXd values = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(sum).eigenvalues();
    if (values(0) < least_resistance * values(d - 1)) hanging[i] = 1;
  }
  body.halo.update_ghosts(hanging.data(), 1);
  return hanging;
}

/// Breaks the bonds of hanging particles; how many over all ranks.
long long cut_hanging(mechanics::Scene& scene, const mechanics::PlasticExtension& plastic) {
  const std::vector<double> hanging = find_hanging(scene);
  std::vector<mechanics::BondEnds> ends;
  long long counted = 0;
  mechanics::each_bond(scene, [&](LocalIndex i, LocalIndex j) {
    if (hanging[i] == 0 && hanging[j] == 0) return;
    ends.push_back({i, j});
    const LocalIndex lower = scene.body().id[i] < scene.body().id[j] ? i : j;
    if (lower < scene.owned()) ++counted;
  });
  const long long all = scene.body().communicator.sum(counted);
  if (all > 0) scene.break_bonds(ends, &plastic);
  return all;
}

/// The pieces that the supports hold in part, and that their loads push along a motion left free. touched: [count] more
/// than 0 where some displacement of a piece that is not out yet is prescribed. Collective.
std::vector<loads::FreePiece> find_pushed(const mechanics::Scene& scene, const loads::Boundary& boundary,
                                          const bonds::Components& components, const std::vector<double>& touched,
                                          const PiecesLoads& loads) {
  const body::Body& body = scene.body();
  const auto d = static_cast<std::size_t>(scene.dimension());
  // As long as all supports are on one piece it is held as the whole was.
  if (std::count_if(touched.begin(), touched.end(), [](double t) { return t > 0; }) < 2) return {};
  std::vector<double> loaded(touched.size(), 0.0), contact(touched.size(), 0.0);
  const auto piece_of = [&](std::size_t u) { return static_cast<std::size_t>(components.of[u / d]); };
  for (std::size_t u = 0; u < scene.owned_unknowns(); ++u) {
    if (boundary.prescribed()[u]) continue;
    if (loads.given[u] != 0) loaded[piece_of(u)] = 1;
    if (loads.all[u] != loads.given[u]) contact[piece_of(u)] = 1;
  }
  body.communicator.max(loaded);
  body.communicator.max(contact);
  const auto pushable = [&](std::size_t k) { return touched[k] > 0 && loaded[k] > 0 && contact[k] == 0; };
  bool any = false;
  for (std::size_t k = 0; k < touched.size(); ++k) any = any || pushable(k);
  if (!any) return {};

  std::vector<loads::FreePiece> pushed;
  for (loads::FreePiece& piece : loads::find_free_pieces(body, components, boundary.prescribed(), true)) {
    if (!pushable(static_cast<std::size_t>(piece.component))) continue;
    for (std::size_t m = 0; m < piece.free.size(); ++m) {
      const loads::RigidMotion& motion = piece.free[m];
      if (motion.turns() && !scene.small_strain()) continue;
      std::vector<double> sums{0, 0};
      for (LocalIndex i = 0; i < scene.owned(); ++i) {
        if (components.of[i] != piece.component) continue;
        const deck::Point rate = motion.at(body.position3(i), piece.center);
        for (std::size_t c = 0; c < d; ++c) {
          const double power = loads.given[static_cast<std::size_t>(i) * d + c] * rate[c];
          sums[0] += power;
          sums[1] += std::abs(power);
        }
      }
      body.communicator.sum(sums);
      if (!(std::abs(sums[0]) > least_push * sums[1])) continue;
      piece.motions = {piece.motions[m]};
      pushed.push_back(std::move(piece));
      break;
    }
  }
  return pushed;
}

/// Breaks bonds of particles that they cannot hold, until none is left.
void cut_all_hanging(mechanics::Scene& scene, const mechanics::PlasticExtension& plastic, LoosePieces& found) {
  for (;;) {
    const std::size_t before = scene.broken().size();
    const long long cut = cut_hanging(scene, plastic);
    if (cut == 0) break;
    found.rounds.push_back(before);
    found.broken += cut;
  }
  if (found.broken > 0)
    found.sentences.push_back(
        fmt::format("{} bonds broken that were the last of particles they could not hold", found.broken));
}

/// Says which pieces, of those marked, have lost all support. Returns how many there are.
int name_pieces(const bonds::Components& components, const std::vector<char>& lost, LoosePieces& found) {
  int pieces = 0, single = 0;
  for (std::size_t k = 0; k < lost.size(); ++k) {
    if (!lost[k]) continue;
    ++pieces;
    if (components.particles[k] == 1) ++single;
    if (components.particles[k] > 1 && pieces - single <= most_named)
      found.sentences.push_back(
          fmt::format("a piece of {} particles, the first of them {}, has lost all support and is held where it is",
                      components.particles[k], components.first[k]));
  }
  if (pieces - single > most_named) found.sentences.push_back(fmt::format("{} loose pieces in all", pieces - single));
  if (single > 0)
    found.sentences.push_back(
        fmt::format("{} single particles have lost all their bonds and are held where they are", single));
  return pieces;
}

}  // namespace

LoosePieces find_loose(mechanics::Scene& scene, const loads::Boundary& boundary,
                       const mechanics::PlasticExtension& plastic, const PiecesLoads& loads) {
  const body::Body& body = scene.body();
  const int d = scene.dimension();
  LoosePieces found;
  found.loose.assign(static_cast<std::size_t>(scene.owned()), 0);
  cut_all_hanging(scene, plastic, found);
  const bonds::Components components = bonds::connected_components(body, scene.bond_graph());
  const auto count = static_cast<std::size_t>(components.count());
  std::vector<double> touched(count, 0.0), known(count, 0.0);
  std::vector<char> pushed(count, 0);
  int pushed_pieces = 0;
  for (LocalIndex i = 0; i < scene.owned(); ++i) {
    const auto k = static_cast<std::size_t>(components.of[i]);
    if (!boundary.loose().empty() && boundary.loose()[i])
      known[k] = 1;
    else
      for (int c = 0; c < d; ++c)
        if (boundary.prescribed()[static_cast<std::size_t>(i) * d + c]) touched[k] = 1;
  }
  body.communicator.max(touched);
  body.communicator.max(known);
  for (const loads::FreePiece& piece : find_pushed(scene, boundary, components, touched, loads)) {
    const auto k = static_cast<std::size_t>(piece.component);
    found.sentences.push_back(fmt::format(
        "a piece of {} particles, the first of them {}, is held in part only: it can {}, and its loads push it that "
        "way; it counts as loose and is held where it is",
        components.particles[k], components.first[k], piece.motions.front()));
    pushed[k] = 1;
    ++pushed_pieces;
  }
  std::vector<char> lost(count, 0);
  for (std::size_t k = 0; k < count; ++k) lost[k] = touched[k] > 0 || known[k] > 0 ? 0 : 1;
  if (name_pieces(components, lost, found) + pushed_pieces == 0) return found;
  for (LocalIndex i = 0; i < scene.owned(); ++i) {
    const auto k = static_cast<std::size_t>(components.of[i]);
    found.loose[i] = pushed[k] != 0 || lost[k] != 0 ? 1 : 0;
  }
  return found;
}

}  // namespace perinox::fracture
