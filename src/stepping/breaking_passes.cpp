/// What the load stepper does between an equilibrium and the next load where bonds can break.
#include <fmt/format.h>

#include <algorithm>

#include "energy_scale.hpp"
#include "perinox/fracture/let_go.hpp"
#include "perinox/stepping/hand_over.hpp"
#include "perinox/stepping/load_stepper.hpp"

namespace perinox::stepping {

namespace {
/// Phases of motion at one load before the run gives up.
constexpr int most_phases = 20;
constexpr double most_patience = 1000;

/// What a phase in time has come to, at its end. rounding: the energy below which nothing is known.
void describe(const HandOver::Result& result, double rounding, MotionPhase& row) {
  const motion::MotionEnergies& e = result.energies;
  row.at_rest = result.at_rest;
  row.time = result.time;
  row.time_steps = result.time_steps;
  row.broken_bonds = result.broken;
  row.external_work = e.external_work;
  row.released_energy = e.released;
  row.damped_energy = e.damped + e.kinetic + e.contact;
  row.most_kinetic_energy = result.most_kinetic;
  row.unaccounted_energy = e.gain();
  const double scale = std::max(e.scale(), rounding);
  row.unaccounted_share = scale > 0 ? e.gain() / scale : 0;
}
}  // namespace

LoadStepper::Loss LoadStepper::break_bonds(Observer& observer, equilibrium::NewtonResult& total) {
  const Communicator& ranks = model_.body().communicator;
  const auto most = std::max(1LL, static_cast<long long>(deck_.fracture.pass_share * static_cast<double>(bonds_)));
  const long long before_step = breaking_->broken();
  for (int pass = 1;; ++pass) {
    const bool too_many = pass > deck_.fracture.max_passes;
    const fracture::BondBreaking::Result found = breaking_->break_worst(peridynamic_->committed(), too_many ? 0 : most);
    if (found.critical == 0) return {};
    const bool runs = motion_ && pass > 1 && found.worst > deck_.hand_over.overload;
    const double t = medium_.t();
    if (too_many)
      return {LostEquilibrium::passes,
              fmt::format("bonds still break after {} passes at t = {:.6g}", deck_.fracture.max_passes, t)};
    observer.bonds_broken({step_, t, pass, found.critical, found.broken, found.worst});
    ++passes_;

    const std::vector<char> loose_before = boundary_.loose();
    const bool loose = fracture::let_loose_go(peridynamic_->scene(), boundary_, *breaking_,
                                              peridynamic_->committed().plastic(), {external_, external_}, observer)
                           .particles;
    std::vector<double> force(model_.owned_unknowns());
    medium_.evaluate(t, medium_.at(), force.data());
    const medium::Trial& trial = medium_.trial();
    // Flow that the break sets off is the next solve's, and what it dissipates is still stored.
    std::vector<double> sums{trial.stored + trial.dissipated,
                             loads::loose_energy(model_, loose_before, trial.stored_energy),
                             loads::loose_energy(model_, boundary_.loose(), trial.stored_energy)};
    ranks.sum(sums);
    energies_.released += energies_.stored - (sums[0] - sums[1]);
    // What comes loose would fly off with what it stores.
    energies_.relaxed += sums[2] - sums[1];
    energies_.stored = sums[0] - sums[2];
    force_ = force;
    newton_.bonds_changed(loose);
    if (runs)
      return {LostEquilibrium::overload,
              fmt::format("a bond is at {:.3g} times its limit, more than hand_over.overload: the crack runs",
                          found.worst)};
    const long long in_step = breaking_->broken() - before_step;
    if (motion_ && static_cast<double>(in_step) > deck_.hand_over.broken_share * static_cast<double>(bonds_))
      return {LostEquilibrium::broken_share,
              fmt::format("{} bonds have broken in one load step, more than hand_over.broken_share", in_step)};
    const equilibrium::NewtonResult result =
        newton_.solve(t, step_, medium::owned_displacement(medium_), observer, force);
    total.newton_iterations += result.newton_iterations;
    total.linear_iterations += result.linear_iterations;
    if (!result.converged)
      return {LostEquilibrium::after_breaking, fmt::format("no equilibrium at t = {:.6g} once {} bonds have broken: {}",
                                                           t, breaking_->broken(), result.reason)};
    if (converged_) converged_();
    const Energies before = energies_;
    commit(std::move(force));
    energies_.relaxed += energies_.lost_since(before);
  }
}

std::string LoadStepper::go_through_motion(Observer& observer, double t, const Loss& loss,
                                           equilibrium::NewtonResult& total) {
  phase_.total = total;
  begin_phase(observer, t, loss, 1);
  return finish_motion(observer, total);
}

void LoadStepper::begin_phase(Observer& observer, double t, const Loss& loss, double patience) {
  MotionPhase row;
  row.number = phase_.row.number + 1;
  row.step = step_;
  row.t_begin = medium_.t();
  row.cause = loss.cause;
  row.reason = loss.reason;
  phase_.row = row;
  observer.phase_begins(row);
  hand_over_ = std::make_unique<HandOver>(deck_, peridynamic_->scene(), boundary_, breaking_.get(), passage_,
                                          peridynamic_->evaluation());
  hand_over_->begin(std::move(peridynamic_->committed()), t, patience);
}

std::string LoadStepper::finish_motion(Observer& observer, equilibrium::NewtonResult& total) {
  const auto passing = [this](double t) {
    if (passing_) passing_(step_ - 1, t);
  };
  for (;;) {
    const HandOver::Result result = hand_over_->run(peridynamic_->committed(), observer, force_, external_, passing);
    const double more_patience = std::min(most_patience, 10 * hand_over_->patience());
    hand_over_.reset();
    total = phase_.total;
    MotionPhase& row = phase_.row;
    const motion::MotionEnergies& e = result.energies;
    energies_.add_phase(e);
    motion_->time += result.time;
    motion_->time_steps += result.time_steps;
    if (motion_->phases++ == 0) motion_->cause = row.cause;
    motion_->phase_time += result.time;
    motion_->phase_energy += e.damped + e.kinetic + e.contact;
    row.t_end = medium_.t();
    describe(result, energy_of_rounding(model_, medium_.displacement(), boundary_.loose()), row);
    observer.phase_ended(row);
    if (!result.at_rest) return result.reason;
    newton_.bonds_changed(true);
    control_->jumped(medium_.t());

    std::vector<double> force;
    const equilibrium::NewtonResult found =
        newton_.solve(medium_.t(), step_, medium::owned_displacement(medium_), observer, force);
    total.newton_iterations += found.newton_iterations;
    total.linear_iterations += found.linear_iterations;
    Loss loss{LostEquilibrium::newton, found.reason};
    if (found.converged) {
      const Energies before = energies_;
      commit(std::move(force));
      energies_.damped += energies_.lost_since(before);
      loss = breaking_ ? break_bonds(observer, total) : Loss();
      total.converged = true;
      if (loss.cause == LostEquilibrium::no) return "";
    }
    if (motion_->phases == most_phases)
      return fmt::format("no equilibrium at t = {:.6g} after going on in time {} times: {}", medium_.t(), most_phases,
                         loss.reason);
    phase_.total = total;
    begin_phase(observer, medium_.t(), loss, found.converged ? 1 : more_patience);
  }
}

}  // namespace perinox::stepping
