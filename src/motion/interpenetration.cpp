#include "perinox/motion/interpenetration.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

namespace perinox::motion {

namespace {

/// Cosine between the normals of two faces above which they do not look at each other. Where they lean, at edges and
/// all over bodies that are two or four particles wide, the depth is known to a few per cent only: such pairs count
/// where they are deeper by a tenth than all others.
constexpr double facing = 0.5, leaning = -0.9, deeper = 1.1;
/// In spacings: two particles further from each other along the faces do not lie across them. The farthest that a
/// particle of a cubic lattice is from the nearest one of another: 0.71.
constexpr double sideways = 0.75;
/// In spacings: smaller overlaps are not told. Of pairs that began within a horizon of each other, and of others, whose
/// faces may be rough by as much as half a spacing each.
constexpr double tolerance = 0.1, tolerance_from_afar = 0.75;
/// Least eigenvalue of a family's sum of xi (x) xi over its largest, below which the family lies in a plane or line.
constexpr double flat = 1e-3;
/// Shortest mean of the bonds' directions that says where a body ends.
constexpr double least_lean = 0.05;

using Vector = Eigen::Vector3d;
using Matrix = Eigen::Matrix3d;

/// What is known of a body at one of its exposed particles.
struct Side {
  double spacing = 0;                    ///< 0: out of the model
  Vector normal = Vector::Zero();        ///< N; zero: none
  Matrix gradient = Matrix::Identity();  ///< F
};
constexpr int side_size = 13;

Vector three(const double* from, int d) {
  Vector v = Vector::Zero();
  for (int c = 0; c < d; ++c) v(c) = from[c];
  return v;
}

/// F of a family by least squares. Directions that it has no bonds in keep their length.
bool fit(const Matrix& square, const Matrix& mixed, int d, Matrix& gradient) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(square.topLeftCorner(d, d));
  const double largest = solver.eigenvalues()(d - 1);
  gradient = Matrix::Identity();
  if (!(largest > 0)) return false;
  bool whole = true;
  for (int k = 0; k < d; ++k) {
    const double value = solver.eigenvalues()(k);
    if (value < flat * largest) {
      whole = false;
      continue;
    }
    const Vector direction = [&] {
      Vector v = Vector::Zero();
      v.head(d) = solver.eigenvectors().col(k);
      return v;
    }();
    gradient += (mixed * direction / value - direction) * direction.transpose();
  }
  return whole;
}

/// N as the deformation has turned it; zero stays zero.
Vector turned(const Side& side, bool small_strain) {
  if (small_strain || side.normal.isZero(0)) return side.normal;
  return (side.gradient.inverse().transpose() * side.normal).normalized();
}

struct Measured {
  double depth = 0, spacing = 0;
  bool leans = false;
};

/// Two particles, or layers of them, across a gap.
struct Across {
  double rest = 0;   ///< their distance where faces touch
  double now = 0;    ///< signed
  double doubt = 0;  ///< how far off the two may be because the normals of the faces are not opposite
};

/// Half of the particle's spacing across its face, stretched as the material beside it.
double half_layer(const Side& side, const Vector& normal) {
  return 0.5 * side.spacing * normal.dot(side.gradient * side.normal);
}

Across along_normals(const Side& a, const Side& b, const Vector& na, const Vector& nb, const Vector& whole,
                     const Vector& between, bool near) {
  const Vector normal = (na - nb).normalized();
  Across found{half_layer(a, na) + half_layer(b, nb), normal.dot(between)};
  Vector shift = between - found.now * normal;
  if (near) {
    found.rest = std::min(found.rest, normal.dot(whole));
    shift -= whole - normal.dot(whole) * normal;
  }
  found.doubt = 0.5 * (na + nb).norm() * shift.norm();
  return found;
}

/// Zero where the two do not lie across two faces.
Measured overlap_of(const Side& a, const Side& b, const Vector& xi, const Vector& between, double horizon,
                    bool small_strain) {
  if (a.spacing == 0 || b.spacing == 0) return {};
  if (a.normal.dot(xi) < 0 || b.normal.dot(xi) > 0) return {};
  const double spacing = 0.5 * (a.spacing + b.spacing);
  const bool near = xi.norm() <= horizon * (1 + 1e-10);
  const Vector whole = 0.5 * (a.gradient + b.gradient) * xi;
  Across found;
  bool leans = false;
  if (a.normal.isZero(0) || b.normal.isZero(0)) {
    found = {near ? std::min(spacing, whole.norm()) : spacing, between.norm()};
  } else {
    const Vector na = turned(a, small_strain), nb = turned(b, small_strain);
    if (na.dot(nb) > facing) return {};
    leans = na.dot(nb) > leaning;
    found = along_normals(a, b, na, nb, whole, between, near);
    if (between.squaredNorm() - found.now * found.now > sideways * sideways * spacing * spacing) return {};
  }
  const double depth = found.rest - found.now - found.doubt;
  return depth > (near ? tolerance : tolerance_from_afar) * spacing ? Measured{depth, spacing, leans} : Measured{};
}

}  // namespace

