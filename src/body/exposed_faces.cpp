#include "perinox/body/exposed_faces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "body_surfaces.hpp"
#include "perinox/body/convexity.hpp"
#include "perinox/body/neighbor_search.hpp"
#include "perinox/body/shape_intervals.hpp"
#include "spread_load.hpp"
#include "vectors.hpp"

namespace perinox::body {

namespace {

constexpr int most_layers = 3;
constexpr double row_share[most_layers + 1][most_layers] = {{}, {1}, {1.5, -0.5}, {13.0 / 12, 4.0 / 12, -5.0 / 12}};
constexpr double right_angle = 1e-9;  // cosine: a face at right angles to `facing` does not look along it

/// Collects the part of the surface that belongs to the set's particles: faces of whole cells and all other pieces.
class Exposed {
 public:
  Exposed(const deck::Deck& deck, const Body& body, const std::optional<Point>& facing)
      : deck_(deck),
        body_(body),
        facing_(facing),
        surfaces_(deck, body.dimension, facing),
        search_(body.reference, body.dimension),
        sides_(static_cast<std::size_t>(2 * body.dimension)),
        layers_(static_cast<std::size_t>(body.local()) * sides_),
        seen_(layers_.size()) {}

  void take(LocalIndex i);
  /// All shares of owned particles. Collective.
  std::vector<FaceShare> shares();
  /// True if surface was found that another body touches (touched), or that looks another way than `facing` (turned).
  bool touched() const { return touched_; }
  bool turned() const { return turned_; }

 private:
  int part(LocalIndex i) const { return body_.part[static_cast<std::size_t>(i)]; }
  double spacing(LocalIndex i) const { return deck_.body[static_cast<std::size_t>(part(i))].spacing; }
  double cell_face(LocalIndex i) const { return std::pow(spacing(i), body_.dimension - 1); }
  LocalIndex behind(LocalIndex i, int axis, int steps) const;
  std::size_t face_of(const Facet& facet, LocalIndex i);
  void take_face(LocalIndex i, std::size_t face, const std::vector<Facet>& facets);
  bool gap_to(const CutCells::Cell& next, LocalIndex i);
  void spread(const Facet& facet, const CutCells::Cell& cell, double weight, LocalIndex i);
  void add_row(LocalIndex i, std::size_t face, const Point& normal);
  void add_row_shares(LocalIndex i, std::size_t face, std::vector<FaceShare>& shares) const;

