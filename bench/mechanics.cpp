/// The loops over bonds, one rank: internal force, linearisation, diagonal blocks, matrix-free product, sparse
/// assembly, sparse product. ns_per_bond: time over directed bonds. A body of n^3 particles, horizon 3.015 spacings,
/// whole neighbours, stretched by 0.1 % (elastic) or by 2 % (every particle flows), after a step that has flowed
/// already. cloud 1: the places jittered by 0.2 spacings and given in random order.
///     cmake -S . -B build -DPERINOX_BENCHMARKS=ON && ninja -C build bench_mechanics && build/bench_mechanics
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <Tpetra_Core.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Vector.hpp>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>
#include <numeric>
#include <random>
#include <stdexcept>

#include "mechanics/assembled_tangent.hpp"
#include "mechanics/matrix_free_tangent.hpp"
#include "perinox/deck/read.hpp"
#include "perinox/mechanics/internal_force.hpp"

namespace {

using namespace perinox;

/// A cube under uniform stretch in z.
struct Cube {
  Cube(int n, bool plastic, bool cloud)
      : scene(mechanics::build_scene(read(n, plastic, cloud), Communicator(MPI_COMM_SELF))),
        evaluation(std::make_shared<mechanics::Evaluation>(scene)),
        committed(scene),
        displacement(scene.owned_unknowns(), 0.0),
        force(scene.owned_unknowns()) {
    if ((scene.lattice() == nullptr) != cloud) throw std::logic_error("the body has not the layout meant");
    const auto stretch_by = [&](double stretch) {
      for (LocalIndex i = 0; i < scene.owned(); ++i)
        displacement[static_cast<std::size_t>(i) * 3 + 2] = stretch * scene.body().position(i)[2];
      displacement_is_new();
      mechanics::internal_force(*evaluation, committed, at(), trial, force.data());
      if (trial.yielding != (plastic ? scene.owned() : 0)) throw std::logic_error("the cube is not in the state meant");
    };
    if (plastic) {
      stretch_by(0.02);
      committed.advance(*evaluation, std::move(trial));
    }
    stretch_by(plastic ? 0.021 : 0.001);
  }

  static deck::Deck read(int n, bool plastic, bool cloud) {
    std::string shape = fmt::format("shape: {{box: {{min: [0, 0, 0], max: [{0}, {0}, {0}]}}}}, spacing: 1", n);
    const std::string file = fmt::format("{}/perinox_bench_{}.csv", std::filesystem::temp_directory_path().string(), n);
    if (cloud) {
      write_cloud(file, n);
      shape = "shape: {file: " + file + "}";
    }
    const std::string yaml = fmt::format(
        "dimension: 3\n"
        "body: [{{name: cube, {}, material: aluminium}}]\n"
        "horizon: {{length: 3.015}}\nquadrature: whole\n"
        "materials: {{aluminium: {{model: {}, bulk_modulus: 67.5e3, shear_modulus: 25.9e3{}}}}}\n",
        shape, plastic ? "elastic-plastic" : "elastic", plastic ? ", yield_stress: {shear: 117.3}" : "");
    return deck::read_text(yaml, "bench.yaml", deck::Schema(materials::declarations()));
  }

  static void write_cloud(const std::string& file, int n) {
    std::mt19937 generator(7);
    std::uniform_real_distribution<double> jitter(-0.2, 0.2);
    std::vector<int> cells(static_cast<std::size_t>(n * n * n));
    std::iota(cells.begin(), cells.end(), 0);
    std::shuffle(cells.begin(), cells.end(), generator);
    std::ofstream out(file);
    out << "x,y,z,volume\n";
    for (const int cell : cells)
      out << cell % n + 0.5 + jitter(generator) << ',' << cell / n % n + 0.5 + jitter(generator) << ','
          << cell / n / n + 0.5 + jitter(generator) << ",1\n";
  }

  void displacement_is_new() { version = medium::new_version(); }
  medium::At at() const { return {displacement.data(), version}; }

