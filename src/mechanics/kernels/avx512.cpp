/// The sweeps for machines with avx512: cmake/PerinoxKernels.cmake gives this file its own options.
#define PERINOX_KERNELS avx512
#include "instruction_sets.hpp"
#include "sweeps.hpp"

namespace perinox::mechanics::kernels {
AllSweeps avx512_sweeps() { return {avx512::all_sweeps<LatticeView>(), avx512::all_sweeps<PairView>()}; }
}  // namespace perinox::mechanics::kernels
