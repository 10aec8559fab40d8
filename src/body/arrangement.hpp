#pragma once
/// The surfaces near a cell. Where what lies between them changes its form along a direction, quadratures are split.
#include <vector>

#include "cut_cells.hpp"
#include "perinox/body/solid.hpp"

namespace perinox::body {

enum class Where { inside, outside, cut };
/// Position of a box relative to a solid. `cut` may also be returned for a box near the surface that is not cut.
Where where(const Solid& solid, const CellBox& box);
/// The part of the solid within the box, made of as few surfaces as are needed there. Only for boxes that are cut.
Solid reduced(const Solid& solid, const CellBox& box);
/// The solid moved by a vector.
Solid moved(Solid solid, const deck::Point& by);
/// Appends all surfaces of the solid's leaves.
void list_surfaces(const Solid& solid, std::vector<Surface>& surfaces);

/// The surfaces that lie near a box, and the places where their arrangement changes.
class Arrangement {
 public:
  Arrangement(const Solid& solid, const CellBox& box);

  void add_plane(const Surface& plane) { planes_.push_back(plane); }
  /// True if there are only planes and straight lines. Integrals over what lies between breaks are then of polynomials.
  bool straight() const { return rounds_.empty(); }
  /// True if two curved surfaces meet in a curve whose extremes are not among the breaks.
  bool rough() const { return rough_; }

  /// Positions e.x within the box at which three surfaces meet or a curve or surface turns back. e: a unit vector.
  std::vector<double> breaks_of_space(const deck::Point& e) const;
  /// The same positions within a plane, in which e lies.
  std::vector<double> breaks_of_plane(const Surface& plane, const deck::Point& e) const;
  /// Angles in (-pi, pi] of the breaks of a tube's mantle, seen along its axis and counted from `u` to `v`.
  std::vector<double> breaks_of_tube(const Surface& tube, const deck::Point& u, const deck::Point& v) const;

 private:
  template <class Keep>
  void points_on(const deck::Point& at, const deck::Point& direction, const Keep& keep) const;
  template <class Keep>
  void extremes_on(const Surface& plane, const Surface& round, const deck::Point& e, const Keep& keep) const;
  bool near(const deck::Point& x) const;

  CellBox box_;
  double margin_ = 0;
  bool rough_ = false;
  std::vector<Surface> planes_, rounds_;
};

/// Finds the common line of two planes. Returns false if they are parallel.
bool line_of(const Surface& a, const Surface& b, deck::Point& at, deck::Point& direction);

}  // namespace perinox::body
