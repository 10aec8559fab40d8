#pragma once
#include <string>
#include <vector>

#include "perinox/bonds/components.hpp"
#include "perinox/medium/model.hpp"

namespace perinox::loads {

/// Rate of a rigid motion at the reference position x: along + about x (x - the piece's center), the largest of them
/// about 1. along: no unit; about: 1/length.
struct RigidMotion {
  deck::Point along{}, about{};
  bool turns() const { return about != deck::Point{}; }
  deck::Point at(const deck::Point& x, const deck::Point& center) const;
};

/// A piece of the bodies, joined by bonds, that the prescribed displacements do not hold.
struct FreePiece {
  int component = 0;              ///< number in the Components
  bool touched = false;           ///< some unknown of it is prescribed
  deck::Point center{};           ///< mean reference position, length
  std::vector<RigidMotion> free;  ///< a basis of the motions left free: those without a turn come last
  std::vector<std::string>
      motions;  ///< the same in words: "move along x", "rotate about the axis through (1, 2, 0) along z"
};

/// For each piece, which rigid motions the prescribed unknowns leave free. prescribed: [at least owned * dimension].
///
/// Judged are the rigid motions that bonds resist at first order. A piece whose points span space (2-D: the plane) must
/// be held against all 6 (3) of them. Points on one plane or one line have no stiffness across it, held or not, so
/// there only the motions within it count: 3 in a plane, 1 along a line. That leaves the choice of the lateral unknowns
/// of a row or a single bond to the deck. Pieces hinged together by few bonds are not told apart. all_motions: those
/// without stiffness are judged too. Collective; the answer is the same on every rank.
std::vector<FreePiece> find_free_pieces(const body::Body& body, const bonds::Components& components,
                                        const std::vector<char>& prescribed, bool all_motions = false);

/// Throws InputError on every rank, at the deck's boundary, if a piece is not held: names its bodies, its place, its
/// free motions and the remedy. Collective.
void refuse_free_pieces(const deck::Deck& deck, const medium::Model& model, const std::vector<char>& prescribed);

}  // namespace perinox::loads
