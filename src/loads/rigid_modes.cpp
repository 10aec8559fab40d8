#include "perinox/loads/rigid_modes.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace perinox::loads {

namespace {

/// A rigid motion u(x) = t + theta x (x - center), as (t, theta * size): lengths, all of one scale.
using Motion = Eigen::Matrix<double, 6, 1>;
using Motions = Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, 6>;
using Vector3 = Eigen::Vector3d;

/// Supports as strong as this (the same measure) are as good as any.
constexpr double good_arm = 0.05;
/// A support that restrains a motion less than this (a lever arm, relative to the piece's size) does not hold it.
constexpr double least_arm = 1e-8;
/// Points nearer to a plane or line than this (relative to the piece's size) are on it.
constexpr double flatness = 1e-6;
/// A number this small beside one is zero, in what is said of a motion.
constexpr double negligible = 1e-6;

/// Where a piece is, and the motions known to be held or of no account; orthonormal, filled up by the supports.
struct Piece {
  Vector3 center = Vector3::Zero();
  double size = 0;  ///< largest distance from the center, length
  Motions judged;   ///< orthonormal: the motions that must be held
  Motions held;
  bool touched = false;

  Vector3 arm(const deck::Point& x) const { return Vector3(x[0], x[1], x[2]) - center; }
  /// The motion as whose product a motion moves component c of the point x.
  Motion support(const deck::Point& x, int c) const {
    Motion row = Motion::Zero();
    row(c) = 1;
    row.tail<3>() = arm(x).cross(Vector3::Unit(c)) / size;
    return row;
  }
  Motion left_free(const Motion& row) const {
    Motion rest = row;
    for (Eigen::Index k = 0; k < held.cols(); ++k) rest -= held.col(k).dot(rest) * held.col(k);
    return rest;
  }
};

void append(Motions& motions, const Motion& one) {
  motions.conservativeResize(6, motions.cols() + 1);
  motions.rightCols(1) = one;
}

Motion shift(const Vector3& along) { return (Motion() << along, Vector3::Zero()).finished(); }
Motion turn(const Vector3& about) { return (Motion() << Vector3::Zero(), about).finished(); }

/// The motions to be judged, from the spread of the points; and those that are none for these points.
void judge(Piece& piece, const Eigen::Matrix3d& spread, int dimension, bool all_motions) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread);  // ascending
  const auto extent = [&](int k) { return std::sqrt(std::max(0.0, axes.eigenvalues()(k))) / piece.size; };
  const Vector3 longest = axes.eigenvectors().col(2), middle = axes.eigenvectors().col(1);
  const Vector3 normal = dimension == 2 ? Vector3::UnitZ() : Vector3(axes.eigenvectors().col(0));
  if (dimension == 2) {
    append(piece.held, shift(Vector3::UnitZ()));
    append(piece.held, turn(Vector3::UnitX()));
    append(piece.held, turn(Vector3::UnitY()));
  }
  if (extent(1) < flatness) {  // a line: a turn about it moves nothing
    append(piece.judged, shift(longest));
    if (dimension == 3) append(piece.held, turn(longest));
  } else if (dimension == 2 || extent(0) < flatness) {
    append(piece.judged, shift(longest));
    append(piece.judged, shift(middle));
    append(piece.judged, turn(normal));
  } else {
    piece.judged = Motions::Identity(6, 6);
  }
  if (all_motions) piece.judged = Motions::Identity(6, 6);
}

std::vector<Piece> measure(const body::Body& body, const bonds::Components& components, bool all_motions) {
  const auto count = static_cast<std::size_t>(components.count());
  std::vector<Piece> pieces(count);
  std::vector<double> sums(3 * count, 0.0), sizes(count, 0.0), spreads(9 * count, 0.0);
  for (LocalIndex i = 0; i < body.owned; ++i)
    for (std::size_t c = 0; c < 3; ++c) sums[3 * components.of[i] + c] += body.position3(i)[c];
  body.communicator.sum(sums);
  for (std::size_t k = 0; k < count; ++k)
    pieces[k].center = Eigen::Map<const Vector3>(&sums[3 * k]) / static_cast<double>(components.particles[k]);
  for (LocalIndex i = 0; i < body.owned; ++i) {
    const auto k = static_cast<std::size_t>(components.of[i]);
    const Vector3 arm = pieces[k].arm(body.position3(i));
    sizes[k] = std::max(sizes[k], arm.norm());
    Eigen::Map<Eigen::Matrix3d>(&spreads[9 * k]) += arm * arm.transpose();
  }
  body.communicator.max(sizes);
  body.communicator.sum(spreads);
  for (std::size_t k = 0; k < count; ++k) {
    pieces[k].size = sizes[k] > 0 ? sizes[k] : 1;  // a single particle
    judge(pieces[k], Eigen::Map<const Eigen::Matrix3d>(&spreads[9 * k]) / components.particles[k], body.dimension,
          all_motions);
  }
  return pieces;
}

