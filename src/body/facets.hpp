#pragma once
/// The boundary of a solid within a cell, piece by piece of the surfaces that it is made of.
#include <optional>
#include <vector>

#include "arrangement.hpp"
#include "surface_integrals.hpp"

namespace perinox::body {

struct Facet {
  Surface surface{};
  int side = 1;              ///< -1: the body is where the surface's outside is
  SurfaceIntegrals whole{};  ///< of the boundary of the solid
  double untouched = 0;      ///< area of what of it no other solid touches
  SurfaceIntegrals open{};   ///< of what of that looks along `facing`
};

struct FacetQuery {
  CellBox box;
  double tolerance;  ///< length: surfaces as near to each other as this are one
  /// Solids that belong to the body's neighbours: where one begins right outside of a facet there is no surface.
  std::vector<const Solid*> others{};
  std::optional<deck::Point> facing{};  ///< unit
};

/// Every piece of the solid's boundary belongs to one cell of a lattice: to the one of the body's side where it lies in
/// the cells' common face. 2-D: of planes and balls.
std::vector<Facet> facets_in(const Solid& solid, const FacetQuery& query);

}  // namespace perinox::body
