#pragma once
#include "perinox/core/record.hpp"
#include "perinox/fracture/bond_breaking.hpp"
#include "perinox/fracture/loose_pieces.hpp"
#include "perinox/loads/boundary.hpp"

namespace perinox::fracture {

/// What letting loose pieces go has changed, the same on all ranks.
struct LetGo {
  bool bonds = false;      ///< bonds have broken that were the last of particles they could not hold
  bool particles = false;  ///< particles have been taken out of the unknowns
};

/// Finds what no support holds any more (find_loose), counts the bonds that broke on the way, tells the observer and
/// takes the particles out of the unknowns. plastic: of the present state. motion: told of the bonds before the
/// particles go, and of the supports afterwards; null in equilibrium. Collective.
LetGo let_loose_go(mechanics::Scene& scene, loads::Boundary& boundary, BondBreaking& breaking,
                   const mechanics::PlasticExtension& plastic, const PiecesLoads& loads, Observer& observer,
                   MovingState* motion = nullptr);

}  // namespace perinox::fracture
