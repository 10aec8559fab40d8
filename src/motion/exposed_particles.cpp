#include "perinox/motion/exposed_particles.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "perinox/body/spacing.hpp"

namespace perinox::motion {

namespace {

/// Mean of the bonds' directions from which a particle counts as exposed: 0.5 on a flat face, about 0.15 one layer
/// below it at three spacings, at most 0.09 from the scatter of a cloud.
constexpr double lopsided = 0.12;
/// Least eigenvalue of the mean of n (x) n, times d, below which a family is flat: 1 in a full family and on a flat
/// face, 0 where the body is one particle thick, 0.6 in the middle of three layers at three spacings.
constexpr double flat = 0.5;
/// Share of its bonds that a particle has lost.
constexpr double much_damage = 0.25;
/// Share of the ball of the horizon that a family fills. Full families of lattices fill 0.59 of it or more, whatever
/// the horizon.
constexpr double sparse = 0.5;

constexpr double pi = 3.14159265358979323846;

struct Surroundings {
  Eigen::Vector3d lean = Eigen::Vector3d::Zero();
  bool thin = false;  ///< d times the least eigenvalue of the mean of n (x) n is below `flat`
  double filled = 0;  ///< share of the horizon's ball
};

/// True where all eigenvalues of a symmetric matrix are above zero: its leading minors are.
bool positive_definite(const Eigen::Matrix3d& a, int d) {
  const double two = a(0, 0) * a(1, 1) - a(0, 1) * a(1, 0);
  return a(0, 0) > 0 && two > 0 && (d == 2 || a.determinant() > 0);
}

Surroundings look_around(const mechanics::Scene& scene, LocalIndex i, const std::vector<LocalIndex>& neighbors) {
  const body::Body& body = scene.body();
  const int d = scene.dimension();
  Surroundings found;
  Eigen::Matrix3d square = Eigen::Matrix3d::Zero();
  double volume = body.volume[i];
  for (const LocalIndex j : neighbors) {
    Eigen::Vector3d direction = Eigen::Vector3d::Zero();
    for (int c = 0; c < d; ++c) direction(c) = body.position(j)[c] - body.position(i)[c];
    direction.normalize();
    found.lean += direction;
    square += direction * direction.transpose();
    volume += body.volume[j];
  }
  const double horizon = scene.families().horizon;
  found.filled = volume / (d == 3 ? 4 * pi / 3 * horizon * horizon * horizon : pi * horizon * horizon);
  if (neighbors.empty()) return found;
  const auto count = static_cast<double>(neighbors.size());
  found.lean /= count;
  found.thin = !positive_definite(square / count - flat / d * Eigen::Matrix3d::Identity(), d);
  return found;
}

}  // namespace

ExposedParticles find_exposed(const mechanics::Scene& scene) {
  const body::Body& body = scene.body();
  const bonds::BondGraph graph = scene.bond_graph();
  ExposedParticles exposed;
  std::vector<LocalIndex> neighbors;
  for (LocalIndex i = 0; i < scene.owned(); ++i) {
    graph(i, neighbors);
    const Surroundings found = look_around(scene, i, neighbors);
    if (found.lean.norm() <= lopsided && !found.thin && found.filled >= sparse &&
        scene.families().damage[i] <= much_damage)
      continue;
    exposed.particle.push_back(i);
    exposed.lean.push_back({found.lean(0), found.lean(1), found.lean(2)});
    std::vector<GlobalId>& ids = exposed.bonded.emplace_back();
    for (const LocalIndex j : neighbors) ids.push_back(body.id[j]);
    std::sort(ids.begin(), ids.end());
  }
  return exposed;
}

}  // namespace perinox::motion
