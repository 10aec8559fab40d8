#include "perinox/stepping/load_stepper.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "energy_scale.hpp"
#include "perinox/core/clock.hpp"
#include "perinox/core/error.hpp"
#include "perinox/equilibrium/arc_length.hpp"
#include "perinox/loads/parts.hpp"

namespace perinox::stepping {

std::unique_ptr<equilibrium::StepControl> LoadStepper::make_control() {
  if (deck_.steps.control == deck::Control::arc_length)
    return std::make_unique<equilibrium::ArcLength>(deck_, medium_, boundary_, newton_);
  return std::make_unique<equilibrium::LoadSteps>(deck_, medium_, boundary_, newton_);
}

LoadStepper::LoadStepper(const deck::Deck& deck, medium::Medium& medium)
    : deck_(deck),
      medium_(medium),
      peridynamic_(dynamic_cast<mechanics::PeridynamicMedium*>(&medium)),
      model_(medium.model()),
      boundary_(deck, model_),
      newton_(deck, medium, boundary_),
      control_(make_control()),
      force_(model_.owned_unknowns(), 0.0),
      external_(model_.owned_unknowns(), 0.0),
      records_(deck, model_) {
  if (peridynamic_) validity_ = std::make_unique<Validity>(deck, peridynamic_->scene());
  if (deck.may_move()) motion_.emplace();
  if (!deck.breaks() && !motion_) return;
  if (!peridynamic_) throw std::logic_error("only a peridynamic medium can break or go on in time");
  mechanics::Scene& scene = peridynamic_->scene();
  if (deck.breaks()) breaking_ = std::make_unique<fracture::BondBreaking>(deck, scene, peridynamic_->evaluation());
  const loads::Parts parts = loads::find_parts(deck, scene, boundary_);
  if (motion_) passage_ = passage_time(deck, scene, parts);
  bonds_ = loads::moving_bonds(scene, parts);
}

LoadStepper::LoadStepper(const deck::Deck& deck, std::unique_ptr<mechanics::PeridynamicMedium> own)
    : LoadStepper(deck, *own) {
  own_ = std::move(own);
}

LoadStepper::LoadStepper(const deck::Deck& deck, mechanics::Scene& scene)
    : LoadStepper(deck, std::make_unique<mechanics::PeridynamicMedium>(scene, deck.output.fields)) {}

const mechanics::Committed& LoadStepper::committed() const {
  if (!peridynamic_) throw std::logic_error("only a peridynamic medium has a state of this kind");
  return peridynamic_->committed();
}

void LoadStepper::run(Observer& observer) {
  const Communicator& ranks = model_.body().communicator;
  const double begin = now();
  const double done_before = step_ > 0 ? control_->share() : 0;
  step_begin_ = begin - phase_.seconds;
  told_times_ = ranks.profile().read();
  told_times_.count[static_cast<std::size_t>(Section::product)] -= phase_.products;
  if (!restored_) {
    observer.run_begins(record({}, true));
    step_begin_ = now();
  }
  while (hand_over_ || !control_->finished()) {
    equilibrium::NewtonResult result;
    if (!advance(observer, result)) continue;
    last_result_ = result;
    if (validity_) validity_->look(peridynamic_->committed(), step_, boundary_.loose(), observer);
    const bool last = control_->finished();
    StepRecord row = record(result, last || step_ % deck_.output.every == 0);
    row.seconds = now() - step_begin_;
    const double done = control_->share() - done_before;
    row.remaining_seconds = done > 0 ? (now() - begin) * (1 - control_->share()) / done : 0;
    row.last = last;
    const ProfileReading reading = ranks.profile().read();
    row.profile = ranks.slowest(reading - told_times_);
    told_times_ = reading;
    observer.step_committed(row);
    if (told_) told_(row);
    step_begin_ = now();
  }
}

bool LoadStepper::go_down(Observer& observer, double t, equilibrium::NewtonResult& result) {
  const bool unstable = result.failure == linear::Failure::negative_curvature ||
                        result.failure == linear::Failure::no_progress ||
                        result.failure == linear::Failure::linear_iterations;
  if (deck_.steps.control != deck::Control::load || !deck_.steps.adaptive || !unstable) return false;
  observer.note(fmt::format("no stable equilibrium is near: goes down in energy at t = {:.6g}", t));
  std::vector<double> force;
  const equilibrium::NewtonResult found = newton_.descend(t, step_ + 1, observer, force);
  if (!found.converged) {
    if (!found.reason.empty()) result.reason += "; " + found.reason;
    return false;
  }
  result = found;
  if (converged_) converged_();
  begin_step();
  control_->accept();
  const Energies before = energies_;
  commit(std::move(force));
  const double lost = energies_.lost_since(before);
  energies_.relaxed += lost;
  note_jump(t, lost);
  observer.note(fmt::format("a stable equilibrium at t = {:.6g}: {:.4g} of energy lost on the way", t, lost));
  control_->jumped(medium_.t());
  settle(observer, result);
  return true;
}

void LoadStepper::note_jump(double t, double energy) {
  if (jumps_.count++ == 0) jumps_.first_t = t;
  jumps_.energy += energy;
}

std::string LoadStepper::jumps() const {
  if (jumps_.count == 0) return "";
  return fmt::format(
      "the body jumps to another equilibrium in {} load step{}, {}at t = {:.6g}: {:.4g} of energy is lost on the way, "
      "which load steps do not follow and which external_work counts; steps.control: arc-length finds the way, "
      "explicit dynamics the motion",
      jumps_.count, jumps_.count == 1 ? "" : "s", jumps_.count == 1 ? "" : "first ", jumps_.first_t, jumps_.energy);
}

void LoadStepper::begin_step() {
  ++step_;
  passes_ = 0;
  if (!motion_) return;
  motion_->phases = 0;
  motion_->cause = LostEquilibrium::no;
  motion_->phase_time = motion_->phase_energy = 0;
}

bool LoadStepper::advance(Observer& observer, equilibrium::NewtonResult& result) {
  if (hand_over_) {
    const std::string reason = finish_motion(observer, result);
    if (!reason.empty()) lost_equilibrium(observer, reason, result);
    return true;
  }
  std::vector<double> force;
  result = control_->attempt(step_ + 1, observer, force);
  if (result.converged && model_.small_strain() &&
      loads::moves_beyond_small(model_, boundary_, medium_.trial().displacement.data())) {
    result.converged = false;
    result.failure = linear::Failure::other;
    result.reason =
        "the body moves by more than half its size, for which deformation: small does not hold: the load is beyond "
        "what "
        "it carries, or deformation: finite is needed";
  }
  if (!result.converged) {
    const double tried = control_->tried();
    observer.step_rejected(medium_.t(), tried, result.reason);
    if (control_->cut()) return false;
    if (!motion_) {
      if (!go_down(observer, tried, result)) stop(observer, tried, result);
      return true;
    }
    begin_step();
    const Loss loss{LostEquilibrium::newton, result.reason};
    const std::string reason = go_through_motion(observer, tried, loss, result);
    if (!reason.empty()) lost_equilibrium(observer, reason, result);
    return true;
  }
  if (converged_) converged_();
  begin_step();
  control_->accept();
  commit(std::move(force), true);
  if (lost_by_snapping_ > 0)
    observer.note(
        fmt::format("warning: snaps to another equilibrium at t = {:.6g}: {:.4g} of energy lost on the way, "
                    "which load steps do not follow; steps.control: arc-length finds the way, explicit "
                    "dynamics the motion",
                    medium_.t(), lost_by_snapping_));
  settle(observer, result);
  return true;
}

void LoadStepper::settle(Observer& observer, equilibrium::NewtonResult& result) {
  if (!breaking_) return;
  const Loss loss = break_bonds(observer, result);
  std::string reason = loss.reason;
  if (loss.cause != LostEquilibrium::no && motion_) reason = go_through_motion(observer, medium_.t(), loss, result);
  if (!reason.empty()) lost_equilibrium(observer, reason, result);
  if (passes_ > 0) control_->jumped(medium_.t());
}

void LoadStepper::lost_equilibrium(Observer& observer, const std::string& reason,
                                   const equilibrium::NewtonResult& result) {
  // The state is no longer that of the step before, so it keeps the number of the step that it was lost in.
  const StepRecord lost = record(result, true);
  --step_;
  observer.run_stopped(&lost);
  throw RunError(fmt::format("stopped at t = {:.10g} of {:g}, after {} converged steps: {}", medium_.t(),
                             deck_.steps.end, step_, reason));
}

void LoadStepper::stop(Observer& observer, double t, const equilibrium::NewtonResult& result) {
  const StepRecord last = record(last_result_, true);
  observer.run_stopped(step_ > 0 ? &last : nullptr);
  control_->forget_cuts();
  if (stopped_ && step_ > 0) stopped_(last);
  throw RunError(fmt::format(
      "stopped at t = {:.10g} of {:g}, after {} converged steps: the step to t = {:.10g} does not converge{}; {}",
      medium_.t(), deck_.steps.end, step_, t,
      deck_.steps.adaptive ? " at its smallest size" : " and steps.adaptive is false", result.reason));
}

double LoadStepper::set_free() const {
  if (deck_.steps.control != deck::Control::load) return 0;
  const medium::Trial& trial = medium_.trial();
  double work = 0, moved = 0;
  for (std::size_t u = 0; u < external_.size(); ++u) {
    const double change = trial.displacement[u] - medium_.displacement()[u];
    if (boundary_.prescribed()[u])
      moved = std::max(moved, std::abs(change));
    else
      work += external_[u] * change;
  }
  std::vector<double> sums{work, trial.stored - loads::loose_energy(model_, boundary_.loose(), trial.stored_energy),
                           trial.dissipated};
  const Communicator& ranks = model_.body().communicator;
  ranks.sum(sums);
  if (ranks.max(moved) > 0) return 0;
  // On a plateau the two are equal but for the tolerance of the steps.
  constexpr double equal = 0.01;
  const double beyond = sums[0] - (sums[1] - energies_.stored) - sums[2];
  return beyond > equal * std::abs(sums[0]) + equal * energies_.scale ? beyond : 0;
}

void LoadStepper::commit(std::vector<double>&& force, bool followed) {
  const Communicator& ranks = model_.body().communicator;
  const medium::Trial& trial = medium_.trial();
  const bool snaps = followed && set_free() > 0;
  lost_by_snapping_ = 0;
  std::vector<double> external(model_.owned_unknowns());
  boundary_.external_force(trial.t, external.data());
  // Outside forces on the body: the given ones, and on prescribed unknowns whatever balances the internal force.
  double work = 0;
  for (std::size_t u = 0; u < force.size(); ++u) {
    // A body that jumps does so under the loads of its new place, whatever they were before.
    const double before = boundary_.prescribed()[u] ? -force_[u] : followed ? external_[u] : external[u];
    const double after = boundary_.prescribed()[u] ? -force[u] : external[u];
    work += 0.5 * (before + after) * (trial.displacement[u] - medium_.displacement()[u]);
  }
  std::vector<double> sums{work, trial.stored - loads::loose_energy(model_, boundary_.loose(), trial.stored_energy),
                           trial.dissipated};
  ranks.sum(sums);
  energies_.external_work += sums[0];
  if (snaps) {
    lost_by_snapping_ = sums[0] - (sums[1] - energies_.stored) - sums[2];
    energies_.relaxed += lost_by_snapping_;
    note_jump(trial.t, lost_by_snapping_);
  }
  energies_.stored = sums[1];
  energies_.dissipated += sums[2];

  energies_.external_work += ranks.sum(medium_.commit(followed && !snaps));
  raise_energy_scale();
  force_ = std::move(force);
  external_ = std::move(external);
}

void LoadStepper::raise_energy_scale() {
  energies_.raise_scale(energy_of_rounding(model_, medium_.displacement(), boundary_.loose()));
}

StepRecord LoadStepper::record(const equilibrium::NewtonResult& result, bool written) {
  StepRecord row;
  row.step = step_;
  row.t = medium_.t();
  row.newton_iterations = result.newton_iterations;
  row.linear_iterations = result.linear_iterations;
  row.stored_energy = energies_.stored;
  row.dissipated_energy = energies_.dissipated;
  row.external_work = energies_.external_work;
  if (breaking_) row.fracture = FractureRow{passes_, breaking_->broken(), energies_.released, energies_.relaxed};
  if (validity_) row.overlap = validity_->overlap();
  row.motion = motion_;
  if (row.motion) row.motion->damped_energy = energies_.damped;
  row.end = deck_.steps.end;
  records_.fill({medium_.displacement(), force_.data(), external_.data(), boundary_.loose(), nullptr,
                 medium_.fields(written), [this](LocalIndex i) { return medium_.has_flowed(i); }},
                written, row);
  return row;
}

}  // namespace perinox::stepping
