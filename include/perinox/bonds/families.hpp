#pragma once
/// The families of the owned particles: every particle i is bonded to its neighbours j within the horizon. How the
/// bonds are stored is another matter: see bonds.hpp, lattice_families.hpp, pair_families.hpp.
#include <cstdint>
#include <functional>
#include <vector>

#include "perinox/body/body.hpp"
#include "perinox/bonds/cell_grid.hpp"
#include "perinox/bonds/moment.hpp"
#include "perinox/deck/deck.hpp"

namespace perinox::bonds {

/// What is known of every family, however its bonds are stored.
struct Families {
  double horizon = 0;
  deck::Influence influence = deck::Influence::constant;
  std::vector<int> size;                  ///< [owned] bonds of each family
  std::vector<double> weighted_volume;    ///< [owned] m = sum omega xi^2 weight (8), after pre-cracks
  std::vector<double> deviatoric_volume;  ///< [owned] in place of m in the shear stiffness; empty: m
  std::vector<double> damage;             ///< [owned] share of the uncut family's omega xi^2 weight that is gone
  std::vector<double> broken_volume;      ///< [owned] omega xi^2 weight of bonds broken since; empty: none anywhere
  std::vector<BrokenExtension> broken_extension;  ///< [owned]; empty: no bond that broke had flowed
  double continuum_weighted_volume = 0;           ///< m of a full continuous neighbourhood with this influence function
  long long directed = 0;                         ///< directed bonds on this rank
  long long cut = 0;                              ///< directed bonds cut by pre-cracks on this rank
  long long across_gaps = 0;                      ///< directed bonds not made because they leave the material
  long long broken = 0;                           ///< directed bonds broken since, on this rank
  std::vector<std::int32_t> fit;  ///< [owned] index into moments, -1: plain formulas; empty: nowhere a fit
  std::vector<Moment> moments;    ///< of the owned particles whose strain is fitted
  long long deficient = 0;        ///< owned particles whose strain would be fitted if their families allowed it

  const Moment* moment(LocalIndex i) const {
    return fit.empty() || fit[i] < 0 ? nullptr : &moments[static_cast<std::size_t>(fit[i])];
  }
};

/// One bond of a family as it is found.
struct FoundBond {
  LocalIndex neighbor = 0;
  double length = 0;     ///< xi
  double weight = 0;     ///< V_j times the quadrature's share of it
  double influence = 0;  ///< omega(xi)
};
/// Takes the families one by one; the bonds of each in ascending id of the neighbour.
using FamilyReceiver = std::function<void(LocalIndex, const std::vector<FoundBond>&)>;

/// Distance within which the quadrature needs neighbours: the horizon, plus half the largest spacing for
/// partial-volume, and a millionth more, so that no neighbour is lost to the rounding of coordinates.
double reach(const deck::Deck& deck, double horizon, double largest_spacing);

/// omega(xi) for 0 < xi <= horizon (and a little beyond for partial-volume): constant 1; inverse 1/xi (per length, as
/// LAMMPS has it); polynomial 1 - 3 (xi/horizon)^2 + 2 (xi/horizon)^3, zero from the horizon on.
double influence_value(deck::Influence influence, double length, double horizon);
/// Integral of omega xi^2 over a full ball (3-D) or disc (2-D) of radius horizon.
double continuum_weighted_volume(deck::Influence influence, double horizon, int dimension);
/// Share of a neighbour's volume, 0 to 1, with s = 1/2 + (horizon - xi)/spacing cut to that range: whole 1 up to the
/// horizon; taper-inside s up to the horizon; partial-volume s, up to half a spacing beyond the horizon. A neighbour at
/// exactly the horizon is in (relative tolerance 1e-10). spacing is the mean of both particles' V^(1/d).
double volume_share(deck::Quadrature quadrature, double length, double horizon, double spacing);

/// Factor 1 + c (sum_k n_k^4 - 3/(d+2)) of a bond's influence that makes the fourth moment of a whole lattice family
/// isotropic, and with it the plain formulas exact under uniform strain. Holds for any cubic lattice and influence; 1
/// where it would leave a bond without weight (short horizons): then the fit of the strain has to do it all.
class CubicFactor {
 public:
  CubicFactor() = default;  ///< 1
  /// Adds a bond of the whole family: vector in spacings, moment omega xi^2 weight.
  void add(int dimension, const double* bond, double moment);
  void finish();
  double operator()(int dimension, const double* bond) const;

 private:
  static double anisotropy(int dimension, const double* bond);
  double first_ = 0, second_ = 0, least_ = 0, most_ = 0, c_ = 0;
};

/// Finds the family of every owned particle, in the order given ([owned], each once), and hands it to the receiver.
/// Bonds without influence or without a share of volume are left out, and those that leave the material (gaps.hpp).
/// Cracks cut by the rule of CrackSurface; what they cut is gone from the families and from m, as at a free surface.
/// grid: of the body, or null. Collective. Throws InputError on all ranks together: naming the first particle (id,
/// position) whose family is empty; at a crack that cuts no bond, and at one that runs through a particle's centre.
/// Throws std::logic_error if the body was built with a reach below the horizon.
Families find_families(const deck::Deck& deck, const body::Body& body, double horizon, const CellGrid* grid,
                       const std::vector<LocalIndex>& order, const FamilyReceiver& receive);

}  // namespace perinox::bonds
