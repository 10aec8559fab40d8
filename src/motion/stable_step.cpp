#include "perinox/motion/stable_step.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "perinox/linear/lanczos.hpp"
#include "perinox/mechanics/family_loops.hpp"
#include "perinox/mechanics/tangent.hpp"

namespace perinox::motion {

namespace {

constexpr int most_products = 80;
constexpr double accuracy = 0.01;

using Block = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Largest eigenvalue of a symmetric matrix, row-major [n * n].
double largest_of(int n, const double* block) {
  const Eigen::SelfAdjointEigenSolver<Block> solver(Eigen::Map<const Block>(block, n, n), Eigen::EigenvaluesOnly);
  return solver.eigenvalues()[n - 1];
}

/// lambda_i of the header.
double family_stiffness(const mechanics::Scene& scene, const mechanics::Committed& undeformed, LocalIndex i,
                        const mechanics::StrainSums& none) {
  materials::StrainFit fit;
  const materials::FamilySums sums = mechanics::family_sums(scene, undeformed, none, i, {}, {}, fit);
  const materials::PointModulus modulus =
      scene.material(i).modulus(sums, undeformed.point_history(scene, i), deck::TangentForm::consistent);
  const bonds::Moment* moment = scene.families().moment(i);
  if (!moment) return std::max(modulus.shear, modulus.shear + modulus.radial * sums.weighted_volume);
  // The strain's part of the energy is eps : C : eps/2 with C = d kappa P + 2 mu (1 - P), P = I I^T/d, and that of its
  // extensions eps : M : eps.
  const int d = scene.dimension(), n = bonds::mandel_size(d);
  const double mu = scene.material(i).elastic_moduli(d).shear;
  Block root = Block::Identity(n, n) * std::sqrt(2 * mu);
  root.topLeftCorner(d, d).array() += (std::sqrt(d * modulus.bulk) - std::sqrt(2 * mu)) / d;
  const Block product = root * Eigen::Map<const Block>(moment->inverse.data(), n, n) * root;
  return std::max(modulus.shear, largest_of(n, product.data()));
}

}  // namespace

double time_step_safety(const deck::Deck& deck, const mechanics::Scene& scene) {
  if (deck.motion.safety > 0) return deck.motion.safety;
  return scene.plastic() ? 0.5 : 0.8;
}

std::vector<double> particle_masses(const deck::Deck& deck, const mechanics::Scene& scene) {
  const body::Body& body = scene.body();
  std::vector<double> masses(static_cast<std::size_t>(scene.owned()));
  for (const deck::Material& material : deck.materials)
    if (!material.density)
      deck::refuse(material.location,
                   fmt::format("the material {} needs the key density to move in time", material.name));
  for (LocalIndex i = 0; i < scene.owned(); ++i)
    masses[i] = *deck.materials[static_cast<std::size_t>(body.material[i])].density * body.volume[i];
  return masses;
}

std::optional<double> eigenvalue_bound(const mechanics::Scene& scene, const std::vector<double>& masses) {
  if (!scene.from_sums()) return std::nullopt;
  const auto owned = static_cast<std::size_t>(scene.owned());
  const std::size_t moments = scene.families().moments.size();
  const mechanics::Committed undeformed(scene);
  mechanics::StrainSums none;
  none.extension.assign(owned, 0.0);
  none.square.assign(owned, 0.0);
  // The diagonal blocks of bonds with the stiffness lambda, and of nothing else, are the B_i.
  mechanics::TangentLaw law;
  law.radial.assign(owned, 0.0);
  law.mean = law.dilatation = law.flow = law.radial;
  if (mechanics::has_back_stress(scene)) law.yielded = law.radial;
  law.state.assign(moments, {});
  law.slope.assign(moments, {});
  law.modulus.assign(moments, {});
  law.shear.resize(owned);
  for (LocalIndex i = 0; i < scene.owned(); ++i) law.shear[i] = family_stiffness(scene, undeformed, i, none);
  const std::unique_ptr<mechanics::FamilyLoops> loops = mechanics::FamilyLoops::make(scene);
  loops->linearise(undeformed.displacement().data(), law, undeformed.plastic());
  const int d = scene.dimension();
  std::vector<double> blocks(static_cast<std::size_t>(scene.local()) * d * d);
  loops->diagonal_blocks(law, blocks.data());
  scene.body().halo.add_to_owners(blocks.data(), d * d);
  double largest = 0;
  for (LocalIndex i = 0; i < scene.owned(); ++i)
    largest = std::max(largest, 2 * largest_of(d, &blocks[static_cast<std::size_t>(i) * d * d]) / masses[i]);
  return scene.body().communicator.max(largest);
}

double largest_eigenvalue(const mechanics::Scene& scene, const mechanics::Committed& committed,
                          const std::vector<double>& masses, const std::vector<char>& prescribed,
                          std::shared_ptr<mechanics::Evaluation> evaluation) {
  const std::size_t unknowns = scene.owned_unknowns();
  const auto d = static_cast<std::size_t>(scene.dimension());
  const std::unique_ptr<mechanics::Tangent> tangent =
      mechanics::make_tangent(scene, deck::TangentForm::consistent, std::move(evaluation));
  tangent->linearise(committed, committed.at(), deck::TangentForm::consistent);
  std::vector<double> scale(unknowns), start(unknowns), x(unknowns);
  for (std::size_t u = 0; u < unknowns; ++u) {
    scale[u] = prescribed[u] ? 0 : 1 / std::sqrt(masses[u / d]);
    start[u] = scale[u] > 0 ? linear::scatter(scene.body().id[u / d], static_cast<int>(u % d)) : 0;
  }
  const auto product = [&](const std::vector<double>& v, std::vector<double>& w) {
    for (std::size_t u = 0; u < unknowns; ++u) x[u] = scale[u] * v[u];
    tangent->apply(x.data(), w.data());
    for (std::size_t u = 0; u < unknowns; ++u) w[u] *= scale[u];
  };
  const linear::Ritz ritz =
      linear::largest_eigenvalue(scene.body().communicator, start, product, {}, {most_products, accuracy});
  return std::max(0.0, ritz.value + ritz.residual);
}

}  // namespace perinox::motion
