#pragma once

namespace perinox::linear {

/// Why an attempt at a solution failed: in the linear solve, or where it says so in Newton's method around it. `other`
/// may come from either.
enum class Failure {
  none,
  linear_iterations,   ///< a linear solve did not reach its tolerance
  negative_curvature,  ///< the tangent is not positive definite
  not_finite,          ///< a force is infinite or not a number
  no_progress,         ///< Newton: no step length along its direction makes progress
  newton_iterations,   ///< Newton: too many
  other
};

}  // namespace perinox::linear
