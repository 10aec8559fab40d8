#pragma once
#include "curves.hpp"

namespace perinox::body {

/// Integrals over a piece of surface (2-D: of a line). Positions x count from the middle of its cell.
struct SurfaceIntegrals {
  double area = 0;
  deck::Point first{};       ///< integral of x
  deck::Point normal{};      ///< integral of the unit normal out of the body
  double moment[3][3] = {};  ///< [c][k] integral of x_c n_k

  void operator+=(const SurfaceIntegrals& other);
  /// Largest difference between the two in area and vector of area.
  double difference(const SurfaceIntegrals& other) const;
};

/// Adds pieces of a straight line in a plane or along a tube. They stand for a strip of this width. n: its normal.
void add_line(SurfaceIntegrals& sum, const Intervals& pieces, const Line& line, double width, const deck::Point& n);
/// Adds pieces of a circle on a ball, which lies at a height of `rise` radii above the centre along e. width: area over
/// angle. side: -1 if the body is outside of the ball.
void add_arc(SurfaceIntegrals& sum, const Intervals& pieces, const Circle& circle, double rise, const deck::Point& e,
             const Surface& ball, int side, double width);

}  // namespace perinox::body
