/// What a run carries from one step to the next, on its way to a checkpoint and back.
#include <algorithm>
#include <cmath>
#include <limits>

#include "perinox/core/clock.hpp"
#include "perinox/core/restored.hpp"
#include "perinox/fracture/broken_bonds.hpp"
#include "perinox/stepping/load_stepper.hpp"

namespace perinox::stepping {

namespace {
/// There in checkpoints within a load step only.
constexpr const char* phase = "phase/number";
}  // namespace

void LoadStepper::save_fracture(StateWriter& writer) const {
  writer.integer("stepper/passes", passes_);
  writer.number("stepper/released_energy", energies_.released);
  std::vector<double> loose(static_cast<std::size_t>(model_.owned()), 0.0);
  std::copy(boundary_.loose().begin(), boundary_.loose().end(), loose.begin());
  writer.particles("fracture/loose", loose.data(), 1);
  fracture::save_broken_bonds(peridynamic_->scene(), breaking_->rounds(), writer);
}

// The preconditioner's coarse functions are split along the crack as it was when they were made, and so they are again.
// After a phase of motion Newton's solver is made anew.
void LoadStepper::restore_fracture(StateReader& reader) {
  passes_ = restored_count(reader, "stepper/passes");
  energies_.released = reader.number("stepper/released_energy");
  const std::vector<double> marks = reader.particles("fracture/loose", 1);
  std::vector<char> loose;
  for (const double mark : marks) loose.push_back(static_cast<char>(mark != 0));
  const bool any = model_.body().communicator.any(std::find(loose.begin(), loose.end(), 1) != loose.end());
  fracture::BrokenBonds broken(peridynamic_->scene(), reader);
  if (!reader.has(phase)) {
    broken.break_first(reader.integer("tangent/bonds_broken"));
    if (any) boundary_.let_go(loose);
    if (any || broken.count() > 0) newton_.bonds_changed(true);
    if (reader.has("tangent/coarse_bonds_broken")) broken.break_first(reader.integer("tangent/coarse_bonds_broken"));
    newton_.restore(reader);
  } else if (any) {
    boundary_.let_go(loose);
  }
  broken.break_first(broken.count());
  breaking_->resume(broken);
}

void LoadStepper::save_phase(StateWriter& writer) const {
  const MotionPhase& row = phase_.row;
  writer.integer(phase, row.number);
  writer.number("phase/t_begin", row.t_begin);
  writer.integer("phase/cause", static_cast<int>(row.cause));
  writer.text("phase/reason", row.reason);
  writer.integer("phase/of_step", motion_->phases);
  writer.integer("phase/step_cause", static_cast<int>(motion_->cause));
  writer.number("phase/step_time", motion_->phase_time);
  writer.number("phase/step_energy", motion_->phase_energy);
  writer.integer("phase/newton_iterations", phase_.total.newton_iterations);
  writer.integer("phase/linear_iterations", phase_.total.linear_iterations);
  const Communicator& ranks = model_.body().communicator;
  writer.number("phase/seconds", ranks.max(now() - step_begin_));
  writer.integer("phase/products", ranks.slowest(ranks.profile().read() - told_times_).count_of(Section::product));
  hand_over_->save(writer);
}

void LoadStepper::restore_phase(StateReader& reader) {
  MotionPhase& row = phase_.row;
  row.step = step_;
  row.t_begin = reader.number("phase/t_begin");
  const auto cause = [&](const char* name) {
    return static_cast<LostEquilibrium>(restored_count(reader, name, static_cast<int>(LostEquilibrium::passes)));
  };
  row.cause = cause("phase/cause");
  row.reason = reader.text("phase/reason");
  motion_->phases = restored_count(reader, "phase/of_step");
  motion_->cause = cause("phase/step_cause");
  motion_->phase_time = reader.number("phase/step_time");
  motion_->phase_energy = reader.number("phase/step_energy");
  phase_.total.newton_iterations = restored_count(reader, "phase/newton_iterations");
  phase_.total.linear_iterations = restored_count(reader, "phase/linear_iterations");
  phase_.seconds = reader.number("phase/seconds");
  phase_.products = restored_integer(reader, "phase/products", 0, std::numeric_limits<long long>::max());
  hand_over_ = std::make_unique<HandOver>(deck_, peridynamic_->scene(), boundary_, breaking_.get(), passage_,
                                          peridynamic_->evaluation());
  hand_over_->restore(reader);
}

void LoadStepper::save(StateWriter& writer) const {
  writer.integer("stepper/step", step_);
  writer.number("stepper/stored_energy", energies_.stored);
  writer.number("stepper/dissipated_energy", energies_.dissipated);
  writer.number("stepper/external_work", energies_.external_work);
  writer.number("stepper/energy_scale", energies_.scale);
  writer.integer("stepper/newton_iterations", last_result_.newton_iterations);
  writer.integer("stepper/linear_iterations", last_result_.linear_iterations);
  writer.particles("stepper/force", force_.data(), model_.dimension());
  medium_.save_fields(writer);
  writer.number("stepper/relaxed_energy", energies_.relaxed);
  writer.integer("stepper/jumps", jumps_.count);
  writer.number("stepper/first_jump", jumps_.first_t);
  writer.number("stepper/jump_energy", jumps_.energy);
  control_->save(writer);
  newton_.save_remedies(writer);
  if (validity_) validity_->save(writer);
  if (breaking_) save_fracture(writer);
  if (hand_over_) {
    save_phase(writer);
  } else {
    medium_.save(writer);
    newton_.save(writer);
  }
  if (!motion_) return;
  writer.integer("stepper/phases", phase_.row.number);
  writer.number("stepper/damped_energy", energies_.damped);
  writer.number("stepper/time", motion_->time);
  writer.integer("stepper/time_steps", motion_->time_steps);
}

void LoadStepper::restore(StateReader& reader) {
  restored_ = true;
  const auto count = [&](const char* name) { return restored_count(reader, name); };
  step_ = count("stepper/step");
  energies_.stored = reader.number("stepper/stored_energy");
  energies_.dissipated = reader.number("stepper/dissipated_energy");
  energies_.external_work = reader.number("stepper/external_work");
  energies_.scale =
      std::max({std::abs(energies_.external_work), std::abs(energies_.stored), std::abs(energies_.dissipated)});
  if (reader.has("stepper/energy_scale")) energies_.scale = restored_number(reader, "stepper/energy_scale", 0);
  if (reader.has("stepper/relaxed_energy")) energies_.relaxed = reader.number("stepper/relaxed_energy");
  if (reader.has("stepper/jumps"))
    jumps_ = {count("stepper/jumps"), reader.number("stepper/first_jump"), reader.number("stepper/jump_energy")};
  last_result_.converged = true;
  last_result_.newton_iterations = count("stepper/newton_iterations");
  last_result_.linear_iterations = count("stepper/linear_iterations");
  force_ = reader.particles("stepper/force", model_.dimension());
  newton_.restore_remedies(reader);
  if (validity_) validity_->restore(reader);
  if (breaking_)
    restore_fracture(reader);
  else if (!reader.has(phase))
    newton_.restore(reader);
  if (motion_) {
    energies_.damped = reader.number("stepper/damped_energy");
    motion_->time = reader.number("stepper/time");
    motion_->time_steps = restored_integer(reader, "stepper/time_steps", 0, std::numeric_limits<long long>::max());
    phase_.row.number = count("stepper/phases");
  }
  medium_.restore(reader);
  control_->restore(reader);
  if (reader.has(phase)) {
    peridynamic_->committed() = mechanics::Committed(peridynamic_->scene());  // the phase has it, and gives it back
    restore_phase(reader);
    return;
  }
  boundary_.external_force(medium_.t(), external_.data());
}

}  // namespace perinox::stepping
