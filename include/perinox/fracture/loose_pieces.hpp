#pragma once
#include <string>
#include <vector>

#include "perinox/loads/boundary.hpp"
#include "perinox/mechanics/scene.hpp"

namespace perinox::fracture {

/// What acts on the particles at the moment, [owned * dimension], force.
struct PiecesLoads {
  const std::vector<double>& given;  ///< by the deck's boundary
  const std::vector<double>& all;    ///< contacts included; a piece in contact may be held by that
};

/// What breaking bonds have left without support.
struct LoosePieces {
  std::vector<char> loose;             ///< [owned] particles of pieces that nothing holds against their loads
  long long broken = 0;                ///< bonds over all ranks that were the last of particles they could not hold
  std::vector<std::string> sentences;  ///< for the log
  /// Where in Scene::broken() each round of breaking began on this rank.
  std::vector<std::size_t> rounds;
};

/// Breaks what is left of the families whose bonds do not resist every motion of their particle (one bond, bonds along
/// one line, in 3-D bonds within one plane), then finds the pieces that no bond joins to a prescribed displacement, and
/// those that are held only partly and that the loads push along a motion left free (rigid_modes.hpp): there is no
/// equilibrium for them, and no rest in time. A turn is no such motion where the deformation is finite: it may lead to
/// where the load turns no further. A piece that is held only partly stays where nothing pushes it, and so does one
/// that can only turn, about a hinge: about one particle that all bonds to the rest end at. Collective.
LoosePieces find_loose(mechanics::Scene& scene, const loads::Boundary& boundary,
                       const mechanics::PlasticExtension& plastic, const PiecesLoads& loads);

}  // namespace perinox::fracture
