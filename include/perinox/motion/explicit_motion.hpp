#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "perinox/deck/deck.hpp"
#include "perinox/fracture/moving_state.hpp"
#include "perinox/loads/boundary.hpp"
#include "perinox/mechanics/internal_force.hpp"
#include "perinox/mechanics/state.hpp"
#include "perinox/motion/contact.hpp"

namespace perinox::motion {

/// Energies of a body in motion, over all ranks.
struct MotionEnergies {
  /// v_(n-1/2) M v_(n+1/2)/2 with the velocities half a time step before and after: the kinetic energy that the scheme
  /// conserves together with the stored one. It is less than v_n M v_n/2 by dt^2/8 a M a.
  double kinetic = 0;
  double moving = 0;   ///< v_n M v_n/2
  double stored = 0;   ///< in what the boundary has not let go as loose
  double contact = 0;  ///< stored in contacts
  // Since the motion began.
  double dissipated = 0;
  double damped = 0;
  double released = 0;  ///< what stored and kinetic energy lost as bonds broke
  /// Of external forces, and of what moves the prescribed unknowns, their inertia included; it begins with the kinetic
  /// energy that the motion begins with.
  double external_work = 0;
  double at_start = 0;  ///< stored energy that the motion began with, contacts included

  double sum() const { return kinetic + stored + contact + dissipated + damped + released; }
  /// What the sum has gained without anybody's work: 0 but for rounding and the length of the time step.
  double gain() const { return sum() - external_work - at_start; }
  /// The largest of the terms: what gain is measured against.
  double scale() const;
};

/// Integrates M u'' = f(u) + external + contact - damping M u' in time by velocity Verlet, one time step a call:
///     v_(n+1/2) = v_n + dt/2 a_n,  u_(n+1) = u_n + dt v_(n+1/2),  v_(n+1) = v_(n+1/2) + dt/2 a_(n+1).
/// Prescribed displacements are imposed at the end of each time step, prescribed velocities integrated by the
/// trapezoidal rule. Materials with history are returned to their yield surface and committed every time step. All
/// members but the plain readings are collective.
class ExplicitMotion : public fracture::MovingState {
 public:
  struct Settings {
    double damping = 0;                    ///< mass-proportional, 1/time
    std::optional<deck::Contact> contact;  ///< none: bodies go through each other
    double rate = 1;                       ///< of the load parameter t over time; 0: loads held
    double safety = 0.8;                   ///< of stable_time_step
  };
  /// Begins at the state and the load parameter of `start`, at rest. masses: [owned].
  /// evaluation: of the scene, shared with whoever takes over from the motion; null: its own.
  ExplicitMotion(const mechanics::Scene& scene, const loads::Boundary& boundary, std::vector<double> masses,
                 mechanics::Committed start, const Settings& settings,
                 std::shared_ptr<mechanics::Evaluation> evaluation = nullptr);

  /// Velocities at the beginning; before the first step. A later entry wins, and a prescribed motion over all of them.
  void set_velocity(const std::vector<deck::InitialVelocity>& entries);

  /// All that the next time step goes on from, and the way back: restored on as many ranks, the motion goes on to the
  /// last bit. To be saved after a time step or bonds_have_broken(), restored before the first step, with the boundary
  /// and the bonds of then, and whatever `start` was. Collective.
  void save(StateWriter& writer) const;
  void restore(StateReader& reader);
  /// To be called at moments that do not depend on whether checkpoints are written: brings the sums over time of all
  /// ranks together, so that they go on from there alike on as many ranks. Collective.
  void gather_sums();

  /// safety * 2/sqrt(lambda), lambda the largest eigenvalue of M^-1 K at the state of the last estimate: the smaller of
  /// bound and Lanczos' value, and what contacts may add (stable_step.hpp). Infinite where nothing is free.
  double stable_time_step();
  /// Estimates again, from the present state: where bodies have deformed much.
  void estimate_again() { lambda_.reset(); }
  /// The largest eigenvalue that the last stable_time_step() came from, 1/time^2.
  double eigenvalue() const { return lambda_.value_or(0); }

