/// The sweeps for machines with avx2: cmake/PerinoxKernels.cmake gives this file its own options.
#define PERINOX_KERNELS avx2
#include "instruction_sets.hpp"
#include "sweeps.hpp"

namespace perinox::mechanics::kernels {
AllSweeps avx2_sweeps() { return {avx2::all_sweeps<LatticeView>(), avx2::all_sweeps<PairView>()}; }
}  // namespace perinox::mechanics::kernels
