/// The loops over bonds, one rank: internal force, linearisation, matrix-free product, sparse assembly, sparse product.
/// ns_per_bond: time over directed bonds. A cube of n^3 particles, horizon 3.015 spacings, whole neighbours, stretched
/// by 0.1 % (elastic) or by 2 % (every particle flows).
///     cmake -S . -B build -DPERINOX_BENCHMARKS=ON && ninja -C build bench_mechanics && build/bench_mechanics
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <Tpetra_Core.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Vector.hpp>
#include <memory>
#include <stdexcept>

#include "perinox/deck/read.hpp"
#include "perinox/mechanics/assembled_tangent.hpp"
#include "perinox/mechanics/internal_force.hpp"
#include "perinox/mechanics/matrix_free_tangent.hpp"

namespace {

using namespace perinox;

/// A cube under uniform stretch in z.
struct Cube {
  Cube(int n, bool plastic)
      : scene(mechanics::build_scene(read(n), Communicator(MPI_COMM_SELF))),
        committed(scene),
        displacement(scene.owned_unknowns(), 0.0),
        force(scene.owned_unknowns()) {
    const double stretch = plastic ? 0.02 : 0.001;
    for (LocalIndex i = 0; i < scene.owned(); ++i)
      displacement[static_cast<std::size_t>(i) * 3 + 2] = stretch * scene.body().position(i)[2];
    mechanics::internal_force(scene, committed, displacement.data(), trial, force.data());
    if (trial.yielding != (plastic ? scene.owned() : 0)) throw std::logic_error("the cube is not in the state meant");
  }

  static deck::Deck read(int n) {
    const std::string yaml = fmt::format(R"(
dimension: 3
body: [{{name: cube, shape: {{box: {{min: [0, 0, 0], max: [{0}, {0}, {0}]}}}}, spacing: 1, material: aluminium}}]
horizon: {{ratio: 3.015}}
materials:
  aluminium: {{model: elastic-plastic, bulk_modulus: 67.5e3, shear_modulus: 25.9e3, yield_stress: {{shear: 117.3}}}}
)",
                                         n);
    return deck::read_text(yaml, "bench.yaml", deck::Schema(materials::declarations()));
  }

  mechanics::Scene scene;
  mechanics::Committed committed;
  std::vector<double> displacement, force;
  mechanics::Trial trial;
};

void report(benchmark::State& state, const Cube& cube) {
  state.counters["ns_per_bond"] =
      benchmark::Counter(static_cast<double>(cube.scene.families().directed) * 1e-9,
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void internal_force(benchmark::State& state) {
  Cube cube(static_cast<int>(state.range(0)), state.range(1) != 0);
  for (auto _ : state)
    mechanics::internal_force(cube.scene, cube.committed, cube.displacement.data(), cube.trial, cube.force.data());
  report(state, cube);
}

void linearise(benchmark::State& state) {
  Cube cube(static_cast<int>(state.range(0)), state.range(1) != 0);
  mechanics::MatrixFreeTangent tangent(cube.scene);
  for (auto _ : state) tangent.linearise(cube.committed, cube.displacement.data(), deck::TangentForm::consistent);
  report(state, cube);
  state.counters["bytes_per_particle"] = static_cast<double>(tangent.bytes()) / cube.scene.owned();
}

void product(benchmark::State& state) {
  Cube cube(static_cast<int>(state.range(0)), state.range(1) != 0);
  mechanics::MatrixFreeTangent tangent(cube.scene);
  tangent.linearise(cube.committed, cube.displacement.data(), deck::TangentForm::consistent);
  for (auto _ : state) tangent.apply(cube.displacement.data(), cube.force.data());
  report(state, cube);
}

void assembly(benchmark::State& state) {
  Cube cube(static_cast<int>(state.range(0)), state.range(1) != 0);
  mechanics::StoredTangent tangent(cube.scene);
  tangent.linearise(cube.committed, cube.displacement.data(), deck::TangentForm::consistent);
  mechanics::AssembledTangent assembled(cube.scene, std::vector<char>(cube.scene.local_unknowns(), 0));
  for (auto _ : state) assembled.fill(tangent, 1);
  report(state, cube);
  state.counters["bytes_per_particle"] = 12.0 * static_cast<double>(assembled.nonzeros()) / cube.scene.owned();
}

void assembled_product(benchmark::State& state) {
  Cube cube(static_cast<int>(state.range(0)), state.range(1) != 0);
  mechanics::StoredTangent tangent(cube.scene);
  tangent.linearise(cube.committed, cube.displacement.data(), deck::TangentForm::consistent);
  mechanics::AssembledTangent assembled(cube.scene, std::vector<char>(cube.scene.local_unknowns(), 0));
  assembled.fill(tangent, 1);
  tpetra::Vector x(assembled.matrix()->getDomainMap()), y(assembled.matrix()->getRangeMap());
  x.putScalar(1.0);
  for (auto _ : state) assembled.matrix()->apply(x, y);
  report(state, cube);
}

const std::vector<std::vector<std::int64_t>> cases{{16}, {0, 1}};
BENCHMARK(internal_force)->ArgsProduct(cases)->ArgNames({"n", "plastic"})->Unit(benchmark::kMillisecond);
BENCHMARK(linearise)->ArgsProduct(cases)->ArgNames({"n", "plastic"})->Unit(benchmark::kMillisecond);
BENCHMARK(product)->ArgsProduct(cases)->ArgNames({"n", "plastic"})->Unit(benchmark::kMillisecond);
BENCHMARK(assembly)->ArgsProduct(cases)->ArgNames({"n", "plastic"})->Unit(benchmark::kMillisecond);
BENCHMARK(assembled_product)->ArgsProduct(cases)->ArgNames({"n", "plastic"})->Unit(benchmark::kMillisecond);

}  // namespace

int main(int argc, char** argv) {
  int shown = 1;
  char** names = argv;
  const Tpetra::ScopeGuard guard(&shown, &names);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
