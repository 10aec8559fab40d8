#pragma once
#include <memory>
#include <string>
#include <vector>

#include "perinox/equilibrium/newton.hpp"
#include "perinox/linear/linear_solve.hpp"
#include "perinox/medium/medium.hpp"

namespace perinox::equilibrium {

/// The force balance of one medium in one step: internal plus external force on the free unknowns, its tangent, and
/// what a residual is judged against. Plain, bordered and descending Newton iterations share it.
class EquilibriumModel {
 public:
  /// Everything is kept by reference. settings: of Newton's method.
  EquilibriumModel(medium::Medium& medium, const loads::Boundary& boundary, linear::TangentSystem& system,
                   const deck::Newton& settings);

  /// The step to be solved, from the medium's committed state. The external force [owned * dimension] stays alive until
  /// the next call.
  void set_step(const std::vector<double>& external, double t);

  /// Says that a displacement is that of the committed state, so that it is not evaluated a second time in this step.
  void take_for_committed(const medium::At& at) { committed_too_ = at.version; }

  /// Internal force and balance at a displacement [owned * dimension]; the medium keeps the state
  /// under trial. Collective.
  const ForceBalance& evaluate(const medium::At& asked);
  const ForceBalance& balance() const { return balance_; }
  const std::vector<double>& force() const { return force_; }
  const medium::Trial& trial() const { return medium_.trial(); }
  /// Out-of-balance force of the last evaluation on the free unknowns, 0 on the prescribed ones: [owned * dimension].
  std::vector<double> out_of_balance() const;
  /// Linearises at a displacement and brings the preconditioner there. An outcome that has not converged says that a
  /// matrix could not be factorised. Collective.
  linear::LinearOutcome linearise(const medium::At& at);

  /// Names the first particle with a force that is not finite, on any rank. Collective.
  std::string not_finite() const;
  /// Scalar product over all ranks: [owned * dimension]. Collective.
  double dot(const std::vector<double>& a, const std::vector<double>& b) const;
  /// Sum over all ranks. Collective.
  double sum(double mine) const { return points_.body().communicator.sum(mine); }
  /// 2-norm of what x is away from the displacement that the step starts from: length. Collective.
  double away_from_start(const std::vector<double>& x) const;
  /// Residual below which nothing but rounding is left: force. The displacement that it goes with is the larger one of
  /// the step's start and of the point last evaluated: on the way to no load at all the reactions vanish with the
  /// displacement, and rounding is that of the way. A displacement larger than the body does not raise it: a body that
  /// runs away is in no equilibrium. One that is smaller than rounding of the body's size to the square is none.
  double rounding_floor() const;
  /// Residual of the last evaluation over what it is judged against: the largest of reaction, external force, and the
  /// force that Newton's tolerance makes the rounding floor of. 0 where there is no residual.
  double relative_residual() const;
  /// 2-norm of a displacement of the body's own size; a step beyond it makes no sense.
  double reach() const { return reach_; }

  bool prescribed(std::size_t u) const { return boundary_.prescribed()[u] != 0; }
  linear::TangentSystem& system() { return system_; }
  double t() const { return t_; }

 private:
  bool loose(std::size_t u) const;
  medium::At known(const medium::At& at) const { return at.version == committed_too_ ? medium_.at() : at; }

  medium::Medium& medium_;
  const medium::Model& points_;
  const loads::Boundary& boundary_;
  linear::TangentSystem& system_;
  const deck::Newton& settings_;
  double start_ = 0;  ///< 2-norm of the displacement that the step starts from
  double reach_;      ///< 2-norm of a displacement of the body's own size
  const std::vector<double>* external_ = nullptr;
  double t_ = 0;
  // The last evaluation.
  std::uint64_t version_ = 0;        ///< of its displacement; 0: there is none in this step
  std::uint64_t committed_too_ = 0;  ///< of a displacement that is the committed one; 0: none is
  std::vector<double> force_;
  ForceBalance balance_;
};

}  // namespace perinox::equilibrium
