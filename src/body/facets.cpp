#include "facets.hpp"

#include <algorithm>
#include <cmath>

#include "facet_pieces.hpp"
#include "panels.hpp"
#include "vectors.hpp"

namespace perinox::body {

namespace {

constexpr int points = 12;             // of a quadrature between two breaks
constexpr double along_facing = 1e-9;  // cosine: a face at right angles to `facing` does not look along it
constexpr double pi = 3.14159265358979323846;

void list_leaves(const Solid& solid, std::vector<const Solid*>& leaves) {
  if (solid.kind == Solid::Kind::convex) leaves.push_back(&solid);
  for (const Solid& part : solid.parts) list_leaves(part, leaves);
}

/// A unit vector at right angles to n. It is along an axis where n is.
Point beside(const Point& n) {
  std::size_t least = 0;
  for (std::size_t c = 1; c < 3; ++c)
    if (std::abs(n[c]) < std::abs(n[least])) least = c;
  Point axis{};
  axis[least] = 1;
  return unit(across(axis, n));
}

/// The facets of one surface with the body on its inside and on its outside.
struct BothSides {
  Facet facet[2];
  Facet& of(int side) { return facet[side > 0 ? 0 : 1]; }
  void operator+=(const BothSides& other) {
    for (std::size_t k = 0; k < 2; ++k) {
      facet[k].whole += other.facet[k].whole;
      facet[k].open += other.facet[k].open;
      facet[k].untouched += other.facet[k].untouched;
    }
  }
  double difference(const BothSides& other) const {
    double largest = 0;
    for (std::size_t k = 0; k < 2; ++k)
      largest = std::max(
          {largest, facet[k].whole.difference(other.facet[k].whole), facet[k].open.difference(other.facet[k].open)});
    return largest;
  }
};

/// Computes the integrals over one surface of one leaf. All positions count from the middle of the cell.
class FacetIntegrals {
 public:
  FacetIntegrals(const FacetPieces& pieces, const Arrangement& arrangement, const Surface& on, const FacetQuery& query)
      : pieces_(pieces), arrangement_(arrangement), on_(on), query_(query) {
    reach_ = norm(minus(query.box.hi, query.box.lo));
    const bool flat = !(query.box.hi[2] > query.box.lo[2]);
    if (on.kind == Surface::Kind::plane)
      flat ? add_straight({-on.direction[1], on.direction[0], 0}, foot(), 1, on.direction, sum_) : plane();
    else if (on.kind == Surface::Kind::ball)
      flat ? add_circle(0, on.radius, sum_) : ball();
    else
      tube();
  }
  void append(std::vector<Facet>& facets) const {
    for (std::size_t k = 0; k < 2; ++k) {
      if (!(sum_.facet[k].whole.area > 0)) continue;
      facets.push_back(sum_.facet[k]);
      facets.back().surface = on_;
      facets.back().side = k == 0 ? 1 : -1;
    }
  }

 private:
  Point foot() const { return times(-distance(on_, {}), on_.direction); }
  void add_straight(const Point& direction, const Point& at, double width, const Point& n, BothSides& sum) const;
  void add_circle(double height, double width, BothSides& sum) const;
  double tolerance() const { return 1e-10 * reach_ * reach_; }  ///< of a half; what is kept is far better
  void plane();
  void tube();
  void ball();

