#include "perinox/stepping/plastic_stretch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "perinox/mechanics/each_bond.hpp"

namespace perinox::stepping {

namespace {

bool flows(const materials::Material& material) { return material.history().per_bond > 0; }

/// Of the bonds of materials that flow; counted: [local] or empty, ends that count.
BondStretch largest_stretch(const mechanics::Scene& scene, const std::vector<double>& displacement,
                            const std::vector<char>& counted) {
  const body::Body& body = scene.body();
  const int d = scene.dimension();
  double most = 0;
  std::array<LocalIndex, 2> ends{};
  mechanics::each_bond(scene, [&](LocalIndex i, LocalIndex j) {
    if (!flows(scene.material(i)) && !flows(scene.material(j))) return;
    if (!counted.empty() && !(counted[i] && counted[j])) return;
    double before = 0, after = 0;
    for (int c = 0; c < d; ++c) {
      const double xi = body.position(j)[c] - body.position(i)[c];
      const double y =
          xi + displacement[static_cast<std::size_t>(j) * d + c] - displacement[static_cast<std::size_t>(i) * d + c];
      before += xi * xi;
      after += y * y;
    }
    const double stretch = std::abs(std::sqrt(after / before) - 1);
    if (stretch <= most) return;
    most = stretch;
    ends = {i, j};
  });
  BondStretch found;
  found.stretch = most;
  if (most > 0)
    for (std::size_t c = 0; c < 3; ++c)
      found.place[c] = 0.5 * (body.position3(ends[0])[c] + body.position3(ends[1])[c]);
  if (body.communicator.size() == 1) return found;
  const std::vector<double> mine{most, found.place[0], found.place[1], found.place[2]};
  const std::vector<double> all = body.communicator.gather(mine);
  for (std::size_t r = 0; r < all.size(); r += 4)
    if (r == 0 || all[r] > found.stretch) {
      found.stretch = all[r];
      found.place = {all[r + 1], all[r + 2], all[r + 3]};
    }
  return found;
}

/// Middle of a set in the undeformed body and its mean displacement, by volume; a component that is not prescribed on
/// all of the set is not known.
struct SetMotion {
  deck::Point middle{}, displacement{};
  std::array<bool, 3> known{};
};

SetMotion motion_of(const mechanics::Scene& scene, const loads::Boundary& boundary, const std::vector<LocalIndex>& set,
                    const std::vector<double>& displacement) {
  const auto d = static_cast<std::size_t>(scene.dimension());
  std::vector<double> sums(10, 0.0);  // volume, middle, displacement, unknowns that are free
  for (const LocalIndex i : set) {
    const double volume = scene.body().volume[i];
    sums[0] += volume;
    for (std::size_t c = 0; c < d; ++c) {
      const std::size_t u = static_cast<std::size_t>(i) * d + c;
      sums[1 + c] += volume * scene.body().position(i)[c];
      sums[4 + c] += volume * displacement[u];
      sums[7 + c] += boundary.prescribed()[u] ? 0 : 1;
    }
  }
  scene.body().communicator.sum(sums);
  SetMotion motion;
  for (std::size_t c = 0; c < d; ++c) {
    motion.middle[c] = sums[1 + c] / sums[0];
    motion.displacement[c] = sums[4 + c] / sums[0];
    motion.known[c] = sums[7 + c] == 0;
  }
  return motion;
}

/// Of the line between two middles; where one of them is not known to move the line keeps its length across.
double stretch_between(const SetMotion& a, const SetMotion& b, double least_length) {
  double before = 0, after = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    const double between = b.middle[c] - a.middle[c];
    const double moved = a.known[c] && b.known[c] ? b.displacement[c] - a.displacement[c] : 0;
    before += between * between;
    after += (between + moved) * (between + moved);
  }
  return before < least_length * least_length ? 0 : std::abs(std::sqrt(after / before) - 1);
}

/// Ends of bonds whose displacement is prescribed in all components. [local]
std::vector<char> held_particles(const mechanics::Scene& scene, const loads::Boundary& boundary) {
  const auto d = static_cast<std::size_t>(scene.dimension());
  std::vector<char> held(static_cast<std::size_t>(scene.local()), 1);
  for (std::size_t u = 0; u < held.size() * d; ++u)
    if (!boundary.prescribed()[u]) held[u / d] = 0;
  return held;
}

}  // namespace

bool flows_finitely(const mechanics::Scene& scene) {
  return !scene.small_strain() && std::any_of(scene.materials().begin(), scene.materials().end(),
                                              [](const auto& material) { return flows(*material); });
}

BondStretch largest_plastic_stretch(const mechanics::Scene& scene, const std::vector<double>& displacement) {
  return largest_stretch(scene, displacement, {});
}

BondStretch largest_prescribed_stretch(const deck::Deck& deck, const mechanics::Scene& scene,
                                       const loads::Boundary& boundary) {
  constexpr int most_looks = 100;
  const auto& materials = scene.materials();
  const bool all_flow = std::all_of(materials.begin(), materials.end(), [](const auto& m) { return flows(*m); });
  std::vector<std::string> sets;
  for (const deck::Load& load : deck.boundary)
    if (load.kind == deck::LoadKind::displacement && std::find(sets.begin(), sets.end(), load.set) == sets.end())
      sets.push_back(load.set);
  if (!all_flow || (deck.body.size() > 1 && !deck.bond_bodies)) sets.clear();
  const std::vector<char> held = held_particles(scene, boundary);
  const int looks = std::min(most_looks, std::max(1, deck.steps.count));
  BondStretch largest;
  std::vector<double> displacement(scene.local_unknowns(), 0.0);
  for (int k = 1; k <= looks; ++k) {
    const double t = deck.steps.end * k / looks;
    boundary.impose(t, displacement.data());
    scene.body().halo.update_ghosts(displacement.data(), scene.dimension());
    BondStretch found = largest_stretch(scene, displacement, held);
    std::vector<SetMotion> motions;
    for (const std::string& set : sets)
      motions.push_back(motion_of(scene, boundary, scene.body().sets.at(set), displacement));
    for (std::size_t a = 0; a < motions.size(); ++a)
      for (std::size_t b = a + 1; b < motions.size(); ++b) {
        const double stretch = stretch_between(motions[a], motions[b], scene.families().horizon);
        if (stretch <= found.stretch) continue;
        found.stretch = stretch;
        for (std::size_t c = 0; c < 3; ++c) found.place[c] = 0.5 * (motions[a].middle[c] + motions[b].middle[c]);
      }
    found.t = t;
    if (found.stretch > largest.stretch) largest = found;
  }
  return largest;
}

std::string consequence_of_stretch() {
  return fmt::format(
      "the true stress of its law is within 5 % of the yield stress up to {:g} % only, because its extensions are per "
      "undeformed length",
      100 * most_plastic_stretch);
}

std::string describe(const BondStretch& stretch) {
  return fmt::format("a bond of a material that flows is stretched by {:.3g} % at ({:g}, {:g}, {:g}): {}",
                     100 * stretch.stretch, stretch.place[0], stretch.place[1], stretch.place[2],
                     consequence_of_stretch());
}

}  // namespace perinox::stepping
