#pragma once
#include <functional>

#include "facets.hpp"
#include "perinox/body/exposed_faces.hpp"
#include "perinox/body/neighbor_search.hpp"

namespace perinox::body {

/// Gives the load on a facet of a body's surface to particles of that body around particle i, so that the virtual work
/// of pressures and tractions is exact for linear displacements where there are enough particles. middle: of the
/// facet's cell; weight: of the facet; spacing: of the body; facing: what tractions act on is seen from there; carries:
/// false where a gap or a crack is between the facet's middle and a particle. Shares of particles of other ranks are
/// among them.
void spread_load(const Facet& facet, const deck::Point& middle, double weight, const Body& body, LocalIndex i,
                 double spacing, const std::optional<deck::Point>& facing, const NeighborSearch& search,
                 const std::function<bool(const deck::Point& from, LocalIndex j)>& carries,
                 std::vector<FaceShare>& shares);
/// Of the spacing: how far around a particle its surface's load is spread.
constexpr double farthest_carrier = 3.1;

/// Hands shares of ghosts to whoever owns them. Few: only those of surfaces that pass from rank to rank. Collective.
void hand_over(const Body& body, std::vector<FaceShare>& shares);

}  // namespace perinox::body
