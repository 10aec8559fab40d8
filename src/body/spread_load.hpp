#pragma once
#include <functional>

#include "facets.hpp"
#include "perinox/body/exposed_faces.hpp"
#include "perinox/body/neighbor_search.hpp"

namespace perinox::body {

/// Gives the load on a facet of a body's surface to particles of that body around particle i. The virtual work of
/// pressures and tractions is exact for linear displacements where there are enough particles. middle: middle of the
/// facet's cell; weight: factor on the facet; spacing: that of the body; facing: direction from which the area for
/// tractions is seen; carries: false if a gap or a crack is between the facet's middle and a particle. The shares
/// include those of particles of other ranks.
void spread_load(const Facet& facet, const deck::Point& middle, double weight, const Body& body, LocalIndex i,
                 double spacing, const std::optional<deck::Point>& facing, const NeighborSearch& search,
                 const std::function<bool(const deck::Point& from, LocalIndex j)>& carries,
                 std::vector<FaceShare>& shares);
/// Distance in spacings around a particle over which its surface's load is spread.
constexpr double farthest_carrier = 3.1;

/// Hands shares of ghosts to the ranks that own them. They are few: only those of surfaces that pass from rank to rank.
/// Collective.
void hand_over(const Body& body, std::vector<FaceShare>& shares);

}  // namespace perinox::body
