/// libFuzzer's side of a harness: PERINOX_FUZZ_TARGET is the name of one of perinox::fuzz::targets().
#include <mpi.h>
#include <sanitizer/lsan_interface.h>

#include <cstdint>

#include "targets.hpp"

extern "C" int LLVMFuzzerInitialize(int* count, char*** arguments) {
  // What MPI and HDF5 allocate once, at their start and at the first file, stays to the end.
  const __lsan::ScopedDisabler disabled;
  MPI_Init(count, arguments);
  perinox::fuzz::PERINOX_FUZZ_TARGET("C");
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  perinox::fuzz::PERINOX_FUZZ_TARGET(std::string(reinterpret_cast<const char*>(data), size));
  return 0;
}
