/// What a run carries from one step to the next, on its way to a checkpoint and back.
#include "perinox/solve/load_stepper.hpp"

namespace perinox::solve {

// The steps done are not saved but counted anew, so that the deck may have others now.
void LoadSteps::save(StateWriter& writer) const {
  writer.integer("steps/cuts", cuts_);
  writer.integer("steps/has_previous", has_previous_ ? 1 : 0);
  writer.number("steps/previous_t", previous_t_);
  writer.particles("steps/previous_displacement", previous_displacement_.data(), scene_.dimension());
}

void LoadSteps::restore(const mechanics::Committed& committed, StateReader& reader) {
  const auto cuts = static_cast<int>(reader.integer("steps/cuts"));
  for (cuts_ = 0; cuts_ < cuts; ++cuts_) size_ /= 2;
  for (done_ = 0; !finished() && committed.t() >= whole_end();) ++done_;
  tried_ = committed.t();
  has_previous_ = reader.integer("steps/has_previous") != 0;
  previous_t_ = reader.number("steps/previous_t");
  previous_displacement_ = reader.particles("steps/previous_displacement", scene_.dimension());
}

void LoadStepper::save(StateWriter& writer) const {
  writer.integer("stepper/step", step_);
  writer.number("stepper/stored_energy", energies_.stored);
  writer.number("stepper/dissipated_energy", energies_.dissipated);
  writer.number("stepper/external_work", energies_.external_work);
  writer.integer("stepper/newton_iterations", last_result_.newton_iterations);
  writer.integer("stepper/linear_iterations", last_result_.linear_iterations);
  writer.particles("stepper/force", force_.data(), scene_.dimension());
  writer.particles("stepper/dilatation", dilatation_.data(), 1);
  writer.particles("stepper/stored_energy_density", stored_energy_.data(), 1);
  committed_.save(scene_, writer);
  control_->save(writer);
  newton_.system().save(writer);
}

void LoadStepper::restore(StateReader& reader) {
  const auto count = [&](const char* name) { return static_cast<int>(reader.integer(name)); };
  step_ = count("stepper/step");
  energies_.stored = reader.number("stepper/stored_energy");
  energies_.dissipated = reader.number("stepper/dissipated_energy");
  energies_.external_work = reader.number("stepper/external_work");
  last_result_.converged = true;
  last_result_.newton_iterations = count("stepper/newton_iterations");
  last_result_.linear_iterations = count("stepper/linear_iterations");
  force_ = reader.particles("stepper/force", scene_.dimension());
  dilatation_ = reader.particles("stepper/dilatation", 1);
  stored_energy_ = reader.particles("stepper/stored_energy_density", 1);
  committed_.restore(scene_, reader);
  control_->restore(committed_, reader);
  boundary_.external_force(committed_.t(), external_.data());
  newton_.system().restore(reader);
}

}  // namespace perinox::solve
