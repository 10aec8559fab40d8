#pragma once
#include <cmath>

#include "perinox/mechanics/scene.hpp"

namespace perinox::mechanics {

/// Extension e = |Y| - xi (7), direction M = Y/|Y| (5) and length |Y| of every bond of particle i.
/// Small strain: e = X.U/xi, and direction and length as they were. displacement: [local * d], ghosts up to date.
/// extension, stretched: [family]; direction: [family * d].
template <int d>
void family_kinematics(const Scene& scene, LocalIndex i, const double* displacement, double* extension,
                       double* direction, double* stretched) {
  const bonds::Bonds& bonds = scene.bonds();
  const double* reference = scene.body().reference.data();
  const auto first = static_cast<std::size_t>(bonds.offset[i]);
  const int count = bonds.family_size(i);
  const double* xi = reference + static_cast<std::size_t>(i) * d;
  const double* ui = displacement + static_cast<std::size_t>(i) * d;
  for (int j = 0; j < count; ++j) {
    const auto k = static_cast<std::size_t>(bonds.neighbor[first + j]) * d;
    double bond[d], relative[d];
    double square = 0, change = 0;
    for (int c = 0; c < d; ++c) {
      bond[c] = reference[k + c] - xi[c];
      relative[c] = displacement[k + c] - ui[c];
    }
    if (scene.small_strain()) {
      stretched[j] = bonds.length[first + j];
      extension[j] = 0;
      for (int c = 0; c < d; ++c) {
        direction[j * d + c] = bond[c] / stretched[j];
        extension[j] += direction[j * d + c] * relative[c];
      }
      continue;
    }
    // e = |Y| - xi = (|Y|^2 - xi^2)/(|Y| + xi) with |Y|^2 - xi^2 = (2 X + U).U: no cancellation at small strain.
    for (int c = 0; c < d; ++c) {
      const double y = bond[c] + relative[c];
      square += y * y;
      change += (bond[c] + y) * relative[c];
    }
    const double length = std::sqrt(square);
    extension[j] = change / (length + bonds.length[first + j]);
    for (int c = 0; c < d; ++c) direction[j * d + c] = (bond[c] + relative[c]) / length;
    stretched[j] = length;
  }
}

}  // namespace perinox::mechanics
