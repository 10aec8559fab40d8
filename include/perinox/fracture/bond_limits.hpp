#pragma once
#include <string>
#include <vector>

#include "perinox/mechanics/scene.hpp"

namespace perinox::fracture {

/// What the bonds of a body stand. A bond between two bodies is as strong as its weaker end.
struct BondLimit {
  enum class Kind {
    none,     ///< never breaks
    stretch,  ///< e/xi
    energy,   ///< what its break releases, energy a volume squared
    ductile   ///< equivalent plastic strain over the failure strain, the mean of both ends
  };
  Kind kind = Kind::none;
  double limit = 0;  ///< of the stretch, of the energy; 1 for ductile
  deck::DuctileFailure ductile{};
  double toughness = 1;  ///< energy: what a crack takes over what its bonds hold; 1 if w was given
};

/// Lattice sums (of a cloud: the integrals) of what a plane crack crosses, the mean over all its directions.
struct CrossedBonds {
  double count = 0;   ///< sum of V_i V_j over the bonds that cross, an area
  double square = 0;  ///< sum of V_i V_j omega xi^2 over them, an area
  double weighted_volume = 0;
};
/// spacing: 0 for the integrals.
CrossedBonds crossed_bonds(const deck::Deck& deck, double horizon, double spacing);

/// One limit a body of the deck, from its material, its own lattice and nothing else. An energy release rate G_c
/// becomes the bond energy G_c/(count toughness), so that the bonds across a crack take G_c an area together, the
/// toughness being what a lattice adds of its own (measured, 1 for clouds), or the stretch at which they hold that much
/// when the material is stretched alike in all directions, s^2 = G_c m/(d^2 kappa square). Throws InputError at the
/// damage law: a law that the material does not have what it takes for.
std::vector<BondLimit> bond_limits(const deck::Deck& deck, const mechanics::Scene& scene);

/// One line a material that can break, or one a body where they differ: "steel: bonds break at a stretch of 0.002",
/// "steel in plate: ...".
std::vector<std::string> describe(const std::vector<BondLimit>& limits, const deck::Deck& deck);

}  // namespace perinox::fracture