  const deck::Deck& deck_;
  const Body& body_;
  std::optional<Point> facing_;
  BodySurfaces surfaces_;
  NeighborSearch search_;
  std::size_t sides_;
  /// [local][sides] number of particles that share a face; 0: it is no face of the surface.
  std::vector<double> layers_;
  std::vector<double> seen_;  ///< [local][sides] area for tractions over the face's area
  std::vector<FaceShare> shares_;
  bool touched_ = false, turned_ = false;
};

int axis_of(std::size_t face) { return static_cast<int>(face / 2); }
int side_of(std::size_t face) { return face % 2 == 0 ? 1 : -1; }

/// The particle `steps` cells away from i along an axis, of its body or of one that bonds with it; -1: none.
LocalIndex Exposed::behind(LocalIndex i, int axis, int steps) const {
  constexpr double there = 1e-6;  // of the spacing
  Point x = body_.position3(i);
  x[static_cast<std::size_t>(axis)] += steps * spacing(i);
  double away = 0;
  const LocalIndex j = search_.nearest(x.data(), away);
  if (j < 0 || !(away <= there * spacing(i))) return -1;
  return part(j) == part(i) || deck_.bond_bodies ? j : -1;
}

/// The face of i's cell in which the facet lies; sides_ if there is none.
std::size_t Exposed::face_of(const Facet& facet, LocalIndex i) {
  if (facet.surface.kind != Surface::Kind::plane) return sides_;
  const double tolerance = 2 * surfaces_.cells(part(i)).tolerance();
  for (std::size_t axis = 0; 2 * axis < sides_; ++axis) {
    const double along = facet.side * facet.surface.direction[axis];
    if (std::abs(along) < 1 - 1e-14) continue;
    const double off = facet.surface.at[axis] - body_.position3(i)[axis];
    if (std::abs(off - std::copysign(0.5 * spacing(i), along)) <= tolerance) return 2 * axis + (along > 0 ? 0 : 1);
  }
  return sides_;
}

void Exposed::add_row(LocalIndex i, std::size_t face, const Point& normal) {
  if (facing_ && !(dot(normal, *facing_) > right_angle)) {
    turned_ = true;
    return;
  }
  const int axis = axis_of(face), side = side_of(face);
  const int in_reach = 1 + static_cast<int>(std::floor(body_.reach / spacing(i) + 1e-9));
  int count = 1;
  while (count < std::min(most_layers, in_reach)) {
    const LocalIndex next = behind(i, axis, -side * count);
    if (next < 0 || !surfaces_.joined(part(i), body_.position3(i), part(next), body_.position3(next))) break;
    ++count;
  }
  // On a surface made of steps a face stands for as much of the true surface as is seen along its axis.
  const Point& seen = facing_ ? *facing_ : normal;
  const std::size_t at = static_cast<std::size_t>(i) * sides_ + face;
  layers_[at] = count;
  seen_[at] = side * seen[static_cast<std::size_t>(axis)];
}

void Exposed::spread(const Facet& facet, const CutCells::Cell& cell, double weight, LocalIndex i) {
  touched_ = touched_ || facet.untouched < facet.whole.area;
  turned_ = turned_ || facet.open.area < facet.untouched;
  const CutCells& cells = surfaces_.cells(part(i));
  const CellBox box = cells.box(cell);
  const deck::BodyPart& own = deck_.body[static_cast<std::size_t>(part(i))];
  const double reach = (farthest_carrier + 2) * spacing(i);
  const bool open = !body::convex_within(own.shape, body_.position3(i), reach, body_.dimension);
  // Particles across a gap or a crack carry none of the load.
  const auto carries = [&](const Point& from, LocalIndex j) {
    const Point to = body_.position3(j);
    return !(open && length_outside(cells.solid(), from, to) > bridged_gap * cells.spacing()) &&
           !surfaces_.cracked(from, to);
  };
  spread_load(facet, times(0.5, plus(box.lo, box.hi)), weight, body_, i, cells.spacing(), facing_, search_, carries,
              shares_);
}

/// The facets that lie in one face of the particle's cell.
void Exposed::take_face(LocalIndex i, std::size_t face, const std::vector<Facet>& facets) {
  constexpr double rounding = 1e-9;
  CutCells& cells = surfaces_.cells(part(i));
  const CutCells::Cell own = cells.cell_of(body_.position3(i));
  double whole = 0, untouched = 0;
  for (const Facet& facet : facets) {
    whole += facet.whole.area;
    untouched += facet.untouched;
  }
  const double full = (1 - rounding) * cell_face(i);
  const bool all = !cells.exact() || (whole >= full && cells.inside(own) >= 1 - rounding);
  if (all && untouched >= (1 - rounding) * whole) {
    Point normal{};
    normal[static_cast<std::size_t>(axis_of(face))] = side_of(face);
    add_row(i, face, normal);
    return;
  }
  for (const Facet& facet : facets) spread(facet, own, cells.exact() ? 1 : cell_face(i) / whole, i);
}

void Exposed::take(LocalIndex i) {
  CutCells& cells = surfaces_.cells(part(i));
  const CutCells::Cell own = cells.cell_of(body_.position3(i));
  if (cells.deep(own)) return;
  std::vector<std::vector<Facet>> of_face(sides_ + 1);
  const auto sort = [&](const std::vector<Facet>& facets) {
    for (const Facet& facet : facets) of_face[face_of(facet, i)].push_back(facet);
  };
  if (cells.exact())
    cells.visit_owned(own, [&](const CutCells::Cell& cell, const CutCells::Piece& piece, double weight) {
      const std::vector<Facet> facets = surfaces_.facets(part(i), cell, piece.solid);
      if (cell == own) return sort(facets);
      for (const Facet& facet : facets) spread(facet, cell, weight, i);
    });
  else
    sort(surfaces_.facets(part(i), own));
  for (std::size_t face = 0; face < sides_; ++face) {
    CutCells::Cell next = own;
    next[static_cast<std::size_t>(axis_of(face))] += side_of(face);
    const bool free = cells.exact() || !cells.kept(next) || gap_to(next, i);
    if (free && !of_face[face].empty()) {
      take_face(i, face, of_face[face]);
    } else if (free && !cells.exact()) {
      const auto [normal, touched] = surfaces_.exit(part(i), body_.position3(i), axis_of(face), side_of(face));
      touched_ = touched_ || touched;
      if (!touched) add_row(i, face, normal);
    }
  }
  if (!cells.exact()) return;
  for (const Facet& facet : of_face[sides_]) spread(facet, own, 1, i);
}

/// True if a gap narrower than a cell is between the particle and the one of the next cell, which may be another
/// rank's.
bool Exposed::gap_to(const CutCells::Cell& next, LocalIndex i) {
  const CellBox box = surfaces_.cells(part(i)).box(next);
  const Point at = times(0.5, plus(box.lo, box.hi));
  return length_outside(surfaces_.cells(part(i)).solid(), body_.position3(i), at) > bridged_gap * spacing(i);
}

void Exposed::add_row_shares(LocalIndex i, std::size_t face, std::vector<FaceShare>& shares) const {
  const std::size_t at = static_cast<std::size_t>(i) * sides_ + face;
  const auto axis = static_cast<std::size_t>(axis_of(face));
  const auto count = static_cast<int>(layers_[at]);
  for (int k = 0; k < count; ++k) {
    const LocalIndex j = k == 0 ? i : behind(i, axis_of(face), -side_of(face) * k);
    if (j < 0 || j >= body_.owned) continue;
    FaceShare share{j, body_.position3(i), {}, 0};
    share.center[axis] += 0.5 * side_of(face) * spacing(i);
    const double area = row_share[count][k] * cell_face(i);
    share.area[axis] = side_of(face) * area;
    share.size = area * seen_[at];
    shares.push_back(share);
  }
}

std::vector<FaceShare> Exposed::shares() {
  hand_over(body_, shares_);
  body_.halo.update_ghosts(layers_.data(), static_cast<int>(sides_));
  body_.halo.update_ghosts(seen_.data(), static_cast<int>(sides_));
  std::vector<FaceShare> all = std::move(shares_);
  for (LocalIndex i = 0; i < body_.local(); ++i)
    for (std::size_t face = 0; face < sides_; ++face) add_row_shares(i, face, all);
  std::sort(all.begin(), all.end(), [](const FaceShare& a, const FaceShare& b) {
    return std::tie(a.particle, a.center, a.area, a.size) < std::tie(b.particle, b.center, b.area, b.size);
  });
  return all;
}

}  // namespace

std::vector<FaceShare> exposed_faces(const deck::Deck& deck, const Body& body, const std::vector<LocalIndex>& set,
                                     const deck::Location& location, const std::optional<Point>& facing) {
  const Communicator& communicator = body.communicator;
  std::string sentence;
  for (const LocalIndex i : set) {
    const deck::BodyPart& part = deck.body[static_cast<std::size_t>(body.part[static_cast<std::size_t>(i)])];
    if (!sentence.empty() || !std::holds_alternative<deck::CloudFile>(part.shape.form)) continue;
    sentence = fmt::format(
        "{}: the set holds particles of the point cloud {}, whose surface is not known; use force, or give the body "
        "a shape and a spacing",
        location.text(), part.name);
  }
  communicator.agree_on_input_error(sentence);
  Exposed exposed(deck, body, facing);
  for (const LocalIndex i : set) exposed.take(i);
  std::vector<FaceShare> shares = exposed.shares();
  const bool touched = communicator.any(exposed.touched()), turned = communicator.any(exposed.turned());
  if (communicator.any(!shares.empty())) return shares;
  communicator.agree_on_input_error(fmt::format(
      "{}: {}", location.text(),
      turned ? "no exposed face of the set looks the way facing says; turn it round or change the set"
      : touched
          ? "all of the set's surface touches another body and is bonded to it; choose a set with a free surface, "
            "or bond_bodies: false"
          : "no particle of the set lies at the surface; take the outermost layer into it"));
  return shares;
}

}  // namespace perinox::body
