#include "body_surfaces.hpp"

#include <algorithm>
#include <cmath>

#include "perinox/body/shape_intervals.hpp"
#include "vectors.hpp"

namespace perinox::body {

namespace {

/// Outward normal of the surface itself, whichever side the body is on.
Point normal_at(const Surface& surface, const Point& x) {
  if (surface.kind == Surface::Kind::plane) return surface.direction;
  const Point away = minus(x, surface.at);
  const Point radial = surface.kind == Surface::Kind::tube ? across(away, surface.direction) : away;
  return times(1 / surface.radius, radial);
}

}  // namespace

BodySurfaces::BodySurfaces(const deck::Deck& deck, int dimension, const std::optional<deck::Point>& facing)
    : deck_(deck), dimension_(dimension), facing_(facing) {
  for (const deck::BodyPart& part : deck.body)
    solids_.push_back(std::holds_alternative<deck::CloudFile>(part.shape.form)
                          ? nullptr
                          : std::make_unique<Solid>(solid_of(part.shape, dimension)));
  constexpr double in_its_plane = 1e-9;  // of the spacing
  double finest = deck.body.front().spacing;
  for (const deck::BodyPart& part : deck.body) finest = std::min(finest, part.spacing);
  for (const deck::Crack& crack : deck.cracks) cracks_.emplace_back(crack, in_its_plane * finest);
}

CutCells& BodySurfaces::cells(int part) {
  auto& cells = cells_[part];
  if (!cells) cells = std::make_unique<CutCells>(deck_.body[static_cast<std::size_t>(part)], dimension_);
  return *cells;
}

std::vector<Facet> BodySurfaces::facets(int part, const CutCells::Cell& cell, const std::optional<Solid>& of) {
  CutCells& mine = cells(part);
  FacetQuery query{mine.box(cell), mine.tolerance(), {}, facing_};
  if (deck_.bond_bodies)
    for (std::size_t other = 0; other < solids_.size(); ++other)
      if (static_cast<int>(other) != part && solids_[other]) query.others.push_back(solids_[other].get());
  return facets_in(of ? *of : mine.solid(), query);
}

bool BodySurfaces::cracked(const deck::Point& a, const deck::Point& b) const {
  return std::any_of(cracks_.begin(), cracks_.end(), [&](const CrackSurface& crack) { return crack.cuts(a, b); });
}

bool BodySurfaces::joined(int part, const deck::Point& a, int other, const deck::Point& b) {
  if (cracked(a, b)) return false;
  Intervals inside = intervals_inside(cells(part).solid(), a, b);
  if (other != part) inside = unite(inside, intervals_inside(cells(other).solid(), a, b));
  return norm(minus(b, a)) * (1 - length(inside)) <= bridged_gap * cells(part).spacing();
}

BodySurfaces::Exit BodySurfaces::exit(int part, const deck::Point& particle, int axis, int side) {
  const auto a = static_cast<std::size_t>(axis);
  const CutCells& mine = cells(part);
  const double length = 2 * mine.spacing(), near = 1e-6 * mine.spacing();
  Point end = particle;
  end[a] += side * length;
  Exit exit;
  exit.normal[a] = side;
  const Intervals own = intervals_inside(mine.solid(), particle, end);
  const double at = own.empty() || own.front().first * length > near ? 0 : own.front().second * length;
  Point x = particle;
  x[a] += side * at;
  // Of all surfaces that meet there, take the one that is met most squarely.
  std::vector<Surface> surfaces;
  list_surfaces(mine.solid(), surfaces);
  double most = 1e-6;
  for (const Surface& surface : surfaces) {
    if (std::abs(distance(surface, x)) > near) continue;
    const Point n = normal_at(surface, x);
    const double along = std::abs(n[a]);
    if (along <= most) continue;
    most = along;
    exit.normal = n[a] * side > 0 ? n : times(-1, n);
  }
  if (!deck_.bond_bodies) return exit;
  for (std::size_t other = 0; other < solids_.size(); ++other) {
    if (static_cast<int>(other) == part || !solids_[other]) continue;
    for (const auto& [first, second] : intervals_inside(*solids_[other], particle, end))
      exit.touched =
          exit.touched || (first * length <= at + mine.tolerance() && second * length > at + 10 * mine.tolerance());
  }
  return exit;
}

}  // namespace perinox::body
