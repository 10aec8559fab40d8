/// What one core of this machine can do, to hold the sweeps against: memory triad a = b + s c on arrays well beyond the
/// caches, and multiply-adds on the widest vectors, all in registers. Best of several. Ranks start every trial
/// together, so that mpirun -np 2 shows what two busy cores leave each other.
///     build/bench_triad; mpirun -np 2 build/bench_triad
/// Compiled for this machine alone (-march=native).
#include <mpi.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <limits>
#include <vector>

namespace {

#if defined(__AVX512F__)
constexpr int width = 8;
#elif defined(__AVX__)
constexpr int width = 4;
#else
constexpr int width = 2;
#endif
typedef double Vector __attribute__((vector_size(width * 8)));

/// Seconds of the fastest trial, on this rank.
template <class Work>
double fastest(int trials, const Work& work) {
  double best = std::numeric_limits<double>::max();
  for (int trial = 0; trial < trials; ++trial) {
    MPI_Barrier(MPI_COMM_WORLD);
    const auto begin = std::chrono::steady_clock::now();
    work();
    best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  }
  return best;
}

/// Four times the last cache an array, but between 64 and 256 MiB: virtual machines report none, or that of a whole
/// host.
std::size_t array_length() {
  const long cache = std::max({sysconf(_SC_LEVEL3_CACHE_SIZE), sysconf(_SC_LEVEL2_CACHE_SIZE), 0L});
  return std::clamp(4 * static_cast<std::size_t>(cache), std::size_t{64} << 20, std::size_t{256} << 20) /
         sizeof(double);
}

/// GB/s. 24 bytes an entry, as is usual; that a line is read before it is overwritten is not counted.
double triad() {
  const std::size_t length = array_length();
  std::vector<double> a(length, 0.0), b(length, 1.0), c(length, 2.0);
  double scale = 3;
  const double seconds = fastest(10, [&] {
    double* const to = a.data();
    const double *const plus = b.data(), *const times = c.data();
    const double s = scale;
#pragma GCC ivdep
    for (std::size_t i = 0; i < length; ++i) to[i] = plus[i] + s * times[i];
    scale = a[length / 2] - 4;  // 3 again: nothing of a trial can be left out
  });
  return 24e-9 * static_cast<double>(length) / seconds;
}

volatile double seen = 1e-9;

/// GFlop/s, a multiply-add as two. Short trials: some escape whatever else the machine does. Twelve chains hide its
/// latency and fit the registers of every x86.
double multiply_adds() {
  constexpr int chains = 12;
  constexpr long long rounds = 500'000;
  const double seconds = fastest(100, [&] {
    const Vector factor = (1 - seen) - Vector{}, term = seen - Vector{};
    Vector sum[chains];
    for (int k = 0; k < chains; ++k) sum[k] = static_cast<double>(k) - Vector{};
    for (long long round = 0; round < rounds; ++round) {
#pragma GCC unroll 12
      for (int k = 0; k < chains; ++k) sum[k] = sum[k] * factor + term;
    }
    Vector all = {};
    for (int k = 0; k < chains; ++k) all += sum[k];
    seen = 1e-9 + 0 * all[0];
  });
  return 2e-9 * width * chains * static_cast<double>(rounds) / seconds;
}

/// Mean and least over the ranks, on rank 0.
void report(const char* what, double value, const char* unit) {
  int rank = 0, ranks = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  double sum = 0, least = 0;
  MPI_Reduce(&value, &sum, 1, MPI_DOUBLE, MPI_SUM, 0, MPI_COMM_WORLD);
  MPI_Reduce(&value, &least, 1, MPI_DOUBLE, MPI_MIN, 0, MPI_COMM_WORLD);
  if (rank == 0) std::printf("%s %.2f %s a rank (least %.2f)\n", what, sum / ranks, unit, least);
}

}  // namespace

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  int rank = 0, ranks = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  if (rank == 0)
    std::printf("ranks %d, vectors of %d doubles, arrays of %zu MiB\n", ranks, width,
                array_length() * sizeof(double) >> 20);
  report("triad", triad(), "GB/s");
  report("multiply-adds", multiply_adds(), "GFlop/s");
  MPI_Finalize();
  return 0;
}
