#include "cell_pieces.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

#include "arrangement.hpp"
#include "perinox/body/shape_intervals.hpp"
#include "vectors.hpp"

namespace perinox::body {

namespace {

constexpr double at[] = {1.0 / 6, 0.5, 5.0 / 6};  // places where lines run through a cell, in edges
constexpr double shortest = 1e-9;                 // in lengths of the line: a shorter part of it inside is no piece

/// Adds the middles of those parts of a line that are inside.
void sample_line(const Solid& solid, const Point& a, const Point& b, std::vector<Point>& samples) {
  for (const auto& [from, to] : intervals_inside(solid, a, b))
    if (to - from > shortest) samples.push_back(along(a, (from + to) / 2, minus(b, a)));
}

/// Number of each sample's group. Samples that see each other are in one group.
std::vector<std::size_t> groups_of(const Solid& solid, const std::vector<Point>& samples, double bridged) {
  std::vector<std::size_t> group(samples.size());
  std::iota(group.begin(), group.end(), 0U);
  for (std::size_t a = 0; a < samples.size(); ++a)
    for (std::size_t b = a + 1; b < samples.size(); ++b) {
      if (group[a] == group[b] || length_outside(solid, samples[a], samples[b]) > bridged) continue;
      const std::size_t gone = std::max(group[a], group[b]), stays = std::min(group[a], group[b]);
      std::replace(group.begin(), group.end(), gone, stays);
    }
  return group;
}

/// -1 or 1 if all samples of the group are on one side of the surface, otherwise 0.
int side_of(const Surface& surface, const std::vector<Point>& samples, const std::vector<std::size_t>& group,
            std::size_t wanted) {
  int side = 0;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    if (group[k] != wanted) continue;
    const int here = distance(surface, samples[k]) > 0 ? 1 : -1;
    if (side != 0 && here != side) return 0;
    side = here;
  }
  return side;
}

/// The part of the solid on one side of a surface.
Solid on_side(Solid solid, Surface surface, int side) {
  surface.slack = side < 0 ? surface.slack : 0;
  Solid leaf{Solid::Kind::convex, {surface}, {}};
  return {side < 0 ? Solid::Kind::intersect : Solid::Kind::subtract, {}, {std::move(solid), std::move(leaf)}};
}

/// The group's part of the solid. There is none if no surface divides it from one of the other groups.
std::optional<Solid> part_of(const Solid& solid, const std::vector<Surface>& surfaces,
                             const std::vector<Point>& samples, const std::vector<std::size_t>& group,
                             const std::vector<std::size_t>& names, std::size_t wanted) {
  std::optional<Solid> part;
  std::vector<std::size_t> left;
  std::copy_if(names.begin(), names.end(), std::back_inserter(left), [&](std::size_t one) { return one != wanted; });
  for (const Surface& surface : surfaces) {
    const int side = side_of(surface, samples, group, wanted);
    if (side == 0) continue;
    const auto divided = std::remove_if(
        left.begin(), left.end(), [&](std::size_t other) { return side_of(surface, samples, group, other) == -side; });
    if (divided == left.end()) continue;
    left.erase(divided, left.end());
    part = on_side(part ? std::move(*part) : solid, surface, side);
  }
  return left.empty() ? part : std::nullopt;
}

}  // namespace

// Lines run along every axis and from corner to corner, so that a sliver at a face is met however thin it is.
std::vector<Point> samples_in(const Solid& solid, const CellBox& box) {
  const Point side = minus(box.hi, box.lo);
  const std::size_t d = side[2] > 0 ? 3 : 2;
  std::vector<Point> samples;
  for (std::size_t axis = 0; axis < d; ++axis)
    for (const double one : at)
      for (const double other : at) {
        if (d == 2 && other != at[0]) continue;
        Point a = box.lo;
        a[(axis + 1) % d] += one * side[(axis + 1) % d];
        if (d == 3) a[(axis + 2) % d] += other * side[(axis + 2) % d];
        Point b = a;
        b[axis] = box.hi[axis];
        sample_line(solid, a, b, samples);
      }
  for (unsigned corner = 0; corner < (d == 3 ? 4U : 2U); ++corner) {
    Point a = box.lo, b = box.hi;
    for (std::size_t c = 0; c + 1 < d; ++c)
      if ((corner >> c & 1U) != 0) std::swap(a[c], b[c]);
    sample_line(solid, a, b, samples);
  }
  return samples;
}

bool may_be_divided(const Solid& solid, const CellBox& box) {
  if (where(solid, box) != Where::cut) return false;
  const Solid here = reduced(solid, box);
  std::vector<Surface> surfaces;
  list_surfaces(here, surfaces);
  return here.kind != Solid::Kind::convex && surfaces.size() > 1;
}

std::vector<CellPiece> pieces_in(const Solid& solid, const CellBox& box, double bridged) {
  std::vector<CellPiece> whole(1);
  if (!may_be_divided(solid, box)) return whole;
  const Solid here = reduced(solid, box);
  std::vector<Surface> surfaces;
  list_surfaces(here, surfaces);
  const std::vector<Point> samples = samples_in(here, box);
  whole.front().samples = samples;
  const std::vector<std::size_t> group = groups_of(here, samples, bridged);
  std::vector<std::size_t> names = group;
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  if (names.size() < 2) return whole;
  std::vector<CellPiece> pieces;
  for (const std::size_t name : names) {
    CellPiece piece{part_of(solid, surfaces, samples, group, names, name), {}};
    if (!piece.solid) return whole;
    for (std::size_t k = 0; k < samples.size(); ++k)
      if (group[k] == name) piece.samples.push_back(samples[k]);
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

bool joined(const std::vector<Point>& samples, const Solid& solid, const Point& point, double bridged) {
  return std::any_of(samples.begin(), samples.end(),
                     [&](const Point& sample) { return length_outside(solid, sample, point) <= bridged; });
}

}  // namespace perinox::body
