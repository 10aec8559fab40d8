#pragma once
/// What a family can tell of the strain: the fourth moment of its bonds.
#include <array>

namespace perinox::bonds {

/// A symmetric tensor in Mandel's notation: xx yy zz, then sqrt 2 times yz xz xy; 2-D: xx yy, sqrt 2 times xy, and the
/// rest not used. Products of tensors are products of these.
using Mandel = std::array<double, 6>;
constexpr int mandel_size(int dimension) { return dimension * (dimension + 1) / 2; }
/// scale N, N = n (x) n of a vector n [dimension].
Mandel mandel(int dimension, const double* n, double scale);

/// M = sum w xi^2 N N^T over a family, w = omega weight, N of the bonds' reference directions. The strain eps = M^-1
/// sum w xi N e is exact for uniform strain whatever the family looks like, and M = m/(d(d+2)) (I I^T + 2 Id) wherever
/// the plain formulas are.
struct Moment {
  int dimension = 3;
  std::array<double, 36> inverse{};  ///< M^-1, row-major, mandel_size squared, 1/(length^2 volume)
  Mandel second{};                   ///< M I = sum w xi^2 N, length^2 volume

  double weighted_volume() const;  ///< m, the trace of `second`
};

/// What broken bonds leave in the sums of a family that can flow: a broken bond keeps the extension e that it would
/// have without stress, its plastic extension when it broke.
struct BrokenExtension {
  Mandel fit{};       ///< sum omega xi N e weight; its trace is sum omega xi e weight
  double square = 0;  ///< sum omega e^2 weight
  Mandel second{};    ///< sum omega xi^2 N weight
};
/// The same of e - e_p: zero when a bond breaks; from then on it flows with the others.
struct BrokenElastic {
  Mandel fit{};
  double square = 0;
};

/// In place of m in alpha: makes the energy alpha/2 sum w (e - theta xi/d)^2 of a uniform strain right on average over
/// all deviatoric strains of one size. sums: M as below. Length^2 volume; m where M I is isotropic; never less than a
/// tenth of m.
double deviatoric_volume(int dimension, const std::array<double, 36>& sums);

/// What a family is like.
enum class FamilyKind {
  isotropic,  ///< M differs from the isotropic one by at most 1e-10 m and what rounding makes: nothing to correct
  irregular,  ///< the strain is to be fitted
  deficient   ///< does not tell all strains apart: a plate one particle thick, a few bonds
};
/// M of sums over one family, row-major. rounding: of the bonds' directions. Fills `moment` of an irregular family
/// only.
FamilyKind make_moment(int dimension, const std::array<double, 36>& sums, double rounding, Moment& moment);

}  // namespace perinox::bonds
