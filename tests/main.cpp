/// One main for every test program: MPI and Kokkos come up once, and only rank 0 prints results of passing tests.
#include <gtest/gtest.h>
#include <mpi.h>

#include <Tpetra_Core.hpp>
#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define PERINOX_LEAKS
#endif
#endif
#ifdef PERINOX_LEAKS
#include <sanitizer/lsan_interface.h>
#endif

int main(int argc, char** argv) {
#ifdef PERINOX_LEAKS
  __lsan_disable();  // of what MPI loads and unloads while it starts, no name is left
#endif
  const Tpetra::ScopeGuard guard(&argc, &argv);
#ifdef PERINOX_LEAKS
  __lsan_enable();
#endif
  ::testing::InitGoogleTest(&argc, argv);
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (rank != 0) {
    auto& listeners = ::testing::UnitTest::GetInstance()->listeners();
    delete listeners.Release(listeners.default_result_printer());
  }
  int failed = RUN_ALL_TESTS();
#ifdef PERINOX_LEAKS
  // While MPI's components are still loaded, so that what they keep has names (fuzz/leaks.supp). scripts/sanitize.sh
  // turns the look at the end off.
  if (__lsan_do_recoverable_leak_check() != 0) failed = 1;
#endif
  int failed_anywhere = 0;
  MPI_Allreduce(&failed, &failed_anywhere, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
  return failed_anywhere;
}
