#pragma once
/// The fourth moment of a family's bonds, which tells what the family can say about the strain.
#include <array>

namespace perinox::bonds {

/// A symmetric tensor in Mandel's notation: xx yy zz, then sqrt 2 times yz xz xy. In 2-D it is xx yy, then sqrt 2 times
/// xy, and the rest is not used. The scalar product of two tensors is that of their vectors.
using Mandel = std::array<double, 6>;
/// Number of components that are used: 6 in 3-D, 3 in 2-D.
constexpr int mandel_size(int dimension) { return dimension * (dimension + 1) / 2; }
/// The tensor scale N, where N = n (x) n of a vector n [dimension].
Mandel mandel(int dimension, const double* n, double scale);

/// The fourth moment M = sum w xi^2 N N^T over a family, with w = omega weight and N of the bonds' reference directions
/// (docs/theory.md, section 8). The strain eps = M^-1 sum w xi N e is exact for uniform strain whatever the family
/// looks like. M = m/(d(d+2)) (I I^T + 2 Id) wherever the plain formulas are exact.
struct Moment {
  int dimension = 3;
  std::array<double, 36> inverse{};  ///< M^-1, row-major, mandel_size squared, 1/(length^2 volume)
  Mandel second{};                   ///< M I = sum w xi^2 N, length^2 volume

  double weighted_volume() const;  ///< m, the trace of `second`
};

/// What broken bonds leave in the sums of a family that can flow. A broken bond keeps the extension e that it would
/// have without stress, which is its plastic extension when it broke.
struct BrokenExtension {
  Mandel fit{};       ///< sum omega xi N e weight; its trace is sum omega xi e weight
  double square = 0;  ///< sum omega e^2 weight
  Mandel second{};    ///< sum omega xi^2 N weight
};
/// The same sums of e - e_p. They are zero when a bond breaks; from then on the bond flows with the others.
struct BrokenElastic {
  Mandel fit{};
  double square = 0;
};

/// The m_s that takes the place of m in alpha with `quadrature: surface-energy` (docs/theory.md, section 8). It makes
/// the energy alpha/2 sum w (e - theta xi/d)^2 of a uniform strain right on average over all deviatoric strains of one
/// size. sums: M, row-major. Length^2 volume. It is m where M I is isotropic, and never less than a tenth of m.
double deviatoric_volume(int dimension, const std::array<double, 36>& sums);

/// The kinds of families, by their fourth moment.
enum class FamilyKind {
  isotropic,  ///< M differs from the isotropic one by at most 1e-10 m and rounding: there is nothing to correct
  irregular,  ///< the strain is to be fitted
  deficient   ///< the family does not tell all strains apart: a plate one particle thick, or a few bonds
};
/// Tells the kind of a family. sums: M over the family, row-major. rounding: relative rounding of the bonds'
/// directions. Fills `moment` for an irregular family only.
FamilyKind make_moment(int dimension, const std::array<double, 36>& sums, double rounding, Moment& moment);

}  // namespace perinox::bonds