  const FacetPieces& pieces_;
  const Arrangement& arrangement_;
  const Surface& on_;
  const FacetQuery& query_;
  double reach_ = 0;
  BothSides sum_;
};

/// Adds the piece of a straight line near the cell. n: the surface's normal there.
void FacetIntegrals::add_straight(const Point& direction, const Point& at, double width, const Point& n,
                                  BothSides& sum) const {
  const Line line{at, direction, -reach_, reach_};
  pieces_.pieces(line, [&](int side, const Intervals& pieces, bool open) {
    const Point out = times(side, n);
    if (open) sum.of(side).untouched += width * length(pieces);
    if (open && query_.facing && !(dot(out, *query_.facing) > along_facing)) return;
    add_line(open ? sum.of(side).open : sum.of(side).whole, pieces, line, width, out);
  });
}

/// Adds the circle of a ball at a height over its centre along z.
void FacetIntegrals::add_circle(double height, double width, BothSides& sum) const {
  const double radius = std::sqrt((on_.radius - height) * (on_.radius + height));
  const Circle circle{along(on_.at, height, {0, 0, 1}), {1, 0, 0}, {0, 1, 0}, radius};
  pieces_.pieces(circle, [&](int side, Intervals pieces, bool open) {
    if (open) sum.of(side).untouched += width * length(pieces);
    if (open && query_.facing)
      pieces = intersect(pieces, circle.within({Surface::Kind::plane, on_.at, times(-side, *query_.facing), 0, 0}));
    add_arc(open ? sum.of(side).open : sum.of(side).whole, pieces, circle, height / on_.radius, {0, 0, 1}, on_, side,
            width);
  });
}

void FacetIntegrals::plane() {
  const Point v = beside(on_.direction), u = cross(v, on_.direction), at = foot();
  std::vector<double> breaks = arrangement_.breaks_of_plane(on_, u);
  const double here = dot(at, u);
  add_panels<points>(breaks, here - reach_, here + reach_, arrangement_.straight() ? Form::polynomial : Form::root,
                     tolerance(), sum_, [&](double x, double weight, BothSides& sum) {
                       add_straight(v, along(at, x - here, u), weight, on_.direction, sum);
                     });
}

void FacetIntegrals::tube() {
  const Point u = beside(on_.direction), v = cross(on_.direction, u);
  const Point away = across(times(-1, on_.at), on_.direction);
  const double off = norm(away), seen = off > 0.5 * reach_ ? std::asin(0.5 * reach_ / off) + 1e-6 : pi;
  const double toward = off > 0 ? std::atan2(dot(away, v), dot(away, u)) : 0;
  std::vector<double> breaks = arrangement_.breaks_of_tube(on_, u, v);
  if (query_.facing)
    for (const double turn : {-pi / 2, pi / 2})
      breaks.push_back(std::atan2(dot(*query_.facing, v), dot(*query_.facing, u)) + turn);
  for (const double turn : {0.0, pi / 2, pi, -pi / 2}) breaks.push_back(toward + turn);
  for (double& one : breaks) one = toward + std::remainder(one - toward, 2 * pi);
  const double height = -dot(on_.at, on_.direction);
  const auto ruling = [&](double angle, double weight, BothSides& sum) {
    const Point n = plus(times(std::cos(angle), u), times(std::sin(angle), v));
    const Point at = along(along(on_.at, height, on_.direction), on_.radius, n);
    add_straight(on_.direction, at, on_.radius * weight, n, sum);
  };
  add_panels<points>(breaks, toward - seen, toward + seen, Form::root, tolerance(), sum_, ruling);
}

void FacetIntegrals::ball() {
  const double lo = std::max(query_.box.lo[2] - on_.at[2], -on_.radius);
  const double hi = std::min(query_.box.hi[2] - on_.at[2], on_.radius);
  if (!(lo < hi)) return;
  std::vector<double> breaks = arrangement_.breaks_of_space({0, 0, 1});
  for (double& one : breaks) one -= on_.at[2];
  add_panels<points>(breaks, lo, hi, Form::root, tolerance(), sum_, [&](double height, double weight, BothSides& sum) {
    add_circle(height, on_.radius * weight, sum);
  });
}

}  // namespace

std::vector<Facet> facets_in(const Solid& solid, const FacetQuery& query) {
  constexpr double grown = 20;  // tolerances: surfaces in the cell's faces are seen from both sides
  CellBox around = query.box;
  for (std::size_t c = 0; c < 3; ++c) {
    if (!(around.hi[c] > around.lo[c])) continue;
    around.lo[c] -= grown * query.tolerance;
    around.hi[c] += grown * query.tolerance;
  }
  if (where(solid, around) != Where::cut) return {};
  // With positions from the middle of the cell nothing is lost to the rounding of large coordinates.
  const Point middle = times(0.5, plus(query.box.lo, query.box.hi));
  FacetQuery local = query;
  local.box = {minus(query.box.lo, middle), minus(query.box.hi, middle)};
  const Solid here = moved(reduced(solid, around), times(-1, middle));
  std::vector<Solid> others;
  for (const Solid* other : query.others) {
    const Where place = where(*other, around);
    if (place == Where::cut) others.push_back(moved(reduced(*other, around), times(-1, middle)));
    if (place == Where::inside) others.push_back({Solid::Kind::convex, {}, {}});
  }
  Solid all{Solid::Kind::unite, {}, others};
  all.parts.push_back(here);
  const Arrangement arrangement(all, local.box);
  std::vector<const Solid*> leaves;
  list_leaves(here, leaves);
  std::vector<Facet> facets;
  for (std::size_t leaf = 0; leaf < leaves.size(); ++leaf)
    for (const Surface& on : leaves[leaf]->surfaces) {
      const FacetPieces pieces(here, leaves, leaf, on, others, local);
      if (pieces.shut()) continue;
      Arrangement split = arrangement;
      if (query.facing && on.kind == Surface::Kind::ball)
        split.add_plane({Surface::Kind::plane, on.at, *query.facing, 0, 0});
      FacetIntegrals(pieces, split, on, local).append(facets);
    }
  for (Facet& facet : facets) facet.surface.at = plus(facet.surface.at, middle);
  return facets;
}

}  // namespace perinox::body
