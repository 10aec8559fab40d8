#include "arrangement.hpp"

#include <algorithm>
#include <cmath>

#include "perinox/body/shape_intervals.hpp"
#include "vectors.hpp"

namespace perinox::body {

namespace {

/// The plane through the circle, or the straight lines, in which two balls or two tubes along one axis meet.
bool radical_plane(const Surface& a, const Surface& b, Surface& plane) {
  if (a.kind != b.kind) return false;
  Point apart = minus(b.at, a.at);
  if (a.kind == Surface::Kind::tube) {
    if (norm(cross(a.direction, b.direction)) > 1e-12) return false;
    apart = across(apart, a.direction);
  }
  const double length = norm(apart);
  if (length == 0) return true;  // they have no point in common, or all
  const double foot = (length + (a.radius - b.radius) * (a.radius + b.radius) / length) / 2;
  plane = {Surface::Kind::plane, along(a.at, foot / length, apart), times(1 / length, apart), 0, 0};
  return true;
}

/// True for a tube and a ball on its axis, whose common circles are at right angles to the axis.
bool coaxial(const Surface& a, const Surface& b) {
  const Surface& tube = a.kind == Surface::Kind::tube ? a : b;
  const Surface& ball = a.kind == Surface::Kind::tube ? b : a;
  return tube.kind == Surface::Kind::tube && ball.kind == Surface::Kind::ball &&
         norm(across(minus(ball.at, tube.at), tube.direction)) <= 1e-12 * tube.radius;
}

Surface plane_at(const Point& at, const Point& normal) { return {Surface::Kind::plane, at, normal, 0, 0}; }

}  // namespace

bool line_of(const Surface& a, const Surface& b, Point& at, Point& direction) {
  const Point turned = cross(a.direction, b.direction);
  const double size = norm(turned);
  if (size < 1e-12) return false;
  direction = times(1 / size, turned);
  const Point in_b = across(a.direction, b.direction);  // from b's plane towards a's
  const Point foot = along(a.at, -dot(minus(a.at, b.at), b.direction), b.direction);
  at = along(foot, dot(minus(a.at, foot), a.direction) / dot(in_b, a.direction), in_b);
  return true;
}

Arrangement::Arrangement(const Solid& solid, const CellBox& box) : box_(box) {
  std::vector<Surface> all;
  list_surfaces(solid, all);
  for (const Surface& one : all) (one.kind == Surface::Kind::plane ? planes_ : rounds_).push_back(one);
  for (std::size_t a = 0; a < rounds_.size(); ++a)
    for (std::size_t b = 0; b < a; ++b) {
      Surface plane;
      if (radical_plane(rounds_[a], rounds_[b], plane)) {
        if (norm(plane.direction) > 0) planes_.push_back(plane);
      } else if (coaxial(rounds_[a], rounds_[b])) {
        const bool first = rounds_[a].kind == Surface::Kind::tube;
        const Surface& tube = rounds_[first ? a : b];
        const Surface& ball = rounds_[first ? b : a];
        const double square = (ball.radius - tube.radius) * (ball.radius + tube.radius);
        for (const double side : {-1.0, 1.0})
          if (square > 0)
            planes_.push_back(plane_at(along(ball.at, side * std::sqrt(square), tube.direction), tube.direction));
      } else {
        rough_ = true;
      }
    }
  for (std::size_t c = 0; c < 3; ++c) {
    margin_ = std::max(margin_, 1e-7 * (box.hi[c] - box.lo[c]));
    Point normal{};
    normal[c] = 1;
    planes_.push_back(plane_at(box.lo, normal));
    if (box.hi[c] > box.lo[c]) planes_.push_back(plane_at(box.hi, normal));
  }
}

bool Arrangement::near(const Point& x) const {
  for (std::size_t c = 0; c < 3; ++c)
    if (!(x[c] >= box_.lo[c] - margin_ && x[c] <= box_.hi[c] + margin_)) return false;
  return true;
}

/// Calls keep(x) for the points in which the line meets surfaces near the box.
template <class Keep>
void Arrangement::points_on(const Point& at, const Point& direction, const Keep& keep) const {
  const auto take = [&](double t) {
    const Point x = along(at, t, direction);
    if (near(x)) keep(x);
  };
  for (const Surface& plane : planes_) {
    const double slope = dot(direction, plane.direction);
    if (slope != 0) take(-dot(minus(at, plane.at), plane.direction) / slope);
  }
  for (const Surface& round : rounds_) {
    const auto [begin, end] = interval_inside(round, at, direction, 0);
    if (!(begin <= end) || std::isinf(begin)) continue;
    take(begin);
    take(end);
  }
}

/// Calls keep(x) for the points of the curve common to plane and round surface that are extreme along e.
template <class Keep>
void Arrangement::extremes_on(const Surface& plane, const Surface& round, const Point& e, const Keep& keep) const {
  const Point& n = plane.direction;
  if (round.kind == Surface::Kind::ball) {
    const double off = dot(minus(plane.at, round.at), n);
    const double square = (round.radius - off) * (round.radius + off);
    const Point to = across(e, n);
    if (square <= 0 || norm(to) < 1e-12) return;
    const Point center = along(round.at, off, n);
    for (const double side : {-1.0, 1.0}) {
      const Point x = along(center, side * std::sqrt(square), unit(to));
      if (near(x)) keep(x);
    }
    return;
  }
  const Point& a = round.direction;
  const double tilt = dot(n, a);
  if (std::abs(tilt) < 1e-12) return;
  // On the tube x = at + R m + s a with m at right angles to a. The plane gives s by m, so e.x is linear in m.
  const Point slope = along(across(e, a), -dot(e, a) / tilt, across(n, a));
  const double size = norm(slope);
  if (size < 1e-12) return;
  for (const double side : {-1.0, 1.0}) {
    const Point mantle = along(round.at, side * round.radius / size, slope);
    const Point x = along(mantle, dot(minus(plane.at, mantle), n) / tilt, a);
    if (near(x)) keep(x);
  }
}

std::vector<double> Arrangement::breaks_of_plane(const Surface& plane, const Point& e) const {
  std::vector<double> breaks;
  const auto keep = [&](const Point& x) { breaks.push_back(dot(x, e)); };
  Point at, direction;
  for (const Surface& other : planes_)
    if (line_of(plane, other, at, direction)) points_on(at, direction, keep);
  for (const Surface& round : rounds_) extremes_on(plane, round, e, keep);
  return breaks;
}

std::vector<double> Arrangement::breaks_of_space(const Point& e) const {
  std::vector<double> breaks;
  const auto keep = [&](const Point& x) { breaks.push_back(dot(x, e)); };
  Point at, direction;
  for (std::size_t a = 0; a < planes_.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b)
      if (line_of(planes_[a], planes_[b], at, direction)) points_on(at, direction, keep);
    for (const Surface& round : rounds_) extremes_on(planes_[a], round, e, keep);
  }
  for (const Surface& round : rounds_) {
    const bool turns = round.kind == Surface::Kind::ball || std::abs(dot(e, round.direction)) < 1e-12;
    if (!turns) continue;
    for (const double side : {-1.0, 1.0}) breaks.push_back(dot(round.at, e) + side * round.radius);
  }
  return breaks;
}

