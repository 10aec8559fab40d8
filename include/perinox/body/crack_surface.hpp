#pragma once
#include "perinox/deck/deck.hpp"

namespace perinox::body {

/// A pre-crack as a flat surface: a parallelogram or a disc. A segment (2-D) is the parallelogram that stands on it
/// along z. In 2-D every surface cuts where it meets z = 0.
class CrackSurface {
 public:
  /// `tolerance` is a length: a particle that is this near to the crack's plane, or as near as rounding can tell, lies
  /// in the plane. Throws InputError at the crack's place if the surface has no area.
  CrackSurface(const deck::Crack& crack, double tolerance);

  /// True if the bond between two particles crosses the surface or touches its edge. A bond with an end in the crack's
  /// plane is not cut: beyond the surface nothing cuts it, and particles on the surface itself are refused (see holds).
  /// The answer does not depend on the order of the two particles, nor on how the surface is written.
  bool cuts(const deck::Point& one, const deck::Point& other) const;
  /// True if the point is on the surface, its edge included. A particle there would be on neither side.
  bool holds(const deck::Point& point) const;
  /// False only if the surface does not hold the point and cannot cut a bond between a particle there and one nearer
  /// than `reach`.
  bool within(const deck::Point& point, double reach) const;
  /// Unit normal of the surface.
  const deck::Point& normal() const { return normal_; }

 private:
  double rounding(const deck::Point& point) const;
  double height(const deck::Point& point) const;
  bool covers(const deck::Point& in_plane, double rounding) const;

  deck::Point origin_{};           ///< corner of the parallelogram, center of the disc
  deck::Point normal_{};           ///< unit
  deck::Point dual1_{}, dual2_{};  ///< dual basis of the edges: (p - corner) . dual_k is the edge coordinate
  deck::Point middle_{};           ///< middle of a ball around the surface
  double extent_ = 0;              ///< radius of that ball
  double radius_ = 0;              ///< radius of the disc; 0: a parallelogram
  double tolerance_ = 0;
};

}  // namespace perinox::body