  /// One time step of length dt.
  void step(double dt);
  /// Finds the forces and accelerations that the first time step, of the length dt, goes from. step() does so itself.
  void begin(double dt);
  /// To be called after bonds of the scene have broken between two time steps. Evaluates forces and contacts anew at
  /// the present state; the energy that went with the bonds counts as released from here on.
  void bonds_have_broken() override;

  /// To be called after the boundary has let particles go: they stop where they are, and their kinetic and stored
  /// energy counts as damped.
  void supports_have_changed() override;
  /// From here on the load parameter goes from `t` at `rate`.
  void go_on_at(double t, double rate);

  double time() const { return time_; }
  /// Load parameter.
  double t() const { return start_ + settings_.rate * (time_ - since_); }
  long long time_steps() const { return time_steps_; }
  MotionEnergies energies() const;
  /// True while the energies are finite and have not doubled without anybody's work.
  bool sound(const MotionEnergies& energies) const;
  /// Particles that flow in the last time step, over all ranks.
  long long yielding() const;

  /// The present state as a committed one; brings it up to date where materials have no history.
  const mechanics::Committed& committed() override;
  const mechanics::PlasticExtension& plastic() const override {
    return committed_.plastic();
  }  ///< of the present state
  /// The same for good: the motion is over.
  mechanics::Committed release();

  // Of the owned particles.
  const std::vector<double>& velocity() const { return velocity_; }                  ///< [owned * dimension]
  const std::vector<double>& force() const { return force_; }                        ///< internal, [owned * dimension]
  const std::vector<double>& external() const { return external_; }                  ///< contacts included
  const std::vector<double>& loads() const { return loads_; }                        ///< external without contacts
  const std::vector<double>& dilatation() const { return trial_.dilatation; }        ///< [owned]
  const std::vector<double>& stored_energy() const { return trial_.stored_energy; }  ///< [owned] a volume
  const std::vector<double>& displacement() const override { return trial_.displacement; }
  void force_states(double* points) const override { mechanics::held_force_states(*evaluation_, points); }
  const mechanics::Trial& trial() const { return trial_; }
  const std::vector<double>& masses() const { return masses_; }  ///< [owned]
  const Contact* contact() const { return contact_.get(); }

 private:
  void find_held();
  void start_moving();
  void evaluate();
  void accelerate();
  void drift(double dt);
  void impose(double dt);
  void kick(double dt);
  bool prescribed(std::size_t u) const { return boundary_.prescribed()[u] != 0; }

  const mechanics::Scene& scene_;
  const loads::Boundary& boundary_;
  std::shared_ptr<mechanics::Evaluation> evaluation_;
  Settings settings_;
  double start_ = 0, since_ = 0;  ///< t at a time
  bool history_ = false;          ///< some material has one: every time step is committed
  std::vector<double> masses_;
  mechanics::Committed committed_;
  mechanics::Trial trial_;  ///< the present state; its displacement is committed_'s where that is up to date
  std::vector<double> velocity_, acceleration_, force_, external_, loads_;
  std::vector<char> let_go_;               ///< [owned] loose when the supports last changed; empty: none
  std::vector<std::size_t> held_;          ///< prescribed unknowns
  std::vector<double> held_displacement_;  ///< [held] before the step
  std::vector<double> held_velocity_;      ///< [held] before the step
  std::vector<double> held_force_;         ///< [held] internal and contact, before the step
  std::vector<double> contact_force_;
  std::unique_ptr<Contact> contact_;
  std::optional<double> lambda_;
  bool moving_ = false, up_to_date_ = true;

  double time_ = 0, last_step_ = 0;
  long long time_steps_ = 0;
  /// Over time.
  struct Sums {
    double work = 0, damped = 0, dissipated = 0;
  };
  Sums before_;  ///< of all ranks, up to the last gather_sums()
  // This rank's shares since.
  double work_ = 0, damped_ = 0, dissipated_ = 0;
  double contact_energy_ = 0;           ///< this rank's share
  double released_ = 0, at_start_ = 0;  ///< of all ranks
  double least_energy_ = 0;             ///< what rounding may make of nothing, all ranks
};

}  // namespace perinox::motion
