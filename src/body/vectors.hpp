#pragma once
/// Arithmetic of points in three dimensions.
#include <cmath>

#include "perinox/deck/deck.hpp"

namespace perinox::body {

using deck::Point;

inline Point plus(const Point& a, const Point& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Point minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Point times(double s, const Point& a) { return {s * a[0], s * a[1], s * a[2]}; }
/// a + s b
inline Point along(const Point& a, double s, const Point& b) {
  return {a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]};
}
inline double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double norm(const Point& a) { return std::sqrt(dot(a, a)); }
inline Point unit(const Point& a) { return times(1 / norm(a), a); }
/// The part of `a` at right angles to the unit vector `n`.
inline Point across(const Point& a, const Point& n) { return along(a, -dot(a, n), n); }

}  // namespace perinox::body
