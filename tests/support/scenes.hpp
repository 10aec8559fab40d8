#pragma once
/// Small scenes made in C++ with the real rooms body and bonds, displacement fields on them, and the vectors that the
/// room mechanics returns. With one rank the owned particles are all particles, in the order of their ids.
#include <unistd.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "mechanics/matrix_free_tangent.hpp"
#include "perinox/mechanics/internal_force.hpp"
#include "mechanics/stored_tangent.hpp"

namespace perinox::test {

using Vector = std::vector<double>;
using Materials = std::vector<std::unique_ptr<materials::Material>>;
using Matrix = std::array<std::array<double, 3>, 3>;

template <class... Pointers>
Materials materials_of(Pointers... pointers) {
  Materials list;
  (list.push_back(std::move(pointers)), ...);
  return list;
}

/// Adds a box of lattice particles. Its material is named `material_<index>`.
inline void add_box(deck::Deck& deck, const deck::Point& min, const deck::Point& max, double spacing, int material) {
  deck::BodyPart part;
  part.name = "body_" + std::to_string(deck.body.size());
  part.shape.form = deck::Box{min, max};
  part.spacing = spacing;
  part.material = "material_" + std::to_string(material);
  deck.body.push_back(part);
}

/// An empty deck with `count` materials, which the caller hands ready-made to make_scene. The quadrature is `whole`,
/// unless a test sets another.
inline deck::Deck empty_deck(deck::Dimension dimension, double horizon, std::size_t count = 1) {
  deck::Deck deck;
  deck.file = "scene.yaml";
  deck.dimension = dimension;
  deck.horizon.length = horizon;
  deck.quadrature = deck::Quadrature::whole;
  for (std::size_t m = 0; m < count; ++m) {
    deck::Material material;
    material.name = "material_" + std::to_string(m);
    deck.materials.push_back(material);
  }
  return deck;
}

/// A deck with one box of counts[0] x counts[1] (x counts[2]) lattice particles with a corner at the origin.
inline deck::Deck lattice_deck(deck::Dimension dimension, const std::array<int, 3>& counts, double spacing,
                               double horizon_ratio) {
  deck::Deck deck = empty_deck(dimension, horizon_ratio * spacing);
  const bool flat = deck::unknowns(dimension) == 2;
  add_box(deck, {0, 0, 0}, {counts[0] * spacing, counts[1] * spacing, flat ? 0 : counts[2] * spacing}, spacing, 0);
  return deck;
}

/// A deck with one body of given points, rows of x, y, z, volume. They are written to a file, which make_scene reads
/// and remove_cloud removes.
inline deck::Deck cloud_deck(const std::vector<std::array<double, 4>>& points, double horizon) {
  const auto path = std::filesystem::temp_directory_path() / ("perinox_cloud_" + std::to_string(::getpid()) + ".csv");
  std::ofstream file(path);
  file.precision(std::numeric_limits<double>::max_digits10);
  file << "x,y,z,volume\n";
  for (const auto& p : points) file << p[0] << ',' << p[1] << ',' << p[2] << ',' << p[3] << '\n';
  deck::Deck deck = empty_deck(deck::Dimension::three, horizon);
  deck::BodyPart part;
  part.name = "cloud";
  part.shape.form = deck::CloudFile{path.string()};
  part.material = "material_0";
  deck.body.push_back(part);
  return deck;
}

inline void remove_cloud(const deck::Deck& deck) {
  std::filesystem::remove(std::get<deck::CloudFile>(deck.body.at(0).shape.form).path);
}

inline mechanics::Scene make_scene(const deck::Deck& deck, Materials materials,
                                   mechanics::Layout layout = mechanics::Layout::automatic) {
  const Communicator communicator;
  const double horizon = body::horizon_length(deck, communicator);
  const double reach = bonds::reach(deck, horizon, body::largest_spacing(deck, communicator));
  body::Body body = body::build(deck, communicator, reach);
  return mechanics::Scene(deck, std::move(body), horizon, std::move(materials), layout);
}

// --- displacement fields --------------------------------------------------------------------------------------------

/// The field u = (F - I) X, with the first d rows and columns of F.
inline Vector affine_field(const mechanics::Scene& scene, const Matrix& gradient) {
  const int d = scene.dimension();
  Vector field(scene.owned_unknowns());
  for (LocalIndex i = 0; i < scene.owned(); ++i)
    for (int c = 0; c < d; ++c) {
      double sum = -scene.body().position(i)[c];
      for (int k = 0; k < d; ++k) sum += gradient[c][k] * scene.body().position(i)[k];
      field[static_cast<std::size_t>(i) * d + c] = sum;
    }
  return field;
}

inline Vector random_field(const mechanics::Scene& scene, double amplitude, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> entry(-amplitude, amplitude);
  Vector field(scene.owned_unknowns());
  for (double& value : field) value = entry(generator);
  return field;
}

/// The vector a + s b.
inline Vector sum(const Vector& a, double s, const Vector& b) {
  Vector result(a);
  for (std::size_t u = 0; u < a.size(); ++u) result[u] += s * b[u];
  return result;
}
inline double dot(const Vector& a, const Vector& b) {
  double result = 0;
  for (std::size_t u = 0; u < a.size(); ++u) result += a[u] * b[u];
  return result;
}
inline double norm(const Vector& a) { return std::sqrt(dot(a, a)); }

inline Matrix product(const Matrix& a, const Matrix& b) {
  Matrix c{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k) c[i][j] += a[i][k] * b[k][j];
  return c;
}
/// Rotation about z, then (in 3-D) about x, by the same angle in degrees.
inline Matrix rotation(double degrees, int dimension) {
  const double a = degrees * std::acos(-1.0) / 180, c = std::cos(a), s = std::sin(a);
  const Matrix about_z{{{c, -s, 0}, {s, c, 0}, {0, 0, 1}}};
  const Matrix about_x{{{1, 0, 0}, {0, c, -s}, {0, s, c}}};
  return dimension == 2 ? about_z : product(about_x, about_z);
}

// --- answers of the room mechanics ----------------------------------------------------------------------------------

struct Answer {
  Vector force;
  mechanics::Trial trial;
};

inline Answer internal_force(const mechanics::Scene& scene, const mechanics::Committed& committed,
                             const Vector& displacement) {
  Answer answer;
  answer.force.assign(displacement.size(), std::nan(""));
  mechanics::Evaluation evaluation(scene);
  mechanics::internal_force(evaluation, committed, displacement.data(), answer.trial, answer.force.data());
  return answer;
}

inline void commit(const mechanics::Scene& scene, mechanics::Committed& committed, mechanics::Trial trial) {
  mechanics::Evaluation evaluation(scene);
  committed.advance(evaluation, std::move(trial));
}

/// The state after the displacements of `path` have been imposed and committed one after the other, without
/// equilibrium.
inline mechanics::Committed committed_after(const mechanics::Scene& scene, const std::vector<Vector>& path) {
  mechanics::Committed committed(scene);
  for (const Vector& displacement : path)
    commit(scene, committed, internal_force(scene, committed, displacement).trial);
  return committed;
}

inline Vector times(const mechanics::Tangent& tangent, const Vector& x) {
  Vector y(x.size(), std::nan(""));
  tangent.apply(x.data(), y.data());
  return y;
}

/// Relative error of the tangent along `direction` (largest entry 1) against central differences of the internal force.
/// It is the smallest over steps from 1e-3 to 1e-8 horizons: truncation spoils the large steps, rounding the small
/// ones.
inline double tangent_error(const mechanics::Scene& scene, const mechanics::Committed& committed,
                            const Vector& displacement, const Vector& direction, const mechanics::Tangent& tangent) {
  const Vector found = times(tangent, direction);
  double best = std::numeric_limits<double>::infinity();
  for (double relative = 1e-3; relative > 5e-9; relative /= std::sqrt(10.0)) {
    const double step = relative * scene.families().horizon;
    const Vector forward = internal_force(scene, committed, sum(displacement, step, direction)).force;
    const Vector backward = internal_force(scene, committed, sum(displacement, -step, direction)).force;
    Vector error(found.size()), quotient(found.size());
    for (std::size_t u = 0; u < found.size(); ++u) {
      quotient[u] = -(forward[u] - backward[u]) / (2 * step);
      error[u] = found[u] - quotient[u];
    }
    const double ratio = norm(error) / norm(quotient);
    if (ratio < best) best = ratio;
  }
  return best;
}

/// The asymmetry |x.Ky - y.Kx| over |x| |Ky|.
inline double asymmetry(const mechanics::Tangent& tangent, const Vector& x, const Vector& y) {
  const Vector kx = times(tangent, x), ky = times(tangent, y);
  return std::abs(dot(x, ky) - dot(y, kx)) / (norm(x) * norm(ky));
}

}  // namespace perinox::test
