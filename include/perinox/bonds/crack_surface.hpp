#pragma once
#include "perinox/deck/deck.hpp"

namespace perinox::bonds {

/// A pre-crack as a flat surface: a parallelogram or a disc. A segment (2-D) is the parallelogram that stands on it
/// along z; in 2-D every surface cuts where it meets z = 0.
class CrackSurface {
 public:
  /// `tolerance` is a length: a particle this near to the crack's plane is taken to lie in it. Throws InputError at the
  /// crack's place if the surface has no area.
  CrackSurface(const deck::Crack& crack, double tolerance);

  /// True if the bond between two particles crosses the surface or touches its edge. A particle in the crack's plane
  /// belongs to the side its normal points to (edge1 x edge2; `normal`; the right-hand side going from a segment's
  /// start to its end), so a bond from it to that side is whole, a bond to the other side is cut, and a bond within the
  /// plane is whole. The answer does not depend on the order of the two particles, to the last bit.
  bool cuts(const deck::Point& one, const deck::Point& other) const;
  /// False if no bond of a particle at `point` with one nearer than `reach` can be cut.
  bool within(const deck::Point& point, double reach) const;

 private:
  bool covers(const deck::Point& in_plane) const;

  deck::Point origin_{};           ///< corner of the parallelogram, center of the disc
  deck::Point normal_{};           ///< unit
  deck::Point dual1_{}, dual2_{};  ///< dual basis of the edges: (p - corner) . dual_k is the edge coordinate
  deck::Point middle_{};           ///< of a ball around the surface
  double extent_ = 0;              ///< its radius
  double radius_ = 0;              ///< of the disc; 0: a parallelogram
  double tolerance_ = 0;
};

}  // namespace perinox::bonds
