#include "curved_faces.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "perinox/body/shape.hpp"

namespace perinox::body {

namespace {

// Of the spacing: how far around a particle its surface's load is spread, how deep, and how wide.
constexpr double farthest = 3.1, deepest = 3, highest = 1, width = 0.6;

/// A share that another rank's particle carries.
struct Sent {
  GlobalId id;
  FaceShare share;
};

/// Hands shares of ghosts to whoever owns them. Few: only those of surfaces that pass from rank to rank.
void hand_over(const Body& body, std::vector<FaceShare>& shares) {
  if (body.communicator.size() == 1) return;
  std::vector<Sent> mine;
  for (const FaceShare& share : shares)
    if (share.particle >= body.owned) mine.push_back({body.id[static_cast<std::size_t>(share.particle)], share});
  shares.erase(std::remove_if(shares.begin(), shares.end(), [&](const auto& s) { return s.particle >= body.owned; }),
               shares.end());
  const auto bytes = static_cast<long long>(mine.size() * sizeof(Sent));
  std::vector<int> counts, starts{0};
  for (const long long count : body.communicator.gather(bytes)) {
    counts.push_back(static_cast<int>(count));
    starts.push_back(starts.back() + counts.back());
  }
  std::vector<Sent> all(static_cast<std::size_t>(starts.back()) / sizeof(Sent));
  MPI_Allgatherv(mine.data(), static_cast<int>(bytes), MPI_BYTE, all.data(), counts.data(), starts.data(), MPI_BYTE,
                 body.communicator.mpi());
  const auto end = body.id.begin() + body.owned;
  for (Sent& sent : all) {
    const auto found = std::lower_bound(body.id.begin(), end, sent.id);
    if (found == end || *found != sent.id) continue;
    sent.share.particle = static_cast<LocalIndex>(found - body.id.begin());
    shares.push_back(sent.share);
  }
}

/// Weights phi of points around the origin with sum phi = 1 and sum phi x = 0, smallest over `preference`; where the
/// points do not span space, as near to it as they can.
Eigen::VectorXd linear_weights(const Eigen::MatrixXd& x, const Eigen::VectorXd& preference) {
  Eigen::MatrixXd basis(x.rows(), x.cols() + 1);
  basis.col(0).setOnes();
  basis.rightCols(x.cols()) = x;
  const Eigen::MatrixXd gram = basis.transpose() * preference.asDiagonal() * basis;
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver;
  solver.setThreshold(1e-8);
  solver.compute(gram);
  const Eigen::VectorXd phi = preference.asDiagonal() * (basis * solver.solve(Eigen::VectorXd::Unit(gram.rows(), 0)));
  return phi / phi.sum();
}

}  // namespace

CutCells* CurvedFaces::cells_of(int part) {
  auto& cells = cells_[part];
  const deck::BodyPart& body = deck_.body[static_cast<std::size_t>(part)];
  if (!body.cut_cells) return nullptr;
  if (!cells) cells = std::make_unique<CutCells>(body, body_.dimension);
  return cells->none() ? nullptr : cells.get();
}

bool CurvedFaces::replaces(LocalIndex i, int axis, int side) {
  CutCells* cells = cells_of(body_.part[static_cast<std::size_t>(i)]);
  return cells && !cells->whole_face(cells->cell_of(body_.position3(i)), axis, side);
}

bool CurvedFaces::against_another(const CutCells::Patch& patch, int part) const {
  const double spacing = deck_.body[static_cast<std::size_t>(part)].spacing;
  const double size = std::hypot(patch.area[0], patch.area[1], patch.area[2]);
  deck::Point before = patch.center;
  for (std::size_t c = 0; c < 3; ++c) before[c] += 0.3 * spacing * patch.area[c] / size;
  for (std::size_t other = 0; other < deck_.body.size(); ++other) {
    const deck::Shape& shape = deck_.body[other].shape;
    if (static_cast<int>(other) == part || std::holds_alternative<deck::CloudFile>(shape.form)) continue;
    if (contains(shape, before, body_.dimension)) return true;
  }
  return false;
}

void CurvedFaces::add(const CutCells::Patch& patch, double weight, LocalIndex i, std::vector<FaceShare>& shares) const {
  const auto d = static_cast<std::size_t>(body_.dimension);
  const int part = body_.part[static_cast<std::size_t>(i)];
  const double h = deck_.body[static_cast<std::size_t>(part)].spacing;
  const double size = std::hypot(patch.area[0], patch.area[1], patch.area[2]);
  if (size == 0 || against_another(patch, part)) return;
  // Only what is within reach of the particle is known to be on this rank.
  const double radius = std::min(farthest * h, body_.reach) * (1 + 1e-9);
  std::vector<LocalIndex> found, around;
  search_.within(body_.position(i), radius, found);
  std::vector<double> preference;
  for (const LocalIndex j : found) {
    if (body_.part[static_cast<std::size_t>(j)] != part) continue;
    const double* at = body_.position(j);
    double depth = 0, square = 0;
    for (std::size_t c = 0; c < d; ++c) {
      const double away = at[c] - patch.center[c];
      depth -= away * patch.area[c] / size;
      square += away * away;
    }
    if (depth > deepest * h || depth < -highest * h) continue;
    around.push_back(j);
    preference.push_back(std::exp(-std::max(0.0, square - depth * depth) / (width * width * h * h)));
  }
  Eigen::MatrixXd x(static_cast<Eigen::Index>(around.size()), static_cast<Eigen::Index>(d));
  for (std::size_t k = 0; k < around.size(); ++k)
    for (std::size_t c = 0; c < d; ++c)
      x(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(c)) =
          (body_.position(around[k])[c] - patch.center[c]) / h;
  const Eigen::VectorXd phi = linear_weights(
      x, Eigen::Map<const Eigen::VectorXd>(preference.data(), static_cast<Eigen::Index>(preference.size())));
  double components = 0;
  for (std::size_t c = 0; c < d; ++c) components += std::abs(patch.area[c]);
  for (std::size_t k = 0; k < around.size(); ++k) {
    const double share = weight * phi[static_cast<Eigen::Index>(k)];
    if (std::abs(share) < 1e-12) continue;
    for (std::size_t c = 0; c < d; ++c) {
      if (patch.area[c] == 0) continue;
      const double area = share * std::abs(patch.area[c]);
      shares.push_back(
          {around[k], static_cast<int>(c), patch.area[c] > 0 ? 1 : -1, patch.center, area, area * size / components});
    }
  }
}

std::vector<FaceShare> CurvedFaces::shares(const std::vector<LocalIndex>& set) {
  std::vector<FaceShare> shares;
  for (const LocalIndex i : set) {
    CutCells* cells = cells_of(body_.part[static_cast<std::size_t>(i)]);
    if (!cells) continue;
    const CutCells::Cell own = cells->cell_of(body_.position3(i));
    const auto take = [&](const CutCells::Cell& cell, double weight) {
      const CutCells::Patch patch = cells->patch(cell);
      if (patch.area != deck::Point{}) add(patch, weight, i, shares);
    };
    take(own, 1);
    cells->around(own, [&](const CutCells::Cell& cell, long long) {
      if (cells->kept(cell)) return;
      const std::vector<CutCells::Cell> whose = cells->owners(cell);
      if (std::find(whose.begin(), whose.end(), own) != whose.end()) take(cell, 1 / static_cast<double>(whose.size()));
    });
  }
  hand_over(body_, shares);
  return shares;
}

}  // namespace perinox::body
