#pragma once
/// The first linear system of a deck, and conjugate gradients on it with a preconditioner under test.
#include <fmt/format.h>

#include <functional>
#include <string>

#include "linear/two_level.hpp"
#include "perinox/loads/boundary.hpp"
#include "perinox/mechanics/peridynamic_medium.hpp"
#include "support/decks.hpp"

namespace perinox::test {

/// The undeformed tangent of a deck, with the load of t = 1 on its right side.
struct LinearProblem {
  using Vector = std::vector<double>;

  explicit LinearProblem(const std::string& yaml, MPI_Comm comm = MPI_COMM_SELF)
      : deck(deck_of(yaml)),
        scene(mechanics::build_scene(deck, Communicator(comm))),
        boundary(deck, scene),
        medium(scene),
        tangent(medium.make_tangent(deck::TangentForm::consistent)),
        unknowns(scene.owned_unknowns()),
        blocks(unknowns * static_cast<std::size_t>(scene.dimension())),
        right(unknowns) {
    tangent->linearise(medium.at());
    tangent->diagonal_blocks(blocks.data(), linear::TwoLevel::dilatation_share(scene));
    Vector jump(unknowns, 0.0), stiff(unknowns);
    boundary.impose(1, jump.data());
    boundary.external_force(1, right.data());
    tangent->apply(jump.data(), stiff.data());
    for (std::size_t u = 0; u < unknowns; ++u) right[u] = held(u) ? 0 : right[u] - stiff[u];
  }

  bool held(std::size_t u) const { return boundary.prescribed()[u] != 0; }
  double dot(const Vector& a, const Vector& b) const {
    double sum = 0;
    for (std::size_t u = 0; u < unknowns; ++u) sum += a[u] * b[u];
    return scene.body().communicator.sum(sum);
  }
  std::unique_ptr<linear::TwoLevel> two_level(const linear::TwoLevel::Settings& settings = {}) const {
    auto made = std::make_unique<linear::TwoLevel>(medium::unknowns_map(scene.body()), scene, boundary.prescribed(),
                                                   scene.bond_graph(), settings);
    made->set(blocks, 1.0);
    return made;
  }

  /// Number of iterations until the residual is 1e-8 of the right side.
  int iterations(const linear::OwnedOperator& preconditioner) const {
    Vector r = right, z(unknowns), p(unknowns, 0.0), q(unknowns);
    const double goal = 1e-8 * std::sqrt(dot(right, right));
    double rho = 1;
    int count = 0;
    while (count < 2000 && std::sqrt(dot(r, r)) > goal) {
      preconditioner.multiply(r.data(), z.data());
      const double next = dot(r, z);
      for (std::size_t u = 0; u < unknowns; ++u) p[u] = z[u] + (count > 0 ? next / rho : 0) * p[u];
      rho = next;
      tangent->apply(p.data(), q.data());
      for (std::size_t u = 0; u < unknowns; ++u) q[u] = held(u) ? 0 : q[u];
      const double step = rho / dot(p, q);
      for (std::size_t u = 0; u < unknowns; ++u) r[u] -= step * q[u];
      ++count;
    }
    return count;
  }

  deck::Deck deck;
  mechanics::Scene scene;
  loads::Boundary boundary;
  mechanics::PeridynamicMedium medium;
  std::unique_ptr<medium::Tangent> tangent;
  std::size_t unknowns;
  Vector blocks, right;
};

/// An elastic block of n^3 particles of spacing 1. Three layers are held at each end in z, and the upper ones are
/// pulled. `bodies` replaces the lines of the plain cube in the deck; `more` is added to the deck.
inline std::string held_cube(int n, double poisson = 0.33, const std::string& more = "", std::string bodies = "") {
  if (bodies.empty())
    bodies = fmt::format(
        "  - {{name: cube, shape: {{box: {{min: [0, 0, 0], max: [{0}, {0}, {0}]}}}}, spacing: 1, material: hard}}\n",
        n);
  return fmt::format(R"(
dimension: 3
body:
{}horizon: {{ratio: 3.015}}
materials:
  hard: {{model: elastic, young_modulus: 1000, poisson_ratio: {}}}
  soft: {{model: elastic, young_modulus: 1, poisson_ratio: {}}}
sets: {{foot: {{where: "z < 3"}}, head: {{where: "z > {}"}}}}
boundary:
  - {{set: foot, displacement: {{x: 0, y: 0, z: 0}}}}
  - {{set: head, displacement: {{x: 0, y: 0, z: "0.01*t"}}}}
steps: {{end: 1, count: 1}}
{})",
                     bodies, poisson, poisson, n - 3, more);
}

/// The deck's lines of a crack at half height through half the section.
inline std::string half_crack(int n) {
  return fmt::format("cracks: [{{rectangle: {{corner: [-1, -1, {}], edge1: [{}, 0, 0], edge2: [0, {}, 0]}}}}]\n",
                     n / 2.0 + 0.01, n / 2.0 + 1, n + 2.0);
}

}  // namespace perinox::test
