# The sweeps over bonds are compiled once for each instruction set and chosen at run time, so that one binary runs anywhere
# and fast.
set(kernels "${CMAKE_CURRENT_SOURCE_DIR}/src/mechanics/kernels")
# Contracting a*b + c is what the accuracy statements of these files assume. GCC 12 warns of its own AVX-512 header
# (maybe-uninitialized) and of an ABI that only matters across a call that is always inlined (psabi).
set(kernel_options -O3 -ffp-contract=fast -fno-math-errno -fno-trapping-math -Wno-psabi -Wno-maybe-uninitialized
                   -Wno-uninitialized)
set(baseline_options ${kernel_options})
if(PERINOX_SANITIZE)
  # Everything is inlined into the sweeps, and every access brings its checks with it: docs/testing.md has the times. With
  # the address checks as calls and without the pointer checks that these imply, one set of instructions compiles 2.6 times
  # as fast as with all checks. The set that all tests run is optimised; the wider ones compile the same source, are checked
  # for addresses only and run few tests.
  set(kernel_options -ffp-contract=fast -mllvm -asan-instrumentation-with-call-threshold=0)
  set(baseline_options ${kernel_options} -O2 -fno-sanitize=null,alignment,vptr,pointer-overflow -DPERINOX_CHECKED_ACCESS)
  list(APPEND kernel_options -O0 -fno-sanitize=undefined)
endif()
set_source_files_properties("${kernels}/baseline.cpp" "${kernels}/avx2.cpp" "${kernels}/avx512.cpp" PROPERTIES
  SKIP_PRECOMPILE_HEADERS ON)
set_source_files_properties("${kernels}/baseline.cpp" PROPERTIES COMPILE_OPTIONS "${baseline_options}")
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  set_source_files_properties("${kernels}/avx2.cpp" PROPERTIES COMPILE_OPTIONS "${kernel_options};-march=x86-64-v3")
  set_source_files_properties("${kernels}/avx512.cpp" PROPERTIES
    COMPILE_OPTIONS "${kernel_options};-march=x86-64-v4;-mprefer-vector-width=512")
  set_source_files_properties("${kernels}/instruction_sets.cpp" PROPERTIES COMPILE_DEFINITIONS PERINOX_X86_KERNELS)
  set(perinox_unused_kernels "^$")
else()
  set(perinox_unused_kernels "/kernels/avx.*\\.cpp$")
endif()
