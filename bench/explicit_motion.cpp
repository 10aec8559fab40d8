/// Time steps of velocity Verlet, one rank: everything of a time step, the return mapping and its commit included.
/// ns_per_bond: CPU time over directed bonds and time steps. A free body of n^3 particles, horizon 3.015 spacings, that
/// stretches along z: slowly (elastic), or so fast that nearly every particle flows in every time step (plastic).
/// aware 1: quadrature position-aware, the default, else whole. cloud 1: places jittered by 0.2 spacings, in random
/// order. contact 1: short-range contact watched, with nothing to touch. damage 1, 2: bonds are looked at after each
/// time step, by critical stretch or by critical bond energy, and none breaks.
///     cmake -S . -B build -DPERINOX_BENCHMARKS=ON && ninja -C build bench_explicit && build/bench_explicit
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <Tpetra_Core.hpp>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>
#include <numeric>
#include <random>
#include <stdexcept>

#include "perinox/deck/read.hpp"
#include "perinox/fracture/bond_breaking.hpp"
#include "perinox/stepping/time_stepper.hpp"

namespace {

using namespace perinox;

struct Case {
  std::int64_t n, plastic, cloud, aware, contact, damage;
  bool operator==(const Case& other) const {
    return n == other.n && plastic == other.plastic && cloud == other.cloud && aware == other.aware &&
           contact == other.contact && damage == other.damage;
  }
};

void write_cloud(const std::string& file, std::int64_t n) {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> jitter(-0.2, 0.2);
  std::vector<std::int64_t> cells(static_cast<std::size_t>(n * n * n));
  std::iota(cells.begin(), cells.end(), 0);
  std::shuffle(cells.begin(), cells.end(), generator);
  std::ofstream out(file);
  out << "x,y,z,volume\n";
  for (const std::int64_t cell : cells) {
    const double x = static_cast<double>(cell % n) + 0.5 + jitter(generator);
    const double y = static_cast<double>(cell / n % n) + 0.5 + jitter(generator);
    const double z = static_cast<double>(cell / n / n) + 0.5 + jitter(generator);
    out << x << ',' << y << ',' << z << ",1\n";
  }
}

deck::Deck read(const Case& c) {
  std::string shape = fmt::format("shape: {{box: {{min: [0, 0, 0], max: [{0}, {0}, {0}]}}}}, spacing: 1", c.n);
  if (c.cloud) {
    const std::string file =
        fmt::format("{}/perinox_bench_{}.csv", std::filesystem::temp_directory_path().string(), c.n);
    write_cloud(file, c.n);
    shape = "shape: {file: " + file + "}";
  }
  // Waves take about 1.6e-7 s a spacing, a time step about 0.5e-7 s: 2e-4 of strain a time step, or 2e-9.
  const char* const laws[] = {"", ", damage: {critical_stretch: 0.1}", ", damage: {critical_bond_energy: 1e3}"};
  const std::string yaml = fmt::format(
      "dimension: 3\nbody: [{{name: cube, {}, material: aluminium}}]\n"
      "horizon: {{length: 3.015}}\nquadrature: {}\ndynamics: explicit\nexplicit: {{{}}}\n"
      "materials: {{aluminium: {{model: {}, density: 2.7e-9, bulk_modulus: 67.5e3, shear_modulus: 25.9e3{}{}}}}}\n"
      "initial_velocity: [{{set: all, velocity: {{z: \"{}*z\"}}}}]\nsteps: {{end: 1, count: 1}}\n",
      shape, c.aware ? "position-aware" : "whole", c.contact ? "contact: {}" : "",
      c.plastic ? "elastic-plastic" : "elastic", c.plastic ? ", yield_stress: {shear: 117.3}" : "", laws[c.damage],
      c.plastic ? "2e3" : "2e-2");
  return deck::read_text(yaml, "bench.yaml", deck::Schema(materials::declarations()));
}

struct Moving {
  explicit Moving(const Case& c)
      : deck(read(c)),
        scene(mechanics::build_scene(deck, Communicator(MPI_COMM_SELF))),
        stepper(deck, scene),
        length(stepper.motion().stable_time_step()) {
    if ((scene.lattice() == nullptr) != (c.cloud != 0)) throw std::logic_error("the body has not the layout meant");
    if (deck.breaks()) breaking = std::make_unique<fracture::BondBreaking>(deck, scene);
    for (int k = 0; k < (c.plastic ? 60 : 3); ++k) step();
  }
  void step() {
    stepper.motion().step(length);
    if (breaking && breaking->break_all(stepper.motion()) > 0) throw std::logic_error("bonds break");
  }
  deck::Deck deck;
  mechanics::Scene scene;
  stepping::TimeStepper stepper;
  std::unique_ptr<fracture::BondBreaking> breaking;
  double length;
};

void time_step(benchmark::State& state) {
  static std::unique_ptr<Moving> kept;
  static Case of{};
  const Case wanted{state.range(0), state.range(1), state.range(2), state.range(3), state.range(4), state.range(5)};
  if (!kept || !(of == wanted)) {
    kept.reset();  // never two at once
    kept = std::make_unique<Moving>(wanted);
    of = wanted;
  }
  for (auto _ : state) kept->step();
  state.counters["ns_per_bond"] =
      benchmark::Counter(static_cast<double>(kept->scene.families().directed) * 1e-9,
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  state.counters["flowing"] = static_cast<double>(kept->stepper.motion().yielding()) / kept->scene.owned();
}

}  // namespace

int main(int argc, char** argv) {
  int shown = 1;
  char** names = argv;
  const Tpetra::ScopeGuard guard(&shown, &names);
  const auto add = [](std::int64_t n, int plastic, int cloud, int aware, int contact, int damage) {
    benchmark::RegisterBenchmark("time_step", time_step)
        ->ArgNames({"n", "plastic", "cloud", "aware", "contact", "damage"})
        ->Args({n, plastic, cloud, aware, contact, damage})
        ->Unit(benchmark::kMillisecond);
  };
  for (const int cloud : {0, 1})
    for (const int n : {30, 64})
      for (const int aware : {0, 1})
        for (const int plastic : {0, 1}) add(n, plastic, cloud, aware, 0, 0);
  add(30, 0, 0, 1, 1, 0);
  for (const int cloud : {0, 1})
    for (const int damage : {1, 2}) add(30, 0, cloud, 0, 0, damage);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
