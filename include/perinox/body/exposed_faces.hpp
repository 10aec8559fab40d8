#pragma once
#include <optional>
#include <vector>

#include "perinox/body/body.hpp"

namespace perinox::body {

/// The part of a load on one piece of a body's surface that one particle carries.
struct FaceShare {
  LocalIndex particle;  ///< owned
  deck::Point center;   ///< middle of the piece, reference position
  deck::Point area;     ///< share of the piece's area times its outward normal (2-D: of its length), for pressures
  double size;          ///< share of the area, for tractions: the true one, or as seen along `facing`
};

/// Finds the exposed surface of the particles in `set` [owned particles] and shares it among particles so that loads
/// keep their resultant and their moment (docs/theory.md, section 10). The surface is that of the shapes where
/// particles stand for what is inside of their cells (cut_cells.hpp). Otherwise it is made of the cells' faces that no
/// particle of the body lies before, with the normal of the shape's surface behind them.
///
/// A whole cell's face is carried by the particles in the row behind it: 13/12, 4/12 and -5/12 of it on the first
/// three, 3/2 and -1/2 where there are only two (or where the body's reach ends there), all of it on one. Other pieces
/// are carried by the particles around with weights that are exact for linear displacements (moving least squares),
/// where there are enough. Where another body's shape touches and bodies bond there is no surface; everywhere else
/// there is.
///
/// facing: a unit vector; only what has an outward normal along it (cosine above 1e-9) counts. Collective. Throws
/// InputError at `location` on all ranks together if a particle is of a point cloud, if there is no surface at all, or
/// if none of it looks along `facing`.
std::vector<FaceShare> exposed_faces(const deck::Deck& deck, const Body& body, const std::vector<LocalIndex>& set,
                                     const deck::Location& location,
                                     const std::optional<deck::Point>& facing = std::nullopt);

}  // namespace perinox::body