std::string describe(const Overlap& overlap) {
  return fmt::format("faces that no bond joins overlap by {:.4g} ({:.2g} spacings) at ({:g}, {:g}, {:g})",
                     overlap.depth, overlap.spacings, overlap.place[0], overlap.place[1], overlap.place[2]);
}

Interpenetration::Interpenetration(const mechanics::Scene& scene)
    : scene_(scene), near_(scene, scene.families().horizon, 0), bonds_version_(scene.bonds_version()) {}

std::vector<double> Interpenetration::sides(const std::vector<double>& displacement,
                                            const std::vector<char>& loose) const {
  const body::Body& body = scene_.body();
  const int d = scene_.dimension();
  const bonds::BondGraph graph = scene_.bond_graph();
  std::vector<LocalIndex> neighbors;
  std::vector<double> values;
  values.reserve(static_cast<std::size_t>(near_.own()) * side_size);
  for (std::size_t k = 0; k < near_.particle().size(); ++k) {
    const LocalIndex i = near_.particle()[k];
    graph(i, neighbors);
    Matrix square = Matrix::Zero(), mixed = Matrix::Zero();
    const Vector place = three(body.position(i), d);
    const Vector moved = three(&displacement[static_cast<std::size_t>(i) * d], d);
    for (const LocalIndex j : neighbors) {
      const Vector xi = three(body.position(j), d) - place;
      const Vector y = xi + three(&displacement[static_cast<std::size_t>(j) * d], d) - moved;
      square += body.volume[j] * xi * xi.transpose();
      mixed += body.volume[j] * y * xi.transpose();
    }
    Side side;
    side.spacing = !loose.empty() && loose[i] ? 0 : body.spacing_of(i);
    const Vector lean = three(near_.exposed().lean[k].data(), 3);
    if (fit(square, mixed, d, side.gradient) && lean.norm() > least_lean) side.normal = -lean.normalized();
    values.push_back(side.spacing);
    values.insert(values.end(), side.normal.data(), side.normal.data() + 3);
    values.insert(values.end(), side.gradient.data(), side.gradient.data() + 9);
  }
  return near_.share(std::move(values), side_size);
}

namespace {
/// The lowest rank's where two are alike. Collective.
Overlap deepest_of_ranks(Overlap worst, const Communicator& ranks) {
  if (ranks.size() == 1) return worst;
  const std::vector<double> mine{worst.depth, worst.spacings, worst.place[0], worst.place[1], worst.place[2]};
  const std::vector<double> all = ranks.gather(mine);
  for (std::size_t r = 0; r < all.size(); r += 5)
    if (all[r] > worst.depth || r == 0) worst = {all[r], all[r + 1], 0, 0, {all[r + 2], all[r + 3], all[r + 4]}};
  return worst;
}
}  // namespace

Overlap Interpenetration::measure(const std::vector<double>& displacement, const std::vector<char>& loose) {
  if (bonds_version_ != scene_.bonds_version()) near_.refresh();
  bonds_version_ = scene_.bonds_version();
  near_.move(displacement.data());
  const std::vector<double> values = sides(displacement, loose);
  const auto side = [&](int point) {
    const double* from = &values[static_cast<std::size_t>(point) * side_size];
    return Side{from[0], three(from + 1, 3), Eigen::Map<const Matrix>(from + 4)};
  };
  const int d = scene_.dimension();
  std::array<Overlap, 2> deepest;  // of faces that are opposite, and of those that lean
  for (const auto& [one, other] : near_.pairs()) {
    const Vector xi = three(near_.reference(other), d) - three(near_.reference(one), d);
    const Vector between = three(near_.place(other), d) - three(near_.place(one), d);
    const Measured found =
        overlap_of(side(one), side(other), xi, between, scene_.families().horizon, scene_.small_strain());
    Overlap& worst = deepest[found.leans ? 1 : 0];
    if (found.depth <= worst.depth) continue;
    worst.depth = found.depth;
    worst.spacings = found.depth / found.spacing;
    for (int c = 0; c < d; ++c) worst.place[c] = near_.reference(one)[c] + 0.5 * xi(c);
  }
  for (Overlap& worst : deepest) worst = deepest_of_ranks(worst, scene_.body().communicator);
  return deepest[1].depth > deeper * deepest[0].depth ? deepest[1] : deepest[0];
}

}  // namespace perinox::motion
