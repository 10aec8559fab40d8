#pragma once
#include <array>
#include <vector>

#include "perinox/body/particles.hpp"
#include "perinox/core/communicator.hpp"
#include "perinox/deck/deck.hpp"

namespace perinox::body {

/// The cubic (2-D: square) lattice of cell centres over a shape's bounding box, centred in it. Along an axis of length
/// L there are max(1, round(L/spacing)) cells. Half a cell is rounded up, whatever the rounding of the coordinates.
struct Lattice {
  deck::Point first;   ///< centre of the first cell; 2-D: z = 0
  double spacing = 0;  ///< length
  int dimension = 3;
  std::array<long long, 3> cells{};  ///< along x, y, z; 2-D: one along z

  /// Throws InputError at the shape's place if the lattice has more than `most_lattice_points` centres.
  Lattice(const deck::BodyPart& part, int dimension);
  long long rows() const { return cells[1] * cells[2]; }  ///< rows run along x
  double volume() const;                                  ///< volume of a cell, spacing^dimension
  /// Distance within which positions count as equal, length: 1e-9 of the spacing and the rounding of the shape's
  /// coordinates.
  double tolerance(const deck::BodyPart& part) const;
};

/// A lattice with more centres than this is taken for a slip of the unit or of a digit. It is refused before anything
/// is allocated.
constexpr double most_lattice_points = 2e9;

/// Generates the particles of one body on this rank: the centres inside the shape, in lexicographic order (x fastest,
/// then y, then z). Each rank has a contiguous run of rows. Ids count from `first_id` in that order whatever the number
/// of ranks. Collective. Throws InputError if no centre is inside the shape.
std::vector<Particle> generate(const deck::Deck& deck, int part, GlobalId first_id, const Communicator& communicator);

}  // namespace perinox::body
