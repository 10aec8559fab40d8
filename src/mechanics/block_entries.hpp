#pragma once
#include "kernels/views.hpp"
#include "perinox/mechanics/family_loops.hpp"

namespace perinox::mechanics {

/// What an owned particle's own rank-one terms are made of.
struct OwnTerms {
  double volume = 0, dilatation = 0, flow = 0, mean = 0;
  const std::array<double, 36>* modulus = nullptr;  ///< of a fitted particle
  const bonds::Mandel* slope = nullptr;
};

/// m: index of the particle's moment, or -1.
inline OwnTerms own_terms(const TangentLaw& law, LocalIndex i, int m, double volume) {
  OwnTerms own{volume, law.dilatation[i], law.flow[i], law.mean[i]};
  if (m < 0) return own;
  own.modulus = &law.modulus[static_cast<std::size_t>(m)];
  own.slope = &law.slope[static_cast<std::size_t>(m)];
  return own;
}

/// One diagonal block from what the sweep leaves: entries are xx yy zz xy xz yz (2-D: xx yy xy), then the gradient of
/// the dilatation sum, then (if `flows`) that of the flow sum, and those of the fit where kernels::first_fit_gradient
/// says. own: null for a ghost. block: [d * d], row-major.
inline void finish_block(int d, const double* entries, bool flows, const OwnTerms* own, double* block) {
  const int symmetric = d * (d + 1) / 2;
  int off = d;
  for (int c = 0; c < d; ++c) {
    block[c * d + c] = entries[c];
    for (int e = c + 1; e < d; ++e, ++off) block[c * d + e] = block[e * d + c] = entries[off];
  }
  if (!own) return;
  double flow_gradient[3] = {};
  if (flows)
    for (int c = 0; c < d; ++c) flow_gradient[c] = entries[symmetric + d + c];
  const auto add = [&](double coefficient, const double* a, const double* b) {
    for (int c = 0; c < d; ++c)
      for (int e = 0; e < d; ++e) block[c * d + e] += own->volume * coefficient * a[c] * b[e];
  };
  if (own->modulus) {
    const double* gradient = entries + kernels::first_fit_gradient;
    for (int k = 0; k < symmetric; ++k) {
      for (int l = 0; l < symmetric; ++l) add((*own->modulus)[k * symmetric + l], gradient + k * d, gradient + l * d);
      const double slope = (*own->slope)[k] + (k < d ? own->mean : 0);
      for (int c = 0; c < d; ++c) flow_gradient[c] += slope * gradient[k * d + c];
    }
  } else {
    add(own->dilatation, entries + symmetric, entries + symmetric);
  }
  if (flows) add(own->flow, flow_gradient, flow_gradient);
}

}  // namespace perinox::mechanics
