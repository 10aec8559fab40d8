#include "spread_load.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "perinox/body/shape_intervals.hpp"
#include "vectors.hpp"

namespace perinox::body {

namespace {

// Lengths in spacings that say how deep a surface's load is spread, and how wide.
constexpr double deepest = 3, highest = 1, width = 0.6;

using Carries = std::function<bool(const Point& from, LocalIndex j)>;

/// A share that another rank's particle carries.
struct Sent {
  GlobalId id;
  FaceShare share;
};

/// The particles that carry a facet's load, and each one's preferred part of it.
struct Carriers {
  std::vector<LocalIndex> particle;
  std::vector<double> preference;
};

Carriers carriers_of(const Facet& facet, const Point& center, const Body& body, LocalIndex i, double h,
                     const NeighborSearch& search, const Carries& carries) {
  const double straight = norm(facet.whole.normal);
  // A piece that is bent round onto itself has no direction.
  const Point n = straight > 0.1 * facet.whole.area ? times(1 / straight, facet.whole.normal) : Point{};
  // Only particles within reach of this one are known to be on this rank.
  const double radius = std::min(farthest_carrier * h, body.reach) * (1 + 1e-9);
  std::vector<LocalIndex> found;
  search.within(body.position(i), radius, found);
  Carriers carriers;
  for (const LocalIndex j : found) {
    if (body.part[static_cast<std::size_t>(j)] != body.part[static_cast<std::size_t>(i)]) continue;
    const Point away = minus(body.position3(j), center);
    const double depth = -dot(away, n);
    if (j != i && (depth > deepest * h || depth < -highest * h)) continue;
    if (!carries(center, j)) continue;
    carriers.particle.push_back(j);
    carriers.preference.push_back(std::max(0.0, dot(away, away) - depth * depth) / (width * width * h * h));
  }
  if (carriers.particle.empty()) {
    carriers.particle.push_back(i);
    carriers.preference.push_back(0);
  }
  // A facet may lie far from all of them. What counts is how much nearer one is than another.
  const double least = *std::min_element(carriers.preference.begin(), carriers.preference.end());
  for (double& one : carriers.preference) one = std::exp(least - one);
  return carriers;
}

/// Shares integrals of 1 and x (about `center`) among the carriers so that their sum and first moment stay the same.
/// integrals: [1 + dimension][columns].
Eigen::MatrixXd distribute(const Carriers& carriers, const Point& center, const Body& body, double h,
                           const Eigen::MatrixXd& integrals) {
  const auto count = static_cast<Eigen::Index>(carriers.particle.size()), d = Eigen::Index{body.dimension};
  const Eigen::VectorXd w = Eigen::Map<const Eigen::VectorXd>(carriers.preference.data(), count);
  Eigen::MatrixXd x(count, d);
  for (Eigen::Index k = 0; k < count; ++k)
    for (Eigen::Index c = 0; c < d; ++c)
      x(k, c) =
          (body.position(carriers.particle[static_cast<std::size_t>(k)])[c] - center[static_cast<std::size_t>(c)]) / h;
  // About the carriers' own middle the sum is kept whether or not they span space.
  const Eigen::RowVectorXd middle = w.transpose() * x / w.sum();
  x.rowwise() -= middle;
  const Eigen::MatrixXd moments = integrals.bottomRows(d) / h - middle.transpose() * integrals.topRows(1);
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver;
  solver.setThreshold(1e-8);
  solver.compute(x.transpose() * w.asDiagonal() * x);
  Eigen::MatrixXd parts = w.asDiagonal() * (Eigen::VectorXd::Constant(count, 1 / w.sum()) * integrals.topRows(1) +
                                            x * solver.solve(moments));
  // Far from its carriers a load needs large weights. Their rounding goes to the particle that is preferred most.
  Eigen::Index most = 0;
  w.maxCoeff(&most);
  parts.row(most) += integrals.row(0) - parts.colwise().sum();
  return parts;
}

}  // namespace

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

void spread_load(const Facet& facet, const Point& middle, double weight, const Body& body, LocalIndex i, double spacing,
                 const std::optional<Point>& facing, const NeighborSearch& search, const Carries& carries,
                 std::vector<FaceShare>& shares) {
  if (!(facet.open.area > 0)) return;
  const Point center = along(middle, 1 / facet.whole.area, facet.whole.first);
  const Carriers carriers = carriers_of(facet, center, body, i, spacing, search, carries);
  const auto d = static_cast<std::size_t>(body.dimension);
  // Columns are the normal's components and the area; rows are their integrals and first moments about the facet's
  // centre.
  Eigen::MatrixXd integrals(static_cast<Eigen::Index>(d) + 1, static_cast<Eigen::Index>(d) + 1);
  const auto about = [&](double first, double sum, std::size_t c) { return first - (center[c] - middle[c]) * sum; };
  for (std::size_t k = 0; k <= d; ++k) {
    const auto column = static_cast<Eigen::Index>(k);
    const double sum = k < d ? facet.open.normal[k] : facet.open.area;
    integrals(0, column) = weight * sum;
    for (std::size_t c = 0; c < d; ++c)
      integrals(static_cast<Eigen::Index>(c) + 1, column) =
          weight * about(k < d ? facet.open.moment[c][k] : facet.open.first[c], sum, c);
  }
  const Eigen::MatrixXd parts = distribute(carriers, center, body, spacing, integrals);
  const Point loaded = along(middle, 1 / facet.open.area, facet.open.first);
  for (std::size_t k = 0; k < carriers.particle.size(); ++k) {
    const auto row = static_cast<Eigen::Index>(k);
    FaceShare share{carriers.particle[k], loaded, {}, parts(row, static_cast<Eigen::Index>(d))};
    for (std::size_t c = 0; c < d; ++c) share.area[c] = parts(row, static_cast<Eigen::Index>(c));
    if (facing) share.size = dot(share.area, *facing);
    const double most = norm(share.area) + std::abs(share.size);
    if (most > 1e-17 * facet.whole.area) shares.push_back(share);
  }
}

}  // namespace perinox::body