/// The motion of piece k in an array of them.
Eigen::Map<Motion> kept(std::vector<double>& rows, std::size_t k) { return Eigen::Map<Motion>(&rows[6 * k]); }

/// Fills `held` with an orthonormal basis of what supports hold by more than `least`: in each round every piece takes,
/// over all ranks, the support with the largest part not yet held (QR with pivoting, without ever storing the rows).
/// Of the particles with supports every `stride`-th of this rank is looked at.
void hold(std::vector<Piece>& pieces, const body::Body& body, const bonds::Components& components,
          const std::vector<char>& prescribed, std::size_t stride, double least) {
  const auto d = static_cast<std::size_t>(body.dimension);
  const Communicator& ranks = body.communicator;
  for (int round = 0; round < 6; ++round) {
    std::vector<double> best(pieces.size(), 0.0), rows(6 * pieces.size(), 0.0);
    std::size_t met = 0;
    for (LocalIndex i = 0; i < body.owned; ++i) {
      const char* fixed = &prescribed[static_cast<std::size_t>(i) * d];
      const auto k = static_cast<std::size_t>(components.of[i]);
      if (std::none_of(fixed, fixed + d, [](char c) { return c != 0; })) continue;
      if (met++ % stride != 0 || pieces[k].held.cols() == 6) continue;
      for (std::size_t c = 0; c < d; ++c) {
        if (!fixed[c]) continue;
        const Motion rest = pieces[k].left_free(pieces[k].support(body.position3(i), static_cast<int>(c)));
        if (rest.norm() <= best[k]) continue;
        best[k] = rest.norm();
        kept(rows, k) = rest;
      }
    }
    std::vector<double> most = best, speaker(pieces.size());
    ranks.max(most);
    for (std::size_t k = 0; k < pieces.size(); ++k)
      speaker[k] = best[k] == most[k] ? static_cast<double>(-ranks.rank()) : static_cast<double>(-ranks.size());
    ranks.max(speaker);
    for (std::size_t k = 0; k < pieces.size(); ++k)
      if (speaker[k] != static_cast<double>(-ranks.rank())) kept(rows, k).setZero();
    ranks.sum(rows);
    bool more = false;
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      pieces[k].touched = pieces[k].touched || most[k] > 0;
      if (most[k] <= least) continue;
      // Once more, because a small part left over is no longer orthogonal to rounding.
      append(pieces[k].held, pieces[k].left_free(kept(rows, k) / most[k]).normalized());
      more = more || pieces[k].held.cols() < 6;
    }
    if (!more) return;
  }
}

/// All supports; where a thousand of a rank's hold a piece well, as nearly always, the others are left aside.
void hold(std::vector<Piece>& pieces, const body::Body& body, const bonds::Components& components,
          const std::vector<char>& prescribed) {
  const auto supports = static_cast<std::size_t>(
      std::count(prescribed.begin(), prescribed.begin() + static_cast<std::ptrdiff_t>(body.owned) * body.dimension, 1));
  hold(pieces, body, components, prescribed, supports / 1000 + 1, good_arm);
  hold(pieces, body, components, prescribed, 1, least_arm);
}

/// An orthonormal basis of the judged motions' part that nothing holds.
Motions free_motions(const Piece& piece) {
  Motions rest(6, piece.judged.cols());
  for (Eigen::Index k = 0; k < piece.judged.cols(); ++k) rest.col(k) = piece.left_free(piece.judged.col(k));
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> decomposition;
  decomposition.setThreshold(negligible);
  decomposition.compute(rest);
  if (rest.size() == 0 || rest.norm() < negligible) return Motions(6, 0);
  const Eigen::MatrixXd basis = decomposition.householderQ() * Eigen::MatrixXd::Identity(6, decomposition.rank());
  return basis;
}

