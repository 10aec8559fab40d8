#include "perinox/body/cut_cells.hpp"

#include <algorithm>
#include <cmath>

#include "perinox/body/shape.hpp"

namespace perinox::body {

namespace {
constexpr double shrunk = 1e-6;  // of the spacing: a surface that runs along a cell's faces does not cut it
constexpr int samples_solid = 10, samples_plane = 32;             // along an axis of a cell
constexpr int samples_face_solid = 24, samples_edge_plane = 256;  // along an axis of a face

/// Different for cells less than 2^20 apart; `tag` from 0 to 3.
std::uint64_t key(const CutCells::Cell& c, unsigned tag = 0) {
  constexpr long long mask = (1LL << 20) - 1;
  return static_cast<std::uint64_t>((c[0] & mask) << 40 | (c[1] & mask) << 20 | (c[2] & mask)) << 2 | tag;
}

/// Along every axis the shape's bounding box is a whole number of cells.
bool filled_box(const deck::BodyPart& part, const Lattice& lattice) {
  const auto* box = std::get_if<deck::Box>(&part.shape.form);
  if (!box) return false;
  for (std::size_t c = 0; c < static_cast<std::size_t>(lattice.dimension); ++c) {
    const double cells = (box->max[c] - box->min[c]) / lattice.spacing;
    if (std::abs(cells - static_cast<double>(lattice.cells[c])) > shrunk) return false;
  }
  return true;
}
}  // namespace

CutCells::CutCells(const deck::BodyPart& part, int dimension)
    : part_(part), lattice_(part, dimension), none_(!part.cut_cells || filled_box(part, lattice_)) {}

CutCells::Cell CutCells::cell_of(const deck::Point& position) const {
  Cell cell{};
  for (std::size_t c = 0; c < static_cast<std::size_t>(lattice_.dimension); ++c)
    cell[c] = std::llround((position[c] - lattice_.first[c]) / lattice_.spacing);
  return cell;
}

deck::Point CutCells::center(const Cell& cell) const {
  deck::Point at = lattice_.first;
  for (std::size_t c = 0; c < static_cast<std::size_t>(lattice_.dimension); ++c)
    at[c] += static_cast<double>(cell[c]) * lattice_.spacing;
  return at;
}

bool CutCells::contains_point(const deck::Point& point) const {
  return contains(part_.shape, point, lattice_.dimension);
}

bool CutCells::kept(const Cell& cell) const {
  for (std::size_t c = 0; c < 3; ++c)
    if (cell[c] < 0 || cell[c] >= lattice_.cells[c]) return false;
  return contains_point(center(cell));
}

CutCells::Kind CutCells::corners(const Cell& cell) const {
  const deck::Point middle = center(cell);
  const double half = lattice_.spacing * (0.5 - shrunk);
  const int count = lattice_.dimension == 3 ? 8 : 4;
  const bool first = contains_point(middle);
  for (int corner = 0; corner < count; ++corner) {
    deck::Point at = middle;
    for (int c = 0; c < lattice_.dimension; ++c)
      at[static_cast<std::size_t>(c)] += (corner >> c & 1) != 0 ? half : -half;
    if (contains_point(at) != first) return Kind::cut;
  }
  return first ? Kind::full : Kind::empty;
}

double CutCells::sampled(const Cell& cell) const {
  const int d = lattice_.dimension, n = d == 3 ? samples_solid : samples_plane;
  const deck::Point middle = center(cell);
  const auto along = [&](int k) { return ((k + 0.5) / n - 0.5) * lattice_.spacing; };
  int inside = 0;
  for (int z = 0; z < (d == 3 ? n : 1); ++z)
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x)
        inside +=
            contains_point({middle[0] + along(x), middle[1] + along(y), d == 3 ? middle[2] + along(z) : 0}) ? 1 : 0;
  return inside / std::pow(n, d);
}

double CutCells::inside(const Cell& cell) {
  const Kind kind = corners(cell);
  if (kind != Kind::cut) return kind == Kind::full ? 1 : 0;
  const auto [found, fresh] = inside_.try_emplace(key(cell), 0.0);
  if (fresh) found->second = sampled(cell);
  return found->second;
}

