#pragma once
#include <string>
#include <vector>

#include "perinox/deck/deck.hpp"
#include "perinox/loads/boundary.hpp"
#include "perinox/mechanics/scene.hpp"

namespace perinox::stepping {

/// The largest stretch | |Y|/xi - 1 | of the intact bonds of materials that flow, and where.
struct BondStretch {
  double stretch = 0;
  double t = 0;
  int step = 0;
  deck::Point place{};  ///< middle of the bond in the undeformed body
};

/// Up to here bonds that flow are stretched while the true stress of a perfectly plastic body stays within 5 % of its
/// yield stress, in tension and in shear (docs/theory.md, section 3).
constexpr double most_plastic_stretch = 0.025;

/// True where a stretch can matter: a material flows, and `deformation: finite`. Collective.
bool flows_finitely(const mechanics::Scene& scene);
/// displacement: [local * dimension], ghosts up to date. Collective.
BondStretch largest_plastic_stretch(const mechanics::Scene& scene, const std::vector<double>& displacement);
/// What the prescribed displacements alone say of the stretch that the run will come to: of bonds held at both ends,
/// and of the lines between the middles of two sets of the boundary, where all of the body flows and is bonded. Looked
/// at are at most a hundred of the load steps. Collective.
BondStretch largest_prescribed_stretch(const deck::Deck& deck, const mechanics::Scene& scene,
                                       const loads::Boundary& boundary);
/// "a bond of a material that flows is stretched by ... % at (x, y, z): ..." with what follows from it.
std::string describe(const BondStretch& stretch);
/// What follows from a stretch beyond most_plastic_stretch.
std::string consequence_of_stretch();

}  // namespace perinox::stepping
