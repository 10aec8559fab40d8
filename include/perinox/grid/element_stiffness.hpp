#pragma once
#include <array>
#include <cmath>

namespace perinox::grid {

/// Moments of the moduli over the particles of one cell: the integrals of kappa s_x^i s_y^j s_z^k, and of mu times the
/// same monomial, for i, j, k <= 2. The coordinates s run from 0 to 1 over the cell on each axis. Each particle stands
/// for a cube of its volume around it.
template <int d>
class CellMoments {
 public:
  static constexpr int powers = d == 3 ? 27 : 9;
  typedef double Pair __attribute__((vector_size(16)));  ///< one moment of kappa and of mu, in one register

  void clear() { sums_.fill(Pair{0, 0}); }
  /// Adds one particle. s: its place; edge: the edge of its cube; both over the cell's size on each axis. bulk and
  /// shear are its moduli times its volume.
  void add(const std::array<double, d>& s, const std::array<double, d>& edge, double bulk, double shear) {
    std::array<std::array<double, 3>, 3> power{{{1, 0, 0}, {1, 0, 0}, {1, 0, 0}}};
    for (int a = 0; a < d; ++a) power[a] = {1, s[a], s[a] * s[a] + edge[a] * edge[a] / 12};
    const Pair moduli{bulk, shear};
    std::size_t at = 0;
    for (int z = 0; z < (d == 3 ? 3 : 1); ++z)
      for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 3; ++x, ++at) {
          sums_[at] += moduli * (power[0][x] * power[1][y] * power[2][z]);
        }
  }
  const std::array<Pair, powers>& sums() const { return sums_; }

 private:
  std::array<Pair, powers> sums_{};
};

/// The stiffness matrix of a d-linear element whose moduli have given moments,
///     int kappa div u div v + 2 mu dev e(u) : dev e(v).
/// The product of two slopes is contracted with the moments axis by axis, so that all entries that share the first axes
/// share that work.
template <int d>
class ElementStiffness {
 public:
  static constexpr int corners = 1 << d;
  /// [A][B][p][q]: the entry between corner A along axis p and corner B along axis q.
  using Blocks = std::array<std::array<std::array<std::array<double, d>, d>, corners>, corners>;

  /// size: edges of the cell, length.
  explicit ElementStiffness(const std::array<double, 3>& size) {
    for (int a = 0; a < d; ++a)
      for (int slopes = 0; slopes < 4; ++slopes)
        for (int highs = 0; highs < 4; ++highs) {
          const auto [a0, a1] = function(slopes & 1, highs & 1, size[a]);
          const auto [b0, b1] = function(slopes >> 1, highs >> 1, size[a]);
          factor_[a][slopes][highs] = {a0 * b0, a0 * b1 + a1 * b0, a1 * b1};
        }
  }

  void blocks(const CellMoments<d>& moments, Blocks& out) {
    contract<0>(moments.sums().data(), 0, d, d);
    for (int A = 0; A < corners; ++A)
      for (int B = 0; B < corners; ++B) {
        const auto& slopes = slopes_[A][B];  // [p][q]: d_p phi_A d_q phi_B
        double dot = 0;
        for (int c = 0; c < d; ++c) dot += slopes[c][c][1];
        for (int p = 0; p < d; ++p)
          for (int q = 0; q < d; ++q)  // 2 e(u) : e(v) = grad phi_A . grad phi_B if p = q, and d_q phi_A d_p phi_B
            out[A][B][p][q] = slopes[p][q][0] + (p == q ? dot : 0) + slopes[q][p][1] - 2.0 / d * slopes[p][q][1];
      }
  }

 private:
  using Pair = typename CellMoments<d>::Pair;

  /// Coefficients of 1 and s of a linear function on 0..1, or of its slope. high: the function is 1 at s = 1.
  static std::array<double, 2> function(int slope, int high, double size) {
    if (slope) return {high ? 1 / size : -1 / size, 0};
    return high ? std::array<double, 2>{0, 1} : std::array<double, 2>{1, -1};
  }

  /// moments: what is left of the moments for the axes from `axis` on. p, q: the earlier axis along which the slope of
  /// A, or of B, was taken, and d while there is none. corner_bits: two bits (A and B) for each earlier axis.
  template <int axis>
  void contract(const Pair* moments, int corner_bits, int p, int q) {
    if constexpr (axis == d) {
      int A = 0, B = 0;
      for (int a = 0; a < d; ++a) {
        A |= (corner_bits >> (2 * a) & 1) << a;
        B |= (corner_bits >> (2 * a + 1) & 1) << a;
      }
      slopes_[A][B][p][q] = *moments;
    } else {
      constexpr int left = axis + 1 == d ? 1 : axis + 2 == d ? 3 : 9;
      for (int slopes = 0; slopes < 4; ++slopes) {
        const int slope_a = slopes & 1, slope_b = slopes >> 1;
        if ((slope_a && p != d) || (slope_b && q != d)) continue;
        if (axis == d - 1 && ((!slope_a && p == d) || (!slope_b && q == d))) continue;
        for (int highs = 0; highs < 4; ++highs) {
          const std::array<double, 3>& f = factor_[axis][slopes][highs];
          Pair next[left];
          for (int k = 0; k < left; ++k)
            next[k] = f[0] * moments[3 * k] + f[1] * moments[3 * k + 1] + f[2] * moments[3 * k + 2];
          contract<axis + 1>(next, corner_bits | highs << (2 * axis), slope_a ? axis : p, slope_b ? axis : q);
        }
      }
    }
  }

  std::array<std::array<std::array<std::array<double, 3>, 4>, 4>, d> factor_;
  std::array<std::array<std::array<std::array<Pair, d>, d>, corners>, corners> slopes_;
};

}  // namespace perinox::grid
