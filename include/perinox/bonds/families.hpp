#pragma once
/// The families of the owned particles: every particle i is bonded to its neighbours j within the horizon. For how the
/// bonds are stored see bonds.hpp, lattice_families.hpp and pair_families.hpp.
#include <cstdint>
#include <functional>
#include <vector>

#include "perinox/body/body.hpp"
#include "perinox/bonds/cell_grid.hpp"
#include "perinox/bonds/moment.hpp"
#include "perinox/deck/deck.hpp"

namespace perinox::bonds {

/// The data of every family that do not depend on how its bonds are stored.
struct Families {
  double horizon = 0;
  deck::Influence influence = deck::Influence::constant;
  std::vector<int> size;                  ///< [owned] bonds of each family
  std::vector<double> weighted_volume;    ///< [owned] m = sum omega xi^2 weight (8), after pre-cracks
  std::vector<double> deviatoric_volume;  ///< [owned] in place of m in the shear stiffness; empty: m
  std::vector<double> damage;             ///< [owned] share of the uncut family's omega xi^2 weight that is gone
  std::vector<double> broken_volume;      ///< [owned] omega xi^2 weight of bonds broken since; empty: none anywhere
  /// [owned] sums over broken bonds; empty: no bond that broke had flowed.
  std::vector<BrokenExtension> broken_extension;
  double continuum_weighted_volume = 0;  ///< m of a full continuous neighbourhood with this influence function
  long long directed = 0;                ///< directed bonds on this rank
  long long cut = 0;                     ///< directed bonds cut by pre-cracks on this rank
  long long across_gaps = 0;             ///< directed bonds not made because they leave the material
  long long broken = 0;                  ///< directed bonds broken since, on this rank
  std::vector<std::int32_t> fit;         ///< [owned] index into moments, -1: plain formulas; empty: nowhere a fit
  std::vector<Moment> moments;           ///< of the owned particles whose strain is fitted
  long long deficient = 0;               ///< owned particles whose strain would be fitted if their families allowed it

  const Moment* moment(LocalIndex i) const {
    return fit.empty() || fit[i] < 0 ? nullptr : &moments[static_cast<std::size_t>(fit[i])];
  }
};

/// One bond of a family in the form in which it is found.
struct FoundBond {
  LocalIndex neighbor = 0;
  double length = 0;     ///< xi
  double weight = 0;     ///< V_j times the quadrature's share of it
  double influence = 0;  ///< omega(xi)
};
/// A function that takes the families one by one. The bonds of each family come in ascending id of the neighbour.
using FamilyReceiver = std::function<void(LocalIndex, const std::vector<FoundBond>&)>;

/// Distance within which the quadrature needs neighbours, a length. It is the horizon, for partial-volume plus half the
/// largest spacing, and a millionth more, so that no neighbour is lost to the rounding of coordinates.
double reach(const deck::Deck& deck, double horizon, double largest_spacing);

/// The influence function omega(xi) for 0 < xi <= horizon, and a little beyond for partial-volume (docs/theory.md,
/// section 8). It is 1 for constant, 1/xi for inverse (1/length, as in LAMMPS), and 1 - 3 (xi/horizon)^2 + 2
/// (xi/horizon)^3 for polynomial, which is zero from the horizon on.
double influence_value(deck::Influence influence, double length, double horizon);
/// Integral of omega xi^2 over a full ball (3-D) or disc (2-D) of radius horizon: m of a continuous neighbourhood.
double continuum_weighted_volume(deck::Influence influence, double horizon, int dimension);
/// Share of a neighbour's volume that counts, 0 to 1 (docs/theory.md, section 8). With s = 1/2 + (horizon - xi)/spacing
/// cut to that range, it is 1 up to the horizon for whole, s up to the horizon for taper-inside, and s up to half a
/// spacing beyond the horizon for partial-volume. A neighbour at exactly the horizon is inside (relative tolerance
/// 1e-10). `spacing` is the mean of both particles' V^(1/d).
double volume_share(deck::Quadrature quadrature, double length, double horizon, double spacing);

/// The factor 1 + c (sum_k n_k^4 - 3/(d+2)) on a bond's influence, n its direction, that makes the fourth moment of a
/// whole lattice family isotropic (docs/theory.md, section 8). The plain formulas are then exact under uniform strain,
/// for any cubic lattice and influence function. The factor is 1 where it would leave a bond without weight, as with
/// short horizons; the fit of the strain then does all the work.
class CubicFactor {
 public:
  CubicFactor() = default;  ///< a factor of 1
  /// Adds one bond of the whole family. bond: its vector in spacings; moment: its omega xi^2 weight.
  void add(int dimension, const double* bond, double moment);
  /// Computes c from the bonds that have been added.
  void finish();
  /// The factor of one bond. bond: [dimension] its vector; only the direction counts.
  double operator()(int dimension, const double* bond) const;

 private:
  static double anisotropy(int dimension, const double* bond);
  double first_ = 0, second_ = 0, least_ = 0, most_ = 0, c_ = 0;
};

/// Finds the family of every owned particle, in the order given ([owned], each once), and hands it to the receiver.
/// Bonds without influence or without a share of volume are left out, and so are those that leave the material
/// (gaps.hpp). Pre-cracks cut by the rule of CrackSurface. A bond that is cut is gone from the families and from m, as
/// at a free surface. grid: the grid of the body, or null. Collective. Throws InputError on all ranks together: for the
/// first particle whose family is empty (with id and position), for a crack that cuts no bond, and for a crack that
/// runs through a particle's centre. Throws std::logic_error if the body was built with a reach below the horizon.
Families find_families(const deck::Deck& deck, const body::Body& body, double horizon, const CellGrid* grid,
                       const std::vector<LocalIndex>& order, const FamilyReceiver& receive);

}  // namespace perinox::bonds
