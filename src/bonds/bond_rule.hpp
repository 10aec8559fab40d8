#pragma once
#include <vector>

#include "perinox/body/body.hpp"
#include "perinox/bonds/families.hpp"

namespace perinox::bonds {

/// The rule that says which particles may be bonded and what each bond weighs. Both follow from the two particles and
/// their bodies' entries in the deck. Neither other bodies nor the particles that one rank happens to hold have a part
/// in them.
class BondRule {
 public:
  /// Keeps all arguments by reference.
  BondRule(const deck::Deck& deck, const body::Body& body, double horizon);

  /// True if the deck allows a bond between particles i and j, whatever their distance.
  bool may_bond(LocalIndex i, LocalIndex j) const {
    return i != j && (deck_.bond_bodies || body_.part[i] == body_.part[j]);
  }
  /// Works out what bond() needs of each particle. It must be called before bond().
  void prepare();
  /// The bond from i to j by their coordinates. A neighbour that is at the horizon up to the rounding of the
  /// coordinates counts as at the horizon.
  FoundBond bond(LocalIndex i, LocalIndex j) const;
  /// The bond of two particles of one lattice that are `step` cells apart. `of` is any particle of that lattice. The
  /// weight of the result is the quadrature's share alone, without the volume.
  FoundBond lattice_bond(LocalIndex of, const std::array<int, 3>& step) const;

 private:
  void make_factors();
  double factor(int part, int other, const double* between) const;

  const deck::Deck& deck_;
  const body::Body& body_;
  double horizon_;
  /// [owned + ghosts] length; of the particle's spacing and of its coordinates.
  std::vector<double> spacing_, rounding_;
  std::vector<CubicFactor> factor_;  ///< one factor for each different lattice spacing; the first is that of clouds, 1
  std::vector<int> factor_of_;       ///< [bodies of the deck] index into factor_
};

/// A bond's contribution to the weighted volume m. A bond without one carries nothing and is left out.
inline double moment(const FoundBond& bond) { return bond.influence * bond.length * bond.length * bond.weight; }

}  // namespace perinox::bonds
