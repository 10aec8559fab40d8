#pragma once
/// The surfaces near a cell, and where along a direction what lies between them changes its form: there quadratures are
/// split.
#include <vector>

#include "cut_cells.hpp"
#include "perinox/body/solid.hpp"

namespace perinox::body {

enum class Where { inside, outside, cut };
/// Of a box to a solid. `cut` may be said of a box near the surface that is not cut.
Where where(const Solid& solid, const CellBox& box);
/// The same solid within the box, of as few surfaces as are needed there. Only for boxes that are cut.
Solid reduced(const Solid& solid, const CellBox& box);
/// The same solid somewhere else.
Solid moved(Solid solid, const deck::Point& by);
/// All surfaces of its leaves.
void list_surfaces(const Solid& solid, std::vector<Surface>& surfaces);

class Arrangement {
 public:
  Arrangement(const Solid& solid, const CellBox& box);

  void add_plane(const Surface& plane) { planes_.push_back(plane); }
  /// Planes and straight lines only: integrals over what lies between breaks are of polynomials.
  bool straight() const { return rounds_.empty(); }
  /// Two curved surfaces meet in a curve whose extremes are not among the breaks.
  bool rough() const { return rough_; }

  /// Positions e.x within the box where three surfaces meet, or a curve or surface turns back. e: unit.
  std::vector<double> breaks_of_space(const deck::Point& e) const;
  /// The same in a plane; e lies in it.
  std::vector<double> breaks_of_plane(const Surface& plane, const deck::Point& e) const;
  /// Angles of breaks of a tube's mantle, seen along its axis from `u` to `v`: (-pi, pi].
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

/// The common line of two planes; false where they are parallel.
bool line_of(const Surface& a, const Surface& b, deck::Point& at, deck::Point& direction);

}  // namespace perinox::body
