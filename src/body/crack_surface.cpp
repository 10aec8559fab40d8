#include "perinox/body/crack_surface.hpp"

#include <cmath>
#include <limits>
#include <utility>

namespace perinox::body {

namespace {

using deck::Point;

constexpr double kEdge = 1e-9;  ///< a crossing this much (relative to the surface) beyond the edge still counts

Point minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Point scaled(const Point& a, double factor) { return {a[0] * factor, a[1] * factor, a[2] * factor}; }
Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double size(const Point& a) { return std::abs(a[0]) + std::abs(a[1]) + std::abs(a[2]); }

/// The parallelogram that stands on a segment along z. It is as high as the segment is long, whatever the unit is.
deck::CrackRectangle standing(const deck::CrackSegment& segment) {
  const double x = segment.end[0] - segment.start[0], y = segment.end[1] - segment.start[1];
  const double high = std::hypot(x, y);
  return {{segment.start[0], segment.start[1], -high / 2}, {x, y, 0}, {0, 0, high}};
}

}  // namespace

CrackSurface::CrackSurface(const deck::Crack& crack, double tolerance) : tolerance_(tolerance) {
  if (const auto* disc = std::get_if<deck::CrackDisc>(&crack.form)) {
    const double length = std::sqrt(dot(disc->normal, disc->normal));
    if (!(length > 0) || !(disc->radius > 0)) {
      deck::refuse(crack.location, "the disc needs a normal that is not zero and a radius greater than 0");
    }
    origin_ = disc->center;
    normal_ = scaled(disc->normal, 1 / length);
    radius_ = extent_ = disc->radius;
    middle_ = disc->center;
    return;
  }
  const auto* segment = std::get_if<deck::CrackSegment>(&crack.form);
  const deck::CrackRectangle surface = segment ? standing(*segment) : std::get<deck::CrackRectangle>(crack.form);
  const Point area = cross(surface.edge1, surface.edge2);
  const double squared = dot(area, area);
  if (!(squared > 1e-24 * dot(surface.edge1, surface.edge1) * dot(surface.edge2, surface.edge2))) {
    deck::refuse(crack.location, segment ? "start and end of the segment are the same point; move one"
                                         : "the two edges of the rectangle must be two different directions");
  }
  origin_ = surface.corner;
  normal_ = scaled(area, 1 / std::sqrt(squared));
  dual1_ = scaled(cross(surface.edge2, area), 1 / squared);
  dual2_ = scaled(cross(area, surface.edge1), 1 / squared);
  for (int c = 0; c < 3; ++c) middle_[c] = surface.corner[c] + (surface.edge1[c] + surface.edge2[c]) / 2;
  extent_ = (std::sqrt(dot(surface.edge1, surface.edge1)) + std::sqrt(dot(surface.edge2, surface.edge2))) / 2;
}

/// Length by which rounding may have moved a point and the surface.
double CrackSurface::rounding(const Point& point) const {
  return 4 * std::numeric_limits<double>::epsilon() * (size(point) + size(origin_));
}

/// Height of a point above the plane; 0 in it.
double CrackSurface::height(const Point& point) const {
  const double above = dot(minus(point, origin_), normal_);
  return std::abs(above) <= tolerance_ + rounding(point) ? 0 : above;
}

bool CrackSurface::covers(const Point& in_plane, double rounding) const {
  const Point away = minus(in_plane, origin_);
  if (radius_ > 0) return std::sqrt(dot(away, away)) <= radius_ * (1 + kEdge) + rounding;
  const double a = dot(away, dual1_), b = dot(away, dual2_);
  const double slack1 = kEdge + rounding * std::sqrt(dot(dual1_, dual1_));
  const double slack2 = kEdge + rounding * std::sqrt(dot(dual2_, dual2_));
  return a >= -slack1 && a <= 1 + slack1 && b >= -slack2 && b <= 1 + slack2;
}

bool CrackSurface::holds(const Point& point) const {
  return height(point) == 0 && covers(point, tolerance_ + rounding(point));
}

bool CrackSurface::within(const Point& point, double reach) const {
  const Point away = minus(point, middle_);
  const double height = dot(minus(point, origin_), normal_), far = extent_ * (1 + kEdge) + reach;
  return std::abs(height) <= reach + tolerance_ && dot(away, away) <= far * far;
}

bool CrackSurface::cuts(const Point& one, const Point& other) const {
  double below = height(one), above = height(other);
  if (below == 0 || above == 0 || (below < 0) == (above < 0)) return false;
  const Point *low = &one, *high = &other;
  if (below > 0) {  // always from the negative side: both directions of a bond round alike
    std::swap(below, above);
    std::swap(low, high);
  }
  const double share = below / (below - above);
  const Point along = minus(*high, *low);
  return covers({(*low)[0] + share * along[0], (*low)[1] + share * along[1], (*low)[2] + share * along[2]},
                rounding(*low) + rounding(*high));
}

}  // namespace perinox::body