std::vector<CutCells::Cell> CutCells::owners(const Cell& cell) const {
  std::vector<Cell> nearest;
  long long least = 4;
  around(cell, [&](const Cell& other, long long square) {
    if (square > least || !kept(other)) return;
    if (square < least) nearest.clear();
    least = square;
    nearest.push_back(other);
  });
  return nearest;
}

double CutCells::volume(const Cell& cell) {
  // Of what is thinner than the samples something is left: its centre is inside.
  const double least = std::pow(lattice_.dimension == 3 ? samples_solid : samples_plane, -lattice_.dimension);
  double volume = std::max(inside(cell), least);
  around(cell, [&](const Cell& other, long long) {
    if (kept(other)) return;
    const double part = inside(other);
    if (part == 0) return;
    const std::vector<Cell> whose = owners(other);
    if (std::find(whose.begin(), whose.end(), cell) != whose.end()) volume += part / static_cast<double>(whose.size());
  });
  return volume;
}

const CutCells::Face& CutCells::upper_face(const Cell& cell, int axis) {
  const auto [found, fresh] = faces_.try_emplace(key(cell, static_cast<unsigned>(axis) + 1));
  Face& face = found->second;
  if (!fresh) return face;
  const int d = lattice_.dimension, n = d == 3 ? samples_face_solid : samples_edge_plane;
  const int one = (axis + 1) % d, two = (axis + 2) % d;  // in the plane there is no second
  deck::Point middle = center(cell);
  middle[static_cast<std::size_t>(axis)] += lattice_.spacing / 2;
  const double weight = 1 / std::pow(n, d - 1);
  for (int a = 0; a < n; ++a)
    for (int b = 0; b < (d == 3 ? n : 1); ++b) {
      deck::Point at = middle;
      const double s = (a + 0.5) / n - 0.5, t = d == 3 ? (b + 0.5) / n - 0.5 : 0;
      at[static_cast<std::size_t>(one)] += s * lattice_.spacing;
      if (d == 3) at[static_cast<std::size_t>(two)] += t * lattice_.spacing;
      if (!contains_point(at)) continue;
      face.inside += weight;
      face.first[static_cast<std::size_t>(one)] += weight * s;
      if (d == 3) face.first[static_cast<std::size_t>(two)] += weight * t;
    }
  return face;
}

bool CutCells::whole_face(const Cell& cell, int axis, int side) {
  Cell next = cell;
  next[static_cast<std::size_t>(axis)] += side;
  return kept(cell) && inside(cell) == 1 && inside(next) == 0;
}

CutCells::Patch CutCells::patch(const Cell& cell) {
  // The vectors of area of a closed surface sum to nothing, and so do x (x) dA but for the volume: what is missing on
  // the cell's faces is the surface within. Lengths in spacings from the cell's centre.
  const int d = lattice_.dimension;
  const double volume = inside(cell);
  double area[3] = {}, moment[3][3] = {};
  if (volume == 1) return {};
  for (int c = 0; c < d; ++c) moment[c][c] = volume;
  for (int axis = 0; axis < d; ++axis)
    for (const int side : {-1, 1}) {
      Cell other = cell;
      other[static_cast<std::size_t>(axis)] += side;
      if (volume == 0 && whole_face(other, axis, -side)) continue;
      const Face& face = upper_face(side > 0 ? cell : other, axis);
      area[axis] -= side * face.inside;
      for (int c = 0; c < d; ++c)
        moment[c][axis] -= side * (c == axis ? 0.5 * side * face.inside : face.first[static_cast<std::size_t>(c)]);
    }
  const double square = area[0] * area[0] + area[1] * area[1] + area[2] * area[2];
  constexpr double least = 1e-3;  // of a face: rounding of the samples
  if (square < least * least) return {};
  Patch patch;
  patch.center = center(cell);
  for (int c = 0; c < d; ++c) {
    double along = 0;
    for (int k = 0; k < d; ++k) along += moment[c][k] * area[k];
    patch.center[static_cast<std::size_t>(c)] += std::clamp(along / square, -0.5, 0.5) * lattice_.spacing;
    patch.area[static_cast<std::size_t>(c)] = area[c] * std::pow(lattice_.spacing, d - 1);
  }
  return patch;
}

}  // namespace perinox::body