std::vector<double> Arrangement::breaks_of_tube(const Surface& tube, const Point& u, const Point& v) const {
  std::vector<double> breaks;
  const auto keep = [&](const Point& x) {
    const Point away = minus(x, tube.at);
    breaks.push_back(std::atan2(dot(away, v), dot(away, u)));
  };
  Point at, direction;
  for (std::size_t a = 0; a < planes_.size(); ++a)
    for (std::size_t b = 0; b < a; ++b) {
      if (!line_of(planes_[a], planes_[b], at, direction)) continue;
      const auto [begin, end] = interval_inside(tube, at, direction, 0);
      if (!(begin <= end) || std::isinf(begin)) continue;
      for (const double t : {begin, end})
        if (const Point x = along(at, t, direction); near(x)) keep(x);
    }
  // Straight lines of the mantle may touch another curved surface.
  for (const Surface& round : rounds_) {
    if (round.kind == Surface::Kind::ball) {
      const Surface around{Surface::Kind::tube, round.at, tube.direction, round.radius, 0};
      Surface plane;
      if (!radical_plane(tube, around, plane) || norm(plane.direction) == 0) continue;
      const auto [begin, end] = interval_inside(tube, plane.at, cross(plane.direction, tube.direction), 0);
      for (const double t : {begin, end})
        if (begin <= end) keep(along(plane.at, t, cross(plane.direction, tube.direction)));
      continue;
    }
    const Point common = cross(tube.direction, round.direction);
    if (norm(common) < 1e-12) continue;
    const Point n = unit(common);
    for (const double side : {-1.0, 1.0}) {
      const double height = dot(minus(round.at, tube.at), n) + side * round.radius;
      const double square = (tube.radius - height) * (tube.radius + height);
      if (square <= 0) continue;
      for (const double to : {-1.0, 1.0})
        keep(along(along(tube.at, height, n), to * std::sqrt(square), cross(n, tube.direction)));
    }
  }
  return breaks;
}

}  // namespace perinox::body
