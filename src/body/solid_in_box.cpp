#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "arrangement.hpp"
#include "vectors.hpp"

namespace perinox::body {

namespace {

/// Least and largest distance of a box's points from a ball's centre.
std::pair<double, double> distances(const CellBox& box, const Point& center) {
  double least = 0, most = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    const double below = box.lo[c] - center[c], above = center[c] - box.hi[c];
    const double out = std::max({0.0, below, above}), far = std::max(std::abs(below), std::abs(above));
    least += out * out;
    most += far * far;
  }
  return {std::sqrt(least), std::sqrt(most)};
}

Where where(const Surface& surface, const CellBox& box) {
  const Point half = times(0.5, minus(box.hi, box.lo)), middle = plus(box.lo, half);
  const double rounding = 1e-12 * std::max({half[0], half[1], half[2]});
  double least = 0, most = 0;  // signed distance of the box's points from the surface
  if (surface.kind == Surface::Kind::plane) {
    const double reach = std::abs(half[0] * surface.direction[0]) + std::abs(half[1] * surface.direction[1]) +
                         std::abs(half[2] * surface.direction[2]);
    const double at = distance(surface, middle);
    least = at - reach;
    most = at + reach;
  } else if (surface.kind == Surface::Kind::ball) {
    std::tie(least, most) = distances(box, surface.at);
    least -= surface.radius;
    most -= surface.radius;
  } else {
    const double at = distance(surface, middle), reach = norm(half);
    least = at - reach;
    most = at + reach;
  }
  return most <= rounding ? Where::inside : least >= -rounding ? Where::outside : Where::cut;
}

}  // namespace

Where where(const Solid& solid, const CellBox& box) {
  bool all_inside = true;
  if (solid.kind == Solid::Kind::convex) {
    for (const Surface& surface : solid.surfaces) {
      const Where one = where(surface, box);
      if (one == Where::outside) return one;
      all_inside = all_inside && one == Where::inside;
    }
    return all_inside ? Where::inside : Where::cut;
  }
  const bool union_of = solid.kind == Solid::Kind::unite;
  bool all_outside = true;
  for (std::size_t k = 0; k < solid.parts.size(); ++k) {
    Where one = where(solid.parts[k], box);
    if (k > 0 && solid.kind == Solid::Kind::subtract && one != Where::cut)
      one = one == Where::inside ? Where::outside : Where::inside;
    if (one == (union_of ? Where::inside : Where::outside)) return one;
    all_inside = all_inside && one == Where::inside;
    all_outside = all_outside && one == Where::outside;
  }
  return all_inside ? Where::inside : all_outside ? Where::outside : Where::cut;
}

Solid reduced(const Solid& solid, const CellBox& box) {
  Solid rest{solid.kind, {}, {}};
  if (solid.kind == Solid::Kind::convex) {
    for (const Surface& surface : solid.surfaces)
      if (where(surface, box) == Where::cut) rest.surfaces.push_back(surface);
    return rest;
  }
  for (std::size_t k = 0; k < solid.parts.size(); ++k) {
    const Where one = where(solid.parts[k], box);
    if (one == Where::cut) {
      rest.parts.push_back(reduced(solid.parts[k], box));
    } else if (k == 0 && solid.kind == Solid::Kind::subtract) {
      rest.parts.push_back({Solid::Kind::convex, {}, {}});  // inside: a leaf without surfaces is everything
    }
  }
  if (rest.parts.size() == 1) return Solid(rest.parts.front());
  return rest;
}

Solid moved(Solid solid, const Point& by) {
  for (Surface& surface : solid.surfaces) surface.at = plus(surface.at, by);
  for (Solid& part : solid.parts) part = moved(std::move(part), by);
  return solid;
}

void list_surfaces(const Solid& solid, std::vector<Surface>& surfaces) {
  surfaces.insert(surfaces.end(), solid.surfaces.begin(), solid.surfaces.end());
  for (const Solid& part : solid.parts) list_surfaces(part, surfaces);
}

}  // namespace perinox::body
