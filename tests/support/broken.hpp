#pragma once
/// Bonds of a scene, chosen to be broken.
#include <algorithm>
#include <random>
#include <utility>
#include <vector>

#include "perinox/mechanics/scene.hpp"

namespace perinox::test {

/// Every bond of this rank once, the smaller id first, in ascending order of the ids.
inline std::vector<mechanics::BondEnds> all_bonds(const mechanics::Scene& scene) {
  std::vector<mechanics::BondEnds> ends;
  const auto add = [&](LocalIndex i, LocalIndex j) {
    const bool first = scene.body().id[i] < scene.body().id[j];
    ends.push_back(first ? mechanics::BondEnds{i, j} : mechanics::BondEnds{j, i});
  };
  if (scene.lattice())
    scene.lattice()->each([&](LocalIndex i, LocalIndex j, const bonds::StencilOffset&) { add(i, j); });
  else
    scene.pairs()->each([&](LocalIndex i, LocalIndex j, double, double) { add(i, j); });
  const auto ids = [&](const mechanics::BondEnds& bond) {
    return std::pair(scene.body().id[bond[0]], scene.body().id[bond[1]]);
  };
  std::sort(ends.begin(), ends.end(), [&](const auto& a, const auto& b) { return ids(a) < ids(b); });
  return ends;
}

/// A random share of all bonds, the same for one body in any layout. For one rank.
inline std::vector<mechanics::BondEnds> some_bonds(const mechanics::Scene& scene, double share, unsigned seed) {
  std::vector<mechanics::BondEnds> ends = all_bonds(scene);
  std::mt19937 generator(seed);
  std::shuffle(ends.begin(), ends.end(), generator);
  ends.resize(static_cast<std::size_t>(share * static_cast<double>(ends.size())));
  return ends;
}

/// All bonds of one particle.
inline std::vector<mechanics::BondEnds> bonds_of(const mechanics::Scene& scene, LocalIndex i) {
  std::vector<mechanics::BondEnds> ends = all_bonds(scene);
  ends.erase(std::remove_if(ends.begin(), ends.end(), [&](const auto& b) { return b[0] != i && b[1] != i; }),
             ends.end());
  return ends;
}

}  // namespace perinox::test
