#include "perinox/mechanics/tangent_check.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Vector.hpp>
#include <cmath>
#include <limits>

#include "assembled_tangent.hpp"
#include "perinox/mechanics/internal_force.hpp"

namespace perinox::mechanics {

namespace {

/// Uniform in [-1, 1], from the particle's id alone (splitmix64): the same field on any number of ranks.
double noise(std::uint64_t seed, GlobalId id, int component) {
  std::uint64_t z = seed * 0x9E3779B97F4A7C15ULL + static_cast<std::uint64_t>(id) * 0xBF58476D1CE4E5B9ULL +
                    static_cast<std::uint64_t>(component + 1) * 0x94D049BB133111EBULL;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
  z ^= z >> 31;
  return 2 * (static_cast<double>(z >> 11) * 0x1.0p-53) - 1;
}

std::vector<double> random_field(const Scene& scene, std::uint64_t seed) {
  const int d = scene.dimension();
  std::vector<double> field(scene.owned_unknowns());
  for (LocalIndex i = 0; i < scene.owned(); ++i)
    for (int c = 0; c < d; ++c) field[static_cast<std::size_t>(i) * d + c] = noise(seed, scene.body().id[i], c);
  return field;
}

double dot(const Scene& scene, const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t u = 0; u < a.size(); ++u) sum += a[u] * b[u];
  return scene.body().communicator.sum(sum);
}

/// Squares of (a - b) and of a, summed over each material's particles: [2 * materials].
std::vector<double> squares_by_material(const Scene& scene, const std::vector<double>& a,
                                        const std::vector<double>& b) {
  const std::size_t count = scene.materials().size();
  std::vector<double> sums(2 * count, 0.0);
  for (std::size_t u = 0; u < a.size(); ++u) {
    const auto m = static_cast<std::size_t>(scene.body().material[u / scene.dimension()]);
    sums[2 * m] += (a[u] - b[u]) * (a[u] - b[u]);
    sums[2 * m + 1] += a[u] * a[u];
  }
  scene.body().communicator.sum(sums);
  return sums;
}

double compare_assembled(const Scene& scene, const StoredTangent& tangent, const std::vector<double>& direction,
                         const std::vector<double>& product) {
  AssembledTangent assembled(scene, std::vector<char>(scene.local_unknowns(), 0));
  assembled.fill(tangent, 1);
  const auto map = medium::unknowns_map(scene.body());
  tpetra::Vector x(map), y(map);
  {
    const auto values = x.getLocalViewHost(Tpetra::Access::OverwriteAll);
    for (std::size_t u = 0; u < direction.size(); ++u) values(u, 0) = direction[u];
  }
  assembled.matrix()->apply(x, y);
  const auto values = y.getLocalViewHost(Tpetra::Access::ReadOnly);
  std::vector<double> other(product.size());
  for (std::size_t u = 0; u < other.size(); ++u) other[u] = values(u, 0) - product[u];
  return std::sqrt(dot(scene, other, other) / dot(scene, product, product));
}

}  // namespace

TangentCheck check_tangent(const Scene& scene, const Committed& committed, const std::vector<double>& displacement,
                           deck::TangentForm form, bool with_assembled, std::uint64_t seed) {
  const auto evaluation = std::make_shared<Evaluation>(scene);
  const std::unique_ptr<Tangent> made = make_tangent(scene, form, evaluation);
  Tangent& tangent = *made;
  tangent.linearise(committed, displacement.data(), form);
  const std::vector<double> v = random_field(scene, seed), w = random_field(scene, seed + 1);
  std::vector<double> kv(v.size()), kw(v.size());
  tangent.apply(v.data(), kv.data());
  tangent.apply(w.data(), kw.data());

  TangentCheck check;
  check.symmetry = std::abs(dot(scene, w, kv) - dot(scene, v, kw)) / std::sqrt(dot(scene, w, w) * dot(scene, kv, kv));
  check.direction = std::numeric_limits<double>::infinity();
  std::vector<double> moved(v.size()), plus(v.size()), minus(v.size()), difference(v.size());
  for (double relative = 1e-3; relative > 5e-9; relative /= 10) {
    const double h = relative * scene.families().horizon;
    Trial trial;
    for (std::size_t u = 0; u < v.size(); ++u) moved[u] = displacement[u] + h * v[u];
    internal_force(*evaluation, committed, moved.data(), trial, plus.data());
    for (std::size_t u = 0; u < v.size(); ++u) moved[u] = displacement[u] - h * v[u];
    internal_force(*evaluation, committed, moved.data(), trial, minus.data());
    for (std::size_t u = 0; u < v.size(); ++u) difference[u] = -(plus[u] - minus[u]) / (2 * h);
    const std::vector<double> sums = squares_by_material(scene, kv, difference);
    double error = 0, size = 0;
    for (std::size_t m = 0; m < sums.size() / 2; ++m) {
      error += sums[2 * m];
      size += sums[2 * m + 1];
    }
    const double ratio = std::sqrt(error / size);
    if (!(ratio < check.direction)) continue;
    check.direction = ratio;
    check.difference_step = relative;
    check.of_material.clear();
    for (std::size_t m = 0; m < sums.size() / 2; ++m)
      check.of_material.push_back(sums[2 * m + 1] > 0 ? std::sqrt(sums[2 * m] / sums[2 * m + 1]) : 0);
  }
  Trial here;
  internal_force(*evaluation, committed, displacement.data(), here, plus.data());
  check.yielding = scene.body().communicator.sum(here.yielding);
  if (with_assembled) {
    StoredTangent stored(scene);
    stored.linearise(committed, displacement.data(), form);
    check.assembled = compare_assembled(scene, stored, v, kv);
  }
  return check;
}

}  // namespace perinox::mechanics
