#pragma once
#include <vector>

#include "perinox/body/body.hpp"

namespace perinox::body {

/// What a particle carries of a load on one face of the surface, or on one component of a face that lies askew. On a
/// lattice the surface is made of the cells' faces that no particle lies before, and of what cuts cells
/// (cut_cells.hpp).
struct FaceShare {
  LocalIndex particle;  ///< owned
  int axis;             ///< of the face's normal, or of the component
  int side;             ///< 1: the normal points along the axis, -1: against it
  deck::Point center;   ///< of the face, reference position
  double area;          ///< share of the face's area (2-D: of its length) as seen along the axis; may be negative
  double size;          ///< share of the face's whole area; over the components of one that lies askew their sum is it
};

/// The exposed faces of the particles in `set` [owned particles], shared so that the load keeps its resultant and its
/// moment about the face. A whole cell's face by the particles in the row behind it: 13/12, 4/12 and -5/12 of it on the
/// first three, 3/2 and -1/2 where there are only two (or the body's reach ends there), all of it on one. A cut cell's
/// surface by the particles around, with weights that are exact for linear displacements (moving least squares), where
/// there are enough. The surface towards another body's shape is none. Collective.
/// Throws InputError at `location` on all ranks together: a particle that is of a point cloud, no face at all.
std::vector<FaceShare> exposed_faces(const deck::Deck& deck, const Body& body, const std::vector<LocalIndex>& set,
                                     const deck::Location& location);

}  // namespace perinox::body
