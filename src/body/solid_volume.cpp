#include "solid_volume.hpp"

#include "combine.hpp"
#include "panels.hpp"
#include "perinox/body/shape_intervals.hpp"
#include "vectors.hpp"

namespace perinox::body {

namespace {

constexpr int points = 8;  // of a quadrature between two breaks

/// The part of [0, 1] along x through the box that is inside of a leaf.
std::pair<double, double> inside_leaf(const Solid& leaf, const Point& begin, const Point& direction) {
  std::pair<double, double> left{0, 1};
  for (const Surface& surface : leaf.surfaces) {
    const auto one = interval_inside(surface, begin, direction, 0);
    left = {std::max(left.first, one.first), std::min(left.second, one.second)};
  }
  return left;
}

double share_of_line(const Solid& solid, const Point& begin, const Point& direction) {
  if (solid.kind == Solid::Kind::convex) {
    const auto [from, to] = inside_leaf(solid, begin, direction);
    return std::max(0.0, to - from);
  }
  return length(combine(solid, [&](const Solid& leaf, bool) -> Intervals {
    const auto one = inside_leaf(leaf, begin, direction);
    if (!(one.first < one.second)) return {};
    return {one};
  }));
}

}  // namespace

double share_inside(const Solid& solid, const CellBox& cell) {
  const Where place = where(solid, cell);
  if (place != Where::cut) return place == Where::inside ? 1 : 0;
  // With positions from the middle of the cell nothing is lost to the rounding of large coordinates.
  const Point middle = times(0.5, plus(cell.lo, cell.hi));
  const CellBox box{minus(cell.lo, middle), minus(cell.hi, middle)};
  const Solid here = moved(reduced(solid, cell), times(-1, middle));
  const Arrangement arrangement(here, box);
  const Form form = arrangement.straight() ? Form::polynomial : arrangement.rough() ? Form::rough : Form::root;
  const Point side = minus(box.hi, box.lo);
  const Point direction{side[0], 0, 0};
  const auto section = [&](double z) {
    double area = 0;
    std::vector<double> breaks =
        arrangement.breaks_of_plane({Surface::Kind::plane, {box.lo[0], box.lo[1], z}, {0, 0, 1}, 0, 0}, {0, 1, 0});
    over_panels<points>(breaks, box.lo[1], box.hi[1], form, [&](double y, double weight) {
      area += weight * share_of_line(here, {box.lo[0], y, z}, direction);
    });
    return area / side[1];
  };
  if (side[2] == 0) return section(0);
  double volume = 0;
  std::vector<double> breaks = arrangement.breaks_of_space({0, 0, 1});
  over_panels<points>(breaks, box.lo[2], box.hi[2], form,
                      [&](double z, double weight) { volume += weight * section(z); });
  return volume / side[2];
}

}  // namespace perinox::body