/// The same space by motions that are plain to say: turns about coordinate axes where there are such, then shifts
/// (reduced echelon form with the rotation's components first).
std::vector<Motion> plain(const Motions& basis) {
  Eigen::MatrixXd rows(basis.cols(), 6);
  rows << basis.bottomRows(3).transpose(), basis.topRows(3).transpose();
  Eigen::Index done = 0;
  for (Eigen::Index column = 0; column < 6 && done < rows.rows(); ++column) {
    Eigen::Index pivot = 0;
    if (rows.col(column).tail(rows.rows() - done).cwiseAbs().maxCoeff(&pivot) < negligible) continue;
    rows.row(done).swap(rows.row(done + pivot));
    rows.row(done) /= rows(done, column);
    for (Eigen::Index r = 0; r < rows.rows(); ++r)
      if (r != done) rows.row(r) -= rows(r, column) * rows.row(done).eval();
    ++done;
  }
  std::vector<Motion> motions;
  for (Eigen::Index r = 0; r < done; ++r)
    motions.push_back((Motion() << rows.row(r).tail<3>().transpose(), rows.row(r).head<3>().transpose()).finished());
  return motions;
}

std::string point(const Vector3& x, double scale, int dimension) {
  const auto value = [&](int c) { return std::abs(x(c)) < negligible * scale ? 0.0 : x(c); };
  return dimension == 2 ? fmt::format("({:.6g}, {:.6g})", value(0), value(1))
                        : fmt::format("({:.6g}, {:.6g}, {:.6g})", value(0), value(1), value(2));
}

std::string direction(const Vector3& along, int dimension) {
  const Vector3 unit = along.normalized();
  for (int c = 0; c < 3; ++c)
    if (1 - std::abs(unit(c)) < negligible) return std::string(1, "xyz"[c]);
  return point(unit, 1, dimension);
}

RigidMotion rigid_motion(const Motion& motion, const Piece& piece) {
  RigidMotion plain;
  for (int c = 0; c < 3; ++c) plain.along[static_cast<std::size_t>(c)] = motion(c);
  if (motion.tail<3>().norm() < negligible) return plain;
  for (int c = 0; c < 3; ++c) plain.about[static_cast<std::size_t>(c)] = motion(3 + c) / piece.size;
  return plain;
}

std::string say(const Motion& motion, const Piece& piece, int dimension) {
  const Vector3 along = motion.head<3>(), about = motion.tail<3>() / piece.size;
  if (motion.tail<3>().norm() < negligible) return "move along " + direction(along, dimension);
  const Vector3 through = piece.center + about.cross(along) / about.squaredNorm();
  if (dimension == 2) return "rotate about " + point(through, piece.size, dimension);
  const bool screw = std::abs(about.normalized().dot(along)) > negligible * motion.norm();
  return fmt::format("rotate about the axis through {} along {}{}", point(through, piece.size, dimension),
                     direction(about, dimension), screw ? " while moving along it" : "");
}

}  // namespace

deck::Point RigidMotion::at(const deck::Point& x, const deck::Point& center) const {
  const Vector3 arm(x[0] - center[0], x[1] - center[1], x[2] - center[2]);
  const Vector3 turned = Vector3(about[0], about[1], about[2]).cross(arm);
  return {along[0] + turned(0), along[1] + turned(1), along[2] + turned(2)};
}

std::vector<FreePiece> find_free_pieces(const body::Body& body, const bonds::Components& components,
                                        const std::vector<char>& prescribed, bool all_motions) {
  std::vector<Piece> pieces = measure(body, components, all_motions);
  hold(pieces, body, components, prescribed);
  std::vector<FreePiece> found;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const Motions free = free_motions(pieces[k]);
    if (free.cols() == 0) continue;
    FreePiece one;
    one.component = static_cast<int>(k);
    one.touched = pieces[k].touched;
    std::copy_n(pieces[k].center.data(), 3, one.center.begin());
    for (const Motion& motion : plain(free)) {
      one.free.push_back(rigid_motion(motion, pieces[k]));
      one.motions.push_back(say(motion, pieces[k], body.dimension));
    }
    found.push_back(std::move(one));
  }
  return found;
}

}  // namespace perinox::loads
