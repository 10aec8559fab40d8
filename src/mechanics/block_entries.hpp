#pragma once

namespace perinox::mechanics {

/// One diagonal block from what the sweep leaves: entries are xx yy zz xy xz yz (2-D: xx yy xy), then the gradient of
/// the dilatation sum, then (if results says so) that of the flow sum. An owned particle's own rank-one terms come from
/// these: volume * coefficient * g g. block: [d * d], row-major.
inline void finish_block(int d, bool owned, const double* entries, int results, double volume, double dilatation,
                         double flow, double* block) {
  const int symmetric = d * (d + 1) / 2;
  int off = d;
  for (int c = 0; c < d; ++c) {
    block[c * d + c] = entries[c];
    for (int e = c + 1; e < d; ++e, ++off) block[c * d + e] = block[e * d + c] = entries[off];
  }
  if (!owned) return;
  const double* g = entries + symmetric;
  const double* q = results > symmetric + d ? g + d : nullptr;
  for (int c = 0; c < d; ++c)
    for (int e = 0; e < d; ++e) block[c * d + e] += volume * (dilatation * g[c] * g[e] + (q ? flow * q[c] * q[e] : 0));
}

}  // namespace perinox::mechanics
