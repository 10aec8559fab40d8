#pragma once
#include <cstdint>
#include <vector>

#include "perinox/mechanics/state.hpp"

namespace perinox::mechanics {

/// How well the tangent agrees with the internal force it should be the derivative of. Relative errors.
struct TangentCheck {
  double direction = 0;             ///< |K v - dF/dv| over |K v|, best of a sweep of difference steps
  std::vector<double> of_material;  ///< the same over the particles of one material; [materials]
  double difference_step = 0;       ///< the step that was best, over the horizon
  double symmetry = 0;              ///< |x.Ky - y.Kx| over |x||Ky|
  double assembled = -1;            ///< |K v - A v| over |K v| with the sparse matrix A; -1: not compared
  long long yielding = 0;           ///< particles that flow at this state, over all ranks
};

/// Checks K at displacement [owned * dimension] from the committed state, in a random direction that does not depend on
/// the number of ranks. Central differences of the whole internal force, return mapping included. Collective.
TangentCheck check_tangent(const Scene& scene, const Committed& committed, const std::vector<double>& displacement,
                           deck::TangentForm form, bool with_assembled, std::uint64_t seed = 1);

}  // namespace perinox::mechanics
