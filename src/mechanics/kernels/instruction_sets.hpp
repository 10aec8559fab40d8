#pragma once
#include "views.hpp"

namespace perinox::mechanics::kernels {

struct AllSweeps {
  LatticeSweeps lattice;
  PairSweeps pairs;
};
AllSweeps baseline_sweeps();
AllSweeps avx2_sweeps();  // defined where the compiler can make them
AllSweeps avx512_sweeps();

/// The sweeps for the widest vectors this machine has. PERINOX_INSTRUCTIONS=baseline, avx2 or avx512 in the environment
/// asks for less.
const AllSweeps& sweeps();
/// "avx512", "avx2" or "baseline".
const char* instruction_set();

}  // namespace perinox::mechanics::kernels
