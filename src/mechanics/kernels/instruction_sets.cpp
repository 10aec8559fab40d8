#include "instruction_sets.hpp"

#include <cstdlib>
#include <string>

namespace perinox::mechanics::kernels {

namespace {

struct Choice {
  const char* name;
  AllSweeps sweeps;
};

Choice choose() {
#if defined(PERINOX_X86_KERNELS)
  const char* asked = std::getenv("PERINOX_INSTRUCTIONS");
  const std::string most = asked ? asked : "avx512";
  const bool avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  const bool avx512 = avx2 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
                      __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw");
  if (avx512 && most == "avx512") return {"avx512", avx512_sweeps()};
  if (avx2 && most != "baseline") return {"avx2", avx2_sweeps()};
#endif
  return {"baseline", baseline_sweeps()};
}

const Choice& chosen() {
  static const Choice choice = choose();
  return choice;
}

}  // namespace

const AllSweeps& sweeps() { return chosen().sweeps; }
const char* instruction_set() { return chosen().name; }

}  // namespace perinox::mechanics::kernels
