#pragma once
#include <vector>

#include "perinox/body/body.hpp"

namespace perinox::body {

/// What a particle carries of a load on one face of the surface. On a lattice the surface is made of the cells' faces
/// that no particle lies before.
struct FaceShare {
  LocalIndex particle;  ///< owned
  int axis;             ///< of the face's normal
  int side;             ///< 1: the normal points along the axis, -1: against it
  deck::Point center;   ///< of the face, reference position
  double area;          ///< share of the face's area (2-D: of its length); may be negative
};

/// The exposed faces of the particles in `set` [owned particles], each shared by the particles in the row behind it so
/// that the load keeps its resultant and its moment about the face: 13/12, 4/12 and -5/12 of it on the first three, 3/2
/// and -1/2 where there are only two (or the body's reach ends there), all of it on one. Collective.
/// Throws InputError at `location` on all ranks together: a particle that is of a point cloud, no face at all.
std::vector<FaceShare> exposed_faces(const deck::Deck& deck, const Body& body, const std::vector<LocalIndex>& set,
                                     const deck::Location& location);

}  // namespace perinox::body
