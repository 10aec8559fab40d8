#pragma once
#include <algorithm>
#include <cmath>

#include "combine.hpp"
#include "curves.hpp"
#include "facets.hpp"
#include "vectors.hpp"

namespace perinox::body {

/// Compares two surfaces within the tolerance near the cell's middle: 1 if they are one; -1 if they are one with the
/// other side inside; 0 if they are two.
inline int same(const Surface& a, const Surface& b, const Point& middle, double tolerance) {
  constexpr double turned = 1e-9;
  if (a.kind != b.kind || std::abs(a.radius - b.radius) > tolerance) return 0;
  if (a.kind == Surface::Kind::ball) return norm(minus(a.at, b.at)) <= tolerance ? 1 : 0;
  if (norm(cross(a.direction, b.direction)) > turned) return 0;
  if (a.kind == Surface::Kind::tube)
    return norm(across(minus(along(a.at, dot(minus(middle, a.at), a.direction), a.direction), b.at), b.direction)) <=
                   tolerance
               ? 1
               : 0;
  const Point foot = along(middle, -distance(a, middle), a.direction);
  if (std::abs(distance(b, foot)) > tolerance) return 0;
  return dot(a.direction, b.direction) > 0 ? 1 : -1;
}

/// One surface of one leaf, with what it needs to know of all the others.
class FacetPieces {
 public:
  FacetPieces(const Solid& here, const std::vector<const Solid*>& leaves, std::size_t leaf, const Surface& on,
              const std::vector<Solid>& others, const FacetQuery& query)
      : here_(here), leaves_(leaves), leaf_(leaf), on_(on), others_(others), query_(query) {
    constexpr double shift = 10;  // of the tolerance
    middle_ = times(0.5, plus(query.box.lo, query.box.hi));
    for (std::size_t c = 0; c < 3; ++c) {
      if (!(query.box.hi[c] > query.box.lo[c])) continue;
      const bool flat = on.kind == Surface::Kind::plane && std::abs(on.direction[c]) > 1 - 1e-14;
      for (const int side : {-1, 1}) {
        Point normal{};
        normal[c] = side;
        if (!flat) cell_.push_back({Surface::Kind::plane, side < 0 ? query.box.lo : query.box.hi, normal, 0, 0});
        if (!flat) continue;
        // `side` of the pair: the body's side of a facet that may lie in the cells' common face.
        const double body = on.at[c] - side * on.direction[c] * shift * query.tolerance;
        if (!(body >= query.box.lo[c] && body < query.box.hi[c])) shut_[side > 0 ? 0 : 1] = true;
      }
    }
  }

  bool shut() const { return shut_[0] && shut_[1]; }

  /// Calls of(side, intervals on the curve, open) for the pieces of a curve. `open` is false for the boundary of the
  /// solid, and true for what of it no other solid touches.
  template <class Curve, class Of>
  void pieces(const Curve& curve, const Of& of) const {
    Intervals mine = curve.whole();
    for (const Surface& face : cell_) mine = mine.empty() ? mine : intersect(mine, curve.within(face));
    if (!mine.empty()) mine = intersect(mine, face_of(*leaves_[leaf_], curve));
    if (mine.empty()) return;
    for (std::size_t k = 0; k < leaf_ && !mine.empty(); ++k)
      if (shares_surface(*leaves_[k])) mine = subtract(mine, face_of(*leaves_[k], curve));
    const Intervals in = intersect(mine, beside(here_, curve, true)),
                    out = intersect(mine, beside(here_, curve, false));
    for (const int side : {1, -1}) {
      if (shut_[side > 0 ? 0 : 1]) continue;
      Intervals boundary = side > 0 ? subtract(in, out) : subtract(out, in);
      if (boundary.empty()) continue;
      of(side, boundary, false);
      for (const Solid& other : others_)
        if (!boundary.empty()) boundary = subtract(boundary, beside(other, curve, side < 0));
      if (!boundary.empty()) of(side, boundary, true);
    }
  }

 private:
  int same_as(const Surface& other) const { return same(on_, other, middle_, query_.tolerance); }
  bool shares_surface(const Solid& leaf) const {
    return std::any_of(leaf.surfaces.begin(), leaf.surfaces.end(), [&](const Surface& one) { return same_as(one); });
  }
  /// The part of the curve on which the leaf's own face on this surface lies.
  template <class Curve>
  Intervals face_of(const Solid& leaf, const Curve& curve) const {
    Intervals left = curve.whole();
    for (const Surface& one : leaf.surfaces)
      if (!left.empty() && same_as(one) == 0) left = intersect(left, curve.within(one));
    return left;
  }
  /// The part of the curve where the solid is right beside it, on the inner or the outer side of the surface.
  template <class Curve>
  Intervals beside(const Solid& solid, const Curve& curve, bool inner) const {
    return combine(solid, [&](const Solid& leaf, bool) -> Intervals {
      Intervals left = curve.whole();
      for (const Surface& one : leaf.surfaces) {
        if (left.empty()) return left;
        const int relation = same_as(one);
        if (relation == 0)
          left = intersect(left, curve.within(one));
        else if ((relation > 0) != inner)
          return {};
      }
      return left;
    });
  }

  const Solid& here_;
  const std::vector<const Solid*>& leaves_;
  std::size_t leaf_;
  const Surface& on_;
  const std::vector<Solid>& others_;
  const FacetQuery& query_;
  Point middle_{};
  std::vector<Surface> cell_;
  bool shut_[2] = {false, false};
};

}  // namespace perinox::body
