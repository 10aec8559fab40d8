#pragma once
/// The boundary of a solid within a cell, piece by piece of the surfaces of which it is made.
#include <optional>
#include <vector>

#include "arrangement.hpp"
#include "surface_integrals.hpp"

namespace perinox::body {

struct Facet {
  Surface surface{};
  int side = 1;              ///< -1: the body is on the surface's outside
  SurfaceIntegrals whole{};  ///< integrals over the boundary of the solid
  double untouched = 0;      ///< area of the part that no other solid touches
  SurfaceIntegrals open{};   ///< integrals over what of that part looks along `facing`
};

struct FacetQuery {
  CellBox box;
  double tolerance;  ///< length: surfaces as near to each other as this are one
  /// Solids that belong to the body's neighbours. Where one begins right outside of a facet there is no surface.
  std::vector<const Solid*> others{};
  std::optional<deck::Point> facing{};  ///< unit
};

/// Finds the facets in one cell. Every piece of the solid's boundary belongs to one cell of a lattice; where it lies in
/// the common face of two cells it belongs to the one on the body's side. In 2-D facets are of planes and balls.
std::vector<Facet> facets_in(const Solid& solid, const FacetQuery& query);

}  // namespace perinox::body
