#pragma once
#include <array>
#include <vector>

#include "perinox/mechanics/scene.hpp"

namespace perinox::motion {

/// The particles at which a body can be touched, of the owned ones: those whose intact bonds lean to one side, as at a
/// surface or a crack; lie in a plane or on a line, as in a body one particle thick; or are few. All of it follows from
/// the particle's own family, so that nothing far away changes the answer.
struct ExposedParticles {
  std::vector<LocalIndex> particle;           ///< ascending
  std::vector<std::vector<GlobalId>> bonded;  ///< of each: who it shares an intact bond with, ascending
  std::vector<std::array<double, 3>> lean;    ///< of each: mean of its bonds' reference directions; zero without bonds
};
ExposedParticles find_exposed(const mechanics::Scene& scene);

}  // namespace perinox::motion
