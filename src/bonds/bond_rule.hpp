#pragma once
#include <vector>

#include "perinox/body/body.hpp"
#include "perinox/bonds/families.hpp"

namespace perinox::bonds {

/// Which particles may be bonded, and what each bond weighs. Follows from the two particles, their bodies' entries in
/// the deck and nothing else: neither from other bodies nor from what one rank happens to hold.
class BondRule {
 public:
  /// All are kept by reference.
  BondRule(const deck::Deck& deck, const body::Body& body, double horizon);

  bool may_bond(LocalIndex i, LocalIndex j) const {
    return i != j && (deck_.bond_bodies || body_.part[i] == body_.part[j]);
  }
  /// To be called before bond(): what it needs of each particle.
  void prepare();
  /// The bond from i to j as their coordinates have it. A neighbour at the horizon up to the rounding of the
  /// coordinates is at the horizon.
  FoundBond bond(LocalIndex i, LocalIndex j) const;
  /// The bond of two particles of one lattice, `step` cells apart: the reference particle is any of that lattice.
  /// weight: the quadrature's share alone.
  FoundBond lattice_bond(LocalIndex of, const std::array<int, 3>& step) const;

 private:
  void make_factors();
  double factor(int part, int other, const double* between) const;

  const deck::Deck& deck_;
  const body::Body& body_;
  double horizon_;
  std::vector<double> spacing_, rounding_;  ///< [owned + ghosts] length; of the particle's neighbours, its coordinates
  std::vector<CubicFactor> factor_;         ///< of each different lattice spacing; the first is of clouds: 1
  std::vector<int> factor_of_;              ///< [bodies of the deck]
};

/// A bond's contribution to the weighted volume; a bond without one carries nothing and is left out.
inline double moment(const FoundBond& bond) { return bond.influence * bond.length * bond.length * bond.weight; }

}  // namespace perinox::bonds
