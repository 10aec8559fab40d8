#pragma once
#include <vector>

#include "perinox/mechanics/state.hpp"

namespace perinox::fracture {

/// What the breaking of bonds reads of a body in motion, right after a time step.
class MovingState {
 public:
  virtual ~MovingState() = default;

  /// The present state as a committed one. It may have to be brought up to date, which costs time. Collective.
  virtual const mechanics::Committed& committed() = 0;
  /// Present displacement [local * dimension], ghosts up to date: length.
  virtual const std::vector<double>& displacement() const = 0;
  /// Force states of the present state, as mechanics::force_states has them: [owned * (2 + mandel_size)].
  virtual void force_states(double* points) const = 0;
  /// Called where bonds have broken: forces and contacts jump.
  virtual void bonds_have_broken() = 0;
  /// Called where the boundary has let particles go: they stop.
  virtual void supports_have_changed() = 0;
  /// Plastic extension of the present state.
  virtual const mechanics::PlasticExtension& plastic() const = 0;
};

}  // namespace perinox::fracture
