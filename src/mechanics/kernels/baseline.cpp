/// The sweeps for any machine: cmake/PerinoxKernels.cmake gives this file its own options.
#define PERINOX_KERNELS baseline
#include "instruction_sets.hpp"
#include "sweeps.hpp"

namespace perinox::mechanics::kernels {
AllSweeps baseline_sweeps() { return {baseline::all_sweeps<LatticeView>(), baseline::all_sweeps<PairView>()}; }
}  // namespace perinox::mechanics::kernels