  mechanics::Scene scene;
  std::shared_ptr<mechanics::Evaluation> evaluation;
  mechanics::Committed committed;
  std::vector<double> displacement, force;
  std::uint64_t version = 0;
  mechanics::Trial trial;
};

/// The cube of a loop; the last one is kept, because every loop asks several times and a cloud takes seconds to make.
Cube& cube_of(const benchmark::State& state) {
  static std::unique_ptr<Cube> kept;
  static std::vector<std::int64_t> of;
  const std::vector<std::int64_t> wanted{state.range(0), state.range(1), state.range(2)};
  if (of != wanted) {
    kept.reset();  // never two at once
    kept = std::make_unique<Cube>(static_cast<int>(wanted[0]), wanted[1] != 0, wanted[2] != 0);
    of = wanted;
  }
  return *kept;
}

void report(benchmark::State& state, const Cube& cube) {
  state.counters["ns_per_bond"] =
      benchmark::Counter(static_cast<double>(cube.scene.families().directed) * 1e-9,
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void internal_force(benchmark::State& state) {
  Cube& cube = cube_of(state);
  const double first = cube.displacement[0];
  double step = 1e-12;
  for (auto _ : state) {
    cube.displacement[0] = first + step;
    step = -step;
    cube.displacement_is_new();
    mechanics::internal_force(*cube.evaluation, cube.committed, cube.at(), cube.trial, cube.force.data());
  }
  cube.displacement[0] = first;
  cube.displacement_is_new();
  report(state, cube);
}

void linearise(benchmark::State& state) {
  Cube& cube = cube_of(state);
  mechanics::MatrixFreeTangent tangent(cube.scene, cube.evaluation);
  for (auto _ : state) tangent.linearise(cube.committed, cube.at(), deck::TangentForm::consistent);
  report(state, cube);
  state.counters["bytes_per_particle"] = static_cast<double>(tangent.bytes()) / cube.scene.owned();
}

void diagonal_blocks(benchmark::State& state) {
  Cube& cube = cube_of(state);
  mechanics::MatrixFreeTangent tangent(cube.scene, cube.evaluation);
  tangent.linearise(cube.committed, cube.at(), deck::TangentForm::consistent);
  std::vector<double> blocks(cube.scene.owned_unknowns() * 3);
  for (auto _ : state) tangent.diagonal_blocks(blocks.data());
  report(state, cube);
}

void product(benchmark::State& state) {
  Cube& cube = cube_of(state);
  mechanics::MatrixFreeTangent tangent(cube.scene, cube.evaluation);
  tangent.linearise(cube.committed, cube.at(), deck::TangentForm::consistent);
  for (auto _ : state) tangent.apply(cube.displacement.data(), cube.force.data());
  report(state, cube);
}

void assembly(benchmark::State& state) {
  Cube& cube = cube_of(state);
  mechanics::StoredTangent tangent(cube.scene);
  tangent.linearise(cube.committed, cube.at(), deck::TangentForm::consistent);
  mechanics::AssembledTangent assembled(cube.scene, std::vector<char>(cube.scene.local_unknowns(), 0));
  for (auto _ : state) assembled.fill(tangent, 1);
  report(state, cube);
  state.counters["bytes_per_particle"] = 12.0 * static_cast<double>(assembled.nonzeros()) / cube.scene.owned();
}

void assembled_product(benchmark::State& state) {
  Cube& cube = cube_of(state);
  mechanics::StoredTangent tangent(cube.scene);
  tangent.linearise(cube.committed, cube.at(), deck::TangentForm::consistent);
  mechanics::AssembledTangent assembled(cube.scene, std::vector<char>(cube.scene.local_unknowns(), 0));
  assembled.fill(tangent, 1);
  tpetra::Vector x(assembled.matrix()->getDomainMap()), y(assembled.matrix()->getRangeMap());
  x.putScalar(1.0);
  for (auto _ : state) assembled.matrix()->apply(x, y);
  report(state, cube);
}

/// Body by body, so that each is made once.
void register_loops() {
  using Loop = void (*)(benchmark::State&);
  const auto add = [](const char* name, Loop loop, std::int64_t n, int plastic, int cloud) {
    benchmark::RegisterBenchmark(name, loop)
        ->ArgNames({"n", "plastic", "cloud"})
        ->Args({n, plastic, cloud})
        ->Unit(benchmark::kMillisecond);
  };
  for (const int cloud : {0, 1})
    for (const int n : {16, 32, 64, 100})
      for (const int plastic : {0, 1}) {
        if (n == 100 && cloud) continue;
        add("product", product, n, plastic, cloud);
        if (n == 100) continue;
        add("internal_force", internal_force, n, plastic, cloud);
        add("linearise", linearise, n, plastic, cloud);
        add("diagonal_blocks", diagonal_blocks, n, plastic, cloud);
        if (n > 16 || cloud) continue;
        add("assembly", assembly, n, plastic, cloud);
        add("assembled_product", assembled_product, n, plastic, cloud);
      }
}

}  // namespace

int main(int argc, char** argv) {
  int shown = 1;
  char** names = argv;
  const Tpetra::ScopeGuard guard(&shown, &names);
  register_loops();
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
