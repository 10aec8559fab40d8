#pragma once
/// The families of the owned particles: every particle i is bonded to its neighbours j within the horizon.
#include <cstdint>
#include <vector>

#include "perinox/body/body.hpp"
#include "perinox/deck/deck.hpp"

namespace perinox::bonds {

struct Bonds {
  double horizon = 0;
  std::vector<std::int64_t> offset;      ///< [owned + 1] first bond of each family
  std::vector<LocalIndex> neighbor;      ///< [bonds] local index of j; ascending id of j within a family
  std::vector<double> length;            ///< [bonds] reference length xi
  std::vector<double> weight;            ///< [bonds] V_j times the quadrature's share of it
  std::vector<double> influence;         ///< [bonds] omega(xi)
  std::vector<double> weighted_volume;   ///< [owned] m = sum omega xi^2 weight (8), after pre-cracks
  std::vector<double> damage;            ///< [owned] share of the uncut family's omega xi^2 weight that pre-cracks cut
  double continuum_weighted_volume = 0;  ///< m of a full continuous neighbourhood with this influence function
  long long cut = 0;                     ///< directed bonds cut by pre-cracks on this rank

  std::int64_t count() const { return offset.empty() ? 0 : offset.back(); }
  int family_size(LocalIndex i) const { return static_cast<int>(offset[i + 1] - offset[i]); }
};

/// Distance within which the quadrature needs neighbours: the horizon, plus half the largest spacing for
/// partial-volume.
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

/// Bonds without influence or without a share of volume are left out. Cracks cut by the rule of CrackSurface; what they
/// cut is gone from the families and from m, as at a free surface. Collective. Throws InputError on all ranks together:
/// naming the first particle (id, position) whose family is empty; at a crack that cuts no bond. Throws
/// std::logic_error if the body was built with a reach below the horizon.
Bonds build(const deck::Deck& deck, const body::Body& body, double horizon);

}  // namespace perinox::bonds
