#pragma once
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "cut_cells.hpp"
#include "facets.hpp"
#include "perinox/body/body.hpp"
#include "perinox/body/crack_surface.hpp"

namespace perinox::body {

/// The surfaces of the deck's bodies, cell by cell.
class BodySurfaces {
 public:
  /// facing: as in FacetQuery.
  BodySurfaces(const deck::Deck& deck, int dimension, const std::optional<deck::Point>& facing);

  CutCells& cells(int part);
  /// The facets of a part's shape in one of its cells. of: restricts them to this piece of the shape.
  std::vector<Facet> facets(int part, const CutCells::Cell& cell, const std::optional<Solid>& of = std::nullopt);
  /// True if neither a gap nor a pre-crack is between two particles. There is no gap if the straight line between them
  /// leaves the bodies by no more than bridged_gap spacings.
  bool joined(int part, const deck::Point& a, int other, const deck::Point& b);
  bool cracked(const deck::Point& a, const deck::Point& b) const;

  /// The place where the straight line out of a particle along an axis (side: 1 or -1) leaves the body's shape.
  struct Exit {
    deck::Point normal{};  ///< outward normal of the shape's surface
    bool touched = false;  ///< another body's shape begins there, and bodies bond
  };
  Exit exit(int part, const deck::Point& particle, int axis, int side);

 private:
  const deck::Deck& deck_;
  int dimension_;
  std::optional<deck::Point> facing_;
  std::map<int, std::unique_ptr<CutCells>> cells_;
  std::vector<std::unique_ptr<Solid>> solids_;  ///< [parts] solid of each part; null for a point cloud
  std::vector<CrackSurface> cracks_;
};

}  // namespace perinox::body
