#include "perinox/stepping/time_stepper.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "energy_scale.hpp"
#include "perinox/core/clock.hpp"
#include "perinox/core/error.hpp"
#include "perinox/mechanics/internal_force.hpp"
#include "perinox/motion/stable_step.hpp"

namespace perinox::stepping {

namespace {

/// Time steps between two looks at the energies, which cost a sum over the ranks.
constexpr long long between_looks = 10;
/// Time steps that an estimate of the stable one serves: it costs about as much as thirty of them.
constexpr long long between_estimates = 1000;

motion::ExplicitMotion::Settings settings_of(const deck::Deck& deck, const mechanics::Scene& scene) {
  const deck::Explicit& motion = deck.motion;
  motion::ExplicitMotion::Settings settings;
  settings.damping = motion.damping;
  settings.contact = motion.contact;
  settings.safety = motion::time_step_safety(deck, scene);
  return settings;
}

/// Of a whole run: with more of them t does not move any more where it is of the order of the run's end.
constexpr double most_time_steps = 1e15;

/// Equal time steps of at most `longest` that fill `span`: a whole number, 0 < longest.
double count_of(double span, double longest) { return std::max(1.0, std::ceil(span / longest * (1 - 1e-12))); }
}  // namespace

TimeStepper::TimeStepper(const deck::Deck& deck, mechanics::Scene& scene)
    : deck_(deck),
      scene_(scene),
      boundary_(deck, scene),
      evaluation_(std::make_shared<mechanics::Evaluation>(scene)),
      records_(deck, scene),
      fields_(scene, deck.output.fields),
      validity_(deck, scene) {
  make_motion();
  if (deck.breaks()) breaking_ = std::make_unique<fracture::BondBreaking>(deck, scene, evaluation_);
  motion_->set_velocity(deck.initial_velocity);
}

void TimeStepper::make_motion() {
  motion_.emplace(scene_, boundary_, motion::particle_masses(deck_, scene_), mechanics::Committed(scene_),
                  settings_of(deck_, scene_), evaluation_);
}

double TimeStepper::time_step() {
  const double longest = deck_.motion.time_step ? *deck_.motion.time_step : motion_->stable_time_step();
  return std::min(longest, deck_.steps.end / std::max(1, deck_.steps.count));
}

TimeStepPlan TimeStepper::plan() {
  TimeStepPlan plan;
  plan.stable = motion_->stable_time_step() / motion::time_step_safety(deck_, scene_);
  const double row = deck_.steps.end / std::max(1, deck_.steps.count);
  const double count = count_of(row, time_step());
  plan.length = row / count;
  if (!(count * deck_.steps.count <= most_time_steps))
    deck::refuse(deck_.motion.location,
                 fmt::format("t goes from 0 to {:g} in {:.3g} time steps of {:.4g}, more than {:.0e}; take a longer "
                             "time_step or a smaller steps.end, and look at the units of moduli and densities",
                             deck_.steps.end, count * deck_.steps.count, plan.length, most_time_steps));
  plan.time_steps = static_cast<long long>(count) * deck_.steps.count;
  if (plan.length > plan.stable)
    plan.remark = fmt::format(
        "{}: the time step {:.4g} is above the largest stable one, {:.4g}: the motion will grow without bound; take "
        "less, or leave time_step out",
        deck_.motion.location.text(), plan.length, plan.stable);
  return plan;
}

void TimeStepper::run(Observer& observer) {
  const Communicator& ranks = scene_.body().communicator;
  const TimeStepPlan plan = this->plan();
  observer.note(fmt::format("{} time steps of {:.4g}; the largest stable one is {:.4g}", plan.time_steps, plan.length,
                            plan.stable));
  const double begin = now(), begin_t = motion_->t();
  row_begin_ = begin - row_seconds_;
  ProfileReading told = ranks.profile().read();
  if (!restored_) {
    tell_start(observer);
    row_begin_ = now();
  }
  while (row_ < deck_.steps.count) {
    const double t = deck_.steps.end * (row_ + 1) / deck_.steps.count;
    if (!advance_to(t, observer)) stop(observer);
    ++row_;
    ++step_;
    const bool end = row_ == deck_.steps.count;
    validity_.look(motion_->committed(), step_, boundary_.loose(), observer);
    StepRecord row = record(end || step_ % deck_.output.every == 0, end);
    row.t = row.motion->time = t;
    row.seconds = now() - row_begin_;
    row.remaining_seconds = (now() - begin) * (deck_.steps.end - t) / (t - begin_t);
    const ProfileReading reading = ranks.profile().read();
    row.profile = ranks.slowest(reading - told);
    told = reading;
    observer.step_committed(row);
    if (told_) told_(row);
    row_begin_ = now();
  }
}

// With its forces, from which the first time step goes; how long that is decides on the kinetic energy that the scheme
// conserves.
void TimeStepper::tell_start(Observer& observer) {
  if (deck_.steps.count > 0) begin_row(deck_.steps.end / deck_.steps.count);
  motion_->begin(length_);
  energies_ = motion_->energies();
  observer.run_begins(record(true, false));
}

void TimeStepper::begin_row(double t) {
  if (motion_->time_steps() - estimated_ >= between_estimates) {
    estimated_ = motion_->time_steps();
    motion_->estimate_again();
  }
  const double span = t - motion_->t();
  row_longest_ = time_step();
  row_end_ = t;
  row_done_ = 0;
  // plan() has refused what is too many, but bonds that stiffen may have made the stable time step shorter since.
  const double count = count_of(span, row_longest_);
  if (!(count <= most_time_steps))
    throw RunError(fmt::format("stopped at t = {:.6g} of {:g}: the largest stable time step has become {:.4g}",
                               motion_->t(), deck_.steps.end, row_longest_));
  row_count_ = static_cast<long long>(count);
  length_ = span / static_cast<double>(row_count_);
}

bool TimeStepper::advance_to(double t, Observer& observer) {
  // A restart within a row goes on with its time steps, unless the deck has other rows or time steps now.
  if (row_done_ == 0 || row_end_ != t || row_longest_ != time_step()) begin_row(t);
  while (row_done_ < row_count_) {
    motion_->step(length_);
    ++row_done_;
    if (breaking_) breaking_->break_all(*motion_);
    const bool end = row_done_ == row_count_;
    if (row_done_ % between_looks != 0 && !end) continue;
    motion_->gather_sums();
    energies_ = motion_->energies();
    energy_scale_ = std::max(energy_scale_, energies_.scale());
    if (!motion_->sound(energies_)) return false;
    if (end) continue;
    observer.moves({motion_->t(), motion_->time(), motion_->time_steps(), energies_.kinetic, energies_.stored,
                    energies_.damped, breaking_ ? breaking_->broken() : 0});
    if (passing_) passing_(step_, motion_->t());
  }
  row_done_ = 0;
  energy_scale_ = std::max(energy_scale_, energy_of_rounding(scene_, motion_->trial().displacement, boundary_.loose()));
  worst_gain_ = std::max(worst_gain_, std::abs(unaccounted()));
  return true;
}

StepRecord TimeStepper::record(bool written, bool last) {
  StepRecord row;
  row.step = step_;
  row.stored_energy = energies_.stored;
  row.dissipated_energy = energies_.dissipated;
  row.external_work = energies_.external_work;
  row.end = deck_.steps.end;
  row.last = last;
  MotionRow motion;
  motion.time_steps = motion_->time_steps();
  motion.kinetic_energy = energies_.kinetic;
  motion.damped_energy = energies_.damped;
  motion.contact_energy = energies_.contact;
  row.motion = motion;
  row.overlap = validity_.overlap();
  if (breaking_) row.fracture = FractureRow{0, breaking_->broken(), energies_.released, 0};
  records_.fill({motion_->committed().displacement(), motion_->force().data(), motion_->external().data(),
                 boundary_.loose(), motion_->velocity().data(),
                 fields_.of(motion_->committed(), motion_->dilatation(), motion_->stored_energy(), written),
                 [this](LocalIndex i) { return fields_.has_flowed(i); }},
                written, row);
  return row;
}

void TimeStepper::stop(Observer& observer) {
  observer.run_stopped(nullptr);
  const bool finite = std::isfinite(energies_.sum()) && std::isfinite(energies_.external_work);
  std::string where;
  if (!finite) {
    try {  // the lowest rank that has something to say is heard on all
      scene_.body().communicator.agree_on_input_error(
          mechanics::first_not_finite(scene_, motion_->trial(), motion_->force().data()));
    } catch (const InputError& found) {
      where = fmt::format(": {}", found.what());
    }
  }
  const double stable = 2 / std::sqrt(motion_->eigenvalue());
  throw RunError(fmt::format(
      "stopped at t = {:.6g} of {:g}, after {} rows and {} time steps: the energies {}{}; the time step was {:.4g} and "
      "the largest stable one, as last estimated, is {:.4g}: take a smaller explicit.{}",
      motion_->t(), deck_.steps.end, step_, motion_->time_steps(),
      finite ? "grow though nothing does that work" : "are not finite", where, length_, stable,
      deck_.motion.time_step ? "time_step" : "safety"));
}

}  // namespace perinox::stepping
