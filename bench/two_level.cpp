/// Counts and costs of the two-level preconditioner: conjugate gradients to 1e-8 at the undeformed tangent.
///     build/bench_two_level <scene> <n> [key=value ...]
/// scenes: cube, perforated, jittered, crack, contrast, plate-strain, plate-stress, points, bar and sheet (held at one
/// end, eight particles thick). keys: nu, cell (edge over horizon), level (1: block Jacobi only), bulk_limit, spring,
/// weight, ratio (horizon over spacing), dilatation (share of it in D), smoothing (degree), direct (coarse unknowns
/// that are factorised), fitted (1: quadrature: position-aware), steps (products an iteration, odd).
#include "linear/two_level.hpp"

#include <fmt/format.h>

#include <Tpetra_Core.hpp>
#include <chrono>
#include <cmath>
#include <fstream>
#include <map>
#include <random>

#include "linear/chebyshev_acceleration.hpp"
#include "linear/masked_tangent.hpp"
#include "mechanics/assembled_tangent.hpp"
#include "perinox/deck/read.hpp"
#include "perinox/loads/boundary.hpp"
#include "perinox/materials/material.hpp"
#include "perinox/mechanics/peridynamic_medium.hpp"

namespace {

using namespace perinox;
using Vector = std::vector<double>;

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

struct Options {
  std::map<std::string, std::string> words;
  double number(const std::string& key, double fallback) const {
    const auto found = words.find(key);
    return found == words.end() ? fallback : std::stod(found->second);
  }
};

std::string cloud_file(int n) {
  const std::string path = fmt::format("bench_cloud_{}.csv", n);
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> jitter(-0.2, 0.2);
  std::ofstream file(path);
  file.precision(17);
  file << "x,y,z,volume\n";
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
        file << i + 0.5 + jitter(generator) << ',' << j + 0.5 + jitter(generator) << ',' << k + 0.5 + jitter(generator)
             << ",1\n";
  return path;
}

deck::Deck make_deck(const std::string& scene, int n, const Options& options) {
  const bool flat = scene.rfind("plate", 0) == 0;
  const std::string box = fmt::format("{{box: {{min: [0, 0, 0], max: [{0}, {0}, {0}]}}}}", n);
  std::string shape = box, more, held = "x: 0, y: 0, z: 0", pulled = "x: 0, y: 0, z: \"0.01*t\"";
  std::string body = "spacing: 1", second, boundary;
  const char axis = flat ? 'y' : 'z';
  if (flat) {
    shape = fmt::format("{{box: {{min: [0, 0], max: [{0}, {0}]}}}}", n);
    held = "x: 0, y: 0";
    pulled = "x: 0, y: \"0.01*t\"";
  }
  if (scene == "perforated") {
    shape = "{difference: [" + box;
    for (const double a : {0.25, 0.75})
      for (const double b : {0.25, 0.75})
        shape += fmt::format(", {{cylinder: {{start: [{0}, -1, {1}], end: [{0}, {2}, {1}], radius: {3}}}}}", a * n,
                             b * n, n + 1, 0.14 * n);
    shape += "]}";
  }
  if (scene == "jittered") {
    shape = fmt::format("{{file: {}}}", cloud_file(n));
    body = "spacing: 1";
  }
  if (scene == "crack")
    more = fmt::format("cracks: [{{rectangle: {{corner: [-1, -1, {0}], edge1: [{1}, 0, 0], edge2: [0, {2}, 0]}}}}]\n",
                       n / 2.0 + 0.01, n / 2.0 + 1, n + 2.0);
  if (scene == "contrast") {
    shape = fmt::format("{{box: {{min: [0, 0, 0], max: [{0}, {0}, {1}]}}}}", n, n / 2);
    second = fmt::format(
        "\n  - {{name: soft, shape: {{box: {{min: [0, 0, {1}], max: [{0}, {0}, {0}]}}}}, spacing: 1, material: soft}}",
        n, n / 2);
  }
  boundary = fmt::format(
      "sets: {{foot: {{where: \"{0} < 3\"}}, head: {{where: \"{0} > {1}\"}}}}\n"
      "boundary:\n  - {{set: foot, displacement: {{{2}}}}}\n  - {{set: head, displacement: {{{3}}}}}\n",
      axis, n - 3, held, pulled);
  if (scene == "bar" || scene == "sheet") {
    shape = fmt::format("{{box: {{min: [0, 0, 0], max: [{}, {}, 8]}}}}", n, scene == "bar" ? 8 : n);
    boundary =
        "sets: {foot: {where: \"x < 3\"}}\n"
        "boundary:\n  - {set: foot, displacement: {x: 0, y: 0, z: 0}}\n  - {set: all, force: {z: \"t\"}}\n";
  }
  if (scene == "points")
    boundary = fmt::format(
        "sets: {{a: {{ids: [0, {0}, {1}, {2}]}}}}\n"
        "boundary:\n  - {{set: a, displacement: {{x: 0, y: 0, z: 0}}}}\n  - {{set: all, force: {{z: \"t\"}}}}\n",
        n - 1, n * (n - 1), n * n * (n - 1) + n / 2);
  const std::string yaml = fmt::format(
      "dimension: {}\nbody:\n  - {{name: cube, shape: {}, {}, material: hard}}{}\nhorizon: {{ratio: {}}}\nquadrature: "
      "{}\n"
      "materials:\n  hard: {{model: elastic, young_modulus: {}, poisson_ratio: {}}}\n{}{}{}steps: {{end: 1, count: "
      "1}}\n",
      flat ? scene.substr(6) == "strain" ? "plane-strain" : "plane-stress" : "3", shape, body, second,
      options.number("ratio", 3.015), options.number("fitted", 0) == 1 ? "position-aware" : "whole",
      scene == "contrast" ? options.number("contrast", 1000) : 1.0, options.number("nu", 0.33),
      scene == "contrast"
          ? fmt::format("  soft: {{model: elastic, young_modulus: 1, poisson_ratio: {}}}\n", options.number("nu", 0.33))
          : "",
      more, boundary);
  return deck::read_text(yaml, "bench.yaml", materials::full_schema());
}

linear::TwoLevel::Settings settings_of(const Options& options) {
  linear::TwoLevel::Settings settings;
  settings.cell = options.number("cell", settings.cell);
  settings.finer_cell = options.number("cell", settings.finer_cell);
  settings.bulk_limit = options.number("bulk_limit", settings.bulk_limit);
  settings.spring = options.number("spring", settings.spring);
  settings.weight = options.number("weight", settings.weight);
  settings.smoothing = static_cast<int>(options.number("smoothing", settings.smoothing));
  settings.factorised_up_to =
      static_cast<long long>(options.number("direct", static_cast<double>(settings.factorised_up_to)));
  return settings;
}

/// Iterations, and seconds in all of them.
struct Counted {
  int iterations = 0;
  double product = 0, transfer = 0, coarse = 0, whole = 0;
};

/// Conjugate gradients on the first system of the load at t = 1, to 1e-8 of the right side.
Counted solve(const medium::Tangent& tangent, const loads::Boundary& boundary, const Communicator& ranks,
              const linear::TwoLevel& two_level, const linear::OwnedOperator& preconditioner, std::size_t unknowns) {
  const std::vector<char>& fixed = boundary.prescribed();
  const auto dot = [&](const Vector& a, const Vector& b) {
    double sum = 0;
    for (std::size_t u = 0; u < unknowns; ++u) sum += a[u] * b[u];
    return ranks.sum(sum);
  };
  Vector x(unknowns, 0.0), r(unknowns), jump(unknowns, 0.0), z(unknowns), p(unknowns), q(unknowns);
  boundary.impose(1, jump.data());
  boundary.external_force(1, r.data());
  tangent.apply(jump.data(), q.data());
  for (std::size_t u = 0; u < unknowns; ++u) r[u] = fixed[u] ? 0 : r[u] - q[u];
  const double goal = 1e-8 * std::sqrt(dot(r, r));
  double rho = 0;
  Counted counted;
  while (counted.iterations < 3000 && std::sqrt(dot(r, r)) > goal) {
    const double before = now();
    preconditioner.multiply(r.data(), z.data());
    counted.whole += now() - before;
    counted.transfer += two_level.transfer_seconds();
    counted.coarse += two_level.solve_seconds();
    const double next = dot(r, z);
    for (std::size_t u = 0; u < unknowns; ++u) p[u] = z[u] + (counted.iterations > 0 ? next / rho * p[u] : 0);
    rho = next;
    const double from = now();
    tangent.apply(p.data(), q.data());
    counted.product += now() - from;
    for (std::size_t u = 0; u < unknowns; ++u)
      if (fixed[u]) q[u] = 0;
    const double step = rho / dot(p, q);
    for (std::size_t u = 0; u < unknowns; ++u) {
      x[u] += step * p[u];
      r[u] -= step * q[u];
    }
    ++counted.iterations;
  }
  return counted;
}

void run(int argc, char** argv) {
  const std::string name = argv[1];
  const int n = std::stoi(argv[2]);
  Options options;
  std::string all;
  for (int a = 3; a < argc; ++a) {
    const std::string word = argv[a];
    all += word + " ";
    options.words[word.substr(0, word.find('='))] = word.substr(word.find('=') + 1);
  }
  const Communicator ranks(MPI_COMM_WORLD);
  const deck::Deck deck = make_deck(name, n, options);
  mechanics::Scene scene = mechanics::build_scene(deck, ranks);
  mechanics::PeridynamicMedium body(scene);
  const loads::Boundary boundary(deck, scene);
  const std::vector<char>& fixed = boundary.prescribed();
  const auto tangent = body.make_tangent(deck::TangentForm::consistent);
  tangent->linearise(body.at());
  Vector blocks(scene.owned_unknowns() * static_cast<std::size_t>(scene.dimension()));
  tangent->diagonal_blocks(blocks.data(), options.number("dilatation", linear::TwoLevel::dilatation_share(scene)));

  const double start = now();
  linear::TwoLevel two_level(medium::unknowns_map(scene.body()), scene, fixed, scene.bond_graph(),
                             settings_of(options));
  const double gridded = now();
  two_level.set(blocks, 1.0);
  const double built = now();
  const int steps = static_cast<int>(options.number("steps", 1));
  const linear::MaskedTangent masked(two_level.getDomainMap(), *tangent, fixed);
  linear::ChebyshevAcceleration accelerated(two_level.getDomainMap(), scene.body(), fixed, masked, two_level, steps);
  if (steps > 1) accelerated.estimate();
  const linear::OwnedOperator* preconditioner = &two_level;
  if (options.number("level", 2) == 1)
    preconditioner = &two_level.block_jacobi();
  else if (steps > 1)
    preconditioner = &accelerated;

  const Counted c = solve(*tangent, boundary, ranks, two_level, *preconditioner, scene.owned_unknowns());
  if (ranks.is_root())
    fmt::print(
        "{:12} {:3} {:24} {:4} its; coarse {:6}; each: product {:.4f}, apply {:.4f} (P {:.4f}, solve {:.4f}); "
        "grid {:.3f}, set {:.3f} s; {:.1f} MB factors, {:.1f} B/particle grid\n",
        name, n, all, c.iterations, two_level.coarse_solver()->unknowns(), c.product / c.iterations,
        c.whole / c.iterations, c.transfer / c.iterations, c.coarse / c.iterations, gridded - start, built - gridded,
        static_cast<double>(two_level.coarse_solver()->bytes()) / 1e6,
        static_cast<double>(two_level.grid().bytes()) / scene.owned());
}

}  // namespace

int main(int argc, char** argv) {
  Tpetra::ScopeGuard guard(&argc, &argv);
  run(argc, argv);
}
