#include "perinox/motion/explicit_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "perinox/core/error.hpp"
#include "perinox/fracture/loose_pieces.hpp"
#include "perinox/loads/parts.hpp"
#include "perinox/mechanics/internal_force.hpp"
#include "perinox/motion/stable_step.hpp"

namespace perinox::motion {

namespace {
/// What the kinetic energy that the scheme conserves is below v_n M v_n/2: dt^2/8 a M a, this rank's share.
double lag(const std::vector<double>& masses, const std::vector<double>& acceleration, std::size_t dimension,
           double dt) {
  double sum = 0;
  for (std::size_t u = 0; u < acceleration.size(); ++u)
    sum += masses[u / dimension] * acceleration[u] * acceleration[u];
  return 0.125 * dt * dt * sum;
}
}  // namespace

double MotionEnergies::scale() const {
  return std::max(
      {std::abs(kinetic), stored, contact, dissipated, damped, released, std::abs(external_work), at_start});
}

ExplicitMotion::ExplicitMotion(const mechanics::Scene& scene, const loads::Boundary& boundary,
                               std::vector<double> masses, mechanics::Committed start, const Settings& settings,
                               std::shared_ptr<mechanics::Evaluation> evaluation)
    : scene_(scene),
      boundary_(boundary),
      evaluation_(evaluation ? std::move(evaluation) : std::make_shared<mechanics::Evaluation>(scene)),
      settings_(settings),
      start_(start.t()),
      history_(scene.body().communicator.any(start.point_history().size() + start.bond_history().size() > 0)),
      masses_(std::move(masses)),
      committed_(std::move(start)),
      velocity_(scene.owned_unknowns(), 0.0),
      acceleration_(scene.owned_unknowns(), 0.0),
      force_(scene.owned_unknowns(), 0.0),
      external_(scene.owned_unknowns(), 0.0),
      loads_(scene.owned_unknowns(), 0.0) {
  trial_.displacement = committed_.displacement();
  find_held();
  if (settings.contact) {
    contact_ = std::make_unique<Contact>(scene, *settings.contact);
    contact_force_.assign(scene.owned_unknowns(), 0.0);
  }
  // A strain of 1e-10 everywhere.
  double energy = 0;
  for (LocalIndex i = 0; i < scene.owned(); ++i)
    energy += 1e-20 * scene.body().volume[i] * scene.material(i).elastic_moduli(scene.dimension()).bulk;
  least_energy_ = scene.body().communicator.sum(energy);
}

void ExplicitMotion::find_held() {
  held_.clear();
  let_go_ = boundary_.loose();
  for (std::size_t u = 0; u < scene_.owned_unknowns(); ++u)
    if (prescribed(u)) held_.push_back(u);
  held_displacement_.resize(held_.size());
  held_velocity_.resize(held_.size());
  held_force_.resize(held_.size());
}

void ExplicitMotion::supports_have_changed() {
  const auto d = static_cast<std::size_t>(scene_.dimension());
  std::vector<char> newly = boundary_.loose();
  for (std::size_t i = 0; i < let_go_.size(); ++i)
    if (let_go_[i]) newly[i] = 0;
  damped_ -= lag(masses_, acceleration_, d, last_step_);
  for (std::size_t u = 0; u < velocity_.size() && !newly.empty(); ++u) {
    if (!newly[u / d]) continue;
    damped_ += 0.5 * masses_[u / d] * velocity_[u] * velocity_[u];
    velocity_[u] = acceleration_[u] = 0;
  }
  const double stored = moving_ ? loads::loose_energy(scene_, newly, trial_.stored_energy) : 0;
  damped_ += lag(masses_, acceleration_, d, last_step_) + stored;
  trial_.stored -= stored;
  find_held();
  lambda_.reset();
}

void ExplicitMotion::go_on_at(double t, double rate) {
  start_ = t;
  since_ = time_;
  settings_.rate = rate;
  if (boundary_.has_forces()) {
    boundary_.external_force(t, loads_.data());
    for (std::size_t u = 0; u < external_.size(); ++u) external_[u] = loads_[u] + (contact_ ? contact_force_[u] : 0);
  }
}

void ExplicitMotion::set_velocity(const std::vector<deck::InitialVelocity>& entries) {
  const auto d = static_cast<std::size_t>(scene_.dimension());
  for (const deck::InitialVelocity& entry : entries)
    for (const LocalIndex i : scene_.body().sets.at(entry.set)) {
      const deck::Point x = scene_.body().position3(i);
      for (std::size_t c = 0; c < d; ++c) {
        const std::size_t u = static_cast<std::size_t>(i) * d + c;
        velocity_[u] = entry.component[c] && !prescribed(u) ? (*entry.component[c])(x[0], x[1], x[2], 0) : 0;
      }
    }
}

double ExplicitMotion::stable_time_step() {
  if (!lambda_) {
    const std::vector<char>& held = boundary_.prescribed();
    double lambda = largest_eigenvalue(scene_, committed(), masses_, held, evaluation_);
    // The bound is one of the undeformed body: stretched, it may have become less than the truth.
    if (const auto bound = time_steps_ == 0 ? eigenvalue_bound(scene_, masses_) : std::nullopt)
      lambda = std::min(lambda, *bound);
    if (contact_) lambda += contact_->largest_eigenvalue(masses_);
    if (!std::isfinite(lambda))
      throw RunError(
          fmt::format("the largest eigenvalue of the tangent over the masses is {}: there is no stable time "
                      "step; look at the units of moduli, densities and lengths",
                      lambda));
    lambda_ = lambda;
  }
  return *lambda_ > 0 ? settings_.safety * 2 / std::sqrt(*lambda_) : std::numeric_limits<double>::infinity();
}

void ExplicitMotion::gather_sums() {
  std::vector<double> sums{work_, damped_, dissipated_};
  scene_.body().communicator.sum(sums);
  before_.work += sums[0];
  before_.damped += sums[1];
  before_.dissipated += sums[2];
  work_ = damped_ = dissipated_ = 0;
}

void ExplicitMotion::start_moving() {
  moving_ = true;
  boundary_.impose_velocity(t(), velocity_.data());
  const auto d = static_cast<std::size_t>(scene_.dimension());
  for (std::size_t u = 0; u < velocity_.size(); ++u) work_ += 0.5 * masses_[u / d] * velocity_[u] * velocity_[u];
  if (boundary_.has_forces()) boundary_.external_force(t(), loads_.data());
  evaluate();
  accelerate();
  work_ -= lag(masses_, acceleration_, d, last_step_);
  trial_.stored += trial_.dissipated;  // flow that a break has set off is the first time step's
  at_start_ = scene_.body().communicator.sum(trial_.stored + contact_energy_);
}

/// From the forces and velocities as they are.
void ExplicitMotion::accelerate() {
  const auto d = static_cast<std::size_t>(scene_.dimension());
  for (std::size_t u = 0; u < velocity_.size(); ++u)
    if (!prescribed(u))
      acceleration_[u] = (force_[u] + external_[u]) / masses_[u / d] - settings_.damping * velocity_[u];
}

void ExplicitMotion::evaluate() {
  mechanics::internal_force_in_motion(*evaluation_, committed_, trial_, force_.data());
  trial_.stored -= loads::loose_energy(scene_, boundary_.loose(), trial_.stored_energy);
  if (contact_) {
    std::fill(contact_force_.begin(), contact_force_.end(), 0.0);
    contact_energy_ = contact_->add_forces(trial_.displacement.data(), contact_force_.data());
    for (std::size_t u = 0; u < external_.size(); ++u) external_[u] = loads_[u] + contact_force_[u];
  } else if (boundary_.has_forces()) {
    external_ = loads_;
  }
}

void ExplicitMotion::begin(double dt) {
  if (moving_) return;
  last_step_ = dt;
  start_moving();
}

void ExplicitMotion::step(double dt) {
  begin(dt);
  for (std::size_t k = 0; k < held_.size(); ++k) {
    const std::size_t u = held_[k];
    held_displacement_[k] = trial_.displacement[u];
    held_velocity_[k] = velocity_[u];
    held_force_[k] = force_[u] + (contact_ ? contact_force_[u] : 0);
  }
  drift(dt);
  time_ += dt;
  last_step_ = dt;
  ++time_steps_;
  impose(dt);
  if (boundary_.forces_change() && settings_.rate != 0) boundary_.external_force(t(), loads_.data());
  evaluate();
  kick(dt);
  dissipated_ += trial_.dissipated;
  trial_.t = t();
  up_to_date_ = false;
  if (!history_) return;
  committed_.advance(*evaluation_, std::move(trial_));
  trial_.displacement = committed_.displacement();
  up_to_date_ = true;
}

/// Half a kick, the way, and what of the sums belongs to the beginning of the step. On prescribed unknowns nothing
/// that impose() would not write over.
void ExplicitMotion::drift(double dt) {
  const auto d = static_cast<std::size_t>(scene_.dimension());
  const double half = 0.5 * dt, damping = settings_.damping;
  const bool counts = damping > 0 || boundary_.has_forces();
  double damped = 0, work = 0;
  for (std::size_t i = 0, u = 0; i < masses_.size(); ++i)
    for (std::size_t c = 0; c < d; ++c, ++u) {
      const double before = velocity_[u], v = before + half * acceleration_[u];
      velocity_[u] = v;
      trial_.displacement[u] += dt * v;
      if (!counts || prescribed(u)) continue;
      damped += masses_[i] * before * v;
      work += loads_[u] * v;
    }
  damped_ += half * damping * damped;
  work_ += half * work;
}

void ExplicitMotion::impose(double dt) {
  if (held_.empty()) return;
  boundary_.impose(t(), trial_.displacement.data());
  const std::vector<char>& driven = boundary_.driven_by_velocity();
  boundary_.impose_velocity(t(), velocity_.data());
  for (std::size_t k = 0; k < held_.size(); ++k) {
    const std::size_t u = held_[k];
    if (!driven.empty() && driven[u])
      trial_.displacement[u] = held_displacement_[k] + 0.5 * dt * (held_velocity_[k] + velocity_[u]);
    else
      velocity_[u] = (trial_.displacement[u] - held_displacement_[k]) / dt;
  }
}

void ExplicitMotion::kick(double dt) {
  const auto d = static_cast<std::size_t>(scene_.dimension());
  const double half = 0.5 * dt, damping = settings_.damping, share = 1 / (1 + half * damping);
  const bool outside = contact_ || boundary_.has_forces(), loaded = boundary_.has_forces();
  double damped = 0, work = 0;
  for (std::size_t i = 0, u = 0; i < masses_.size(); ++i) {
    const double inverse = 1 / masses_[i];
    for (std::size_t c = 0; c < d; ++c, ++u) {
      if (prescribed(u)) continue;
      const double midway = velocity_[u];
      const double pull = (outside ? force_[u] + external_[u] : force_[u]) * inverse;
      const double after = (midway + half * pull) * share;
      acceleration_[u] = pull - damping * after;
      velocity_[u] = after;
      if (damping > 0) damped += masses_[i] * after * midway;
      if (loaded) work += loads_[u] * midway;
    }
  }
  damped_ += half * damping * damped;
  work_ += half * work;
  // Whoever moves a prescribed unknown holds it against internal and contact forces, and moves its mass.
  for (std::size_t k = 0; k < held_.size(); ++k) {
    const std::size_t u = held_[k];
    const double force = force_[u] + (contact_ ? contact_force_[u] : 0);
    work_ -= 0.5 * (held_force_[k] + force) * (trial_.displacement[u] - held_displacement_[k]);
    work_ += 0.5 * masses_[u / d] * (velocity_[u] * velocity_[u] - held_velocity_[k] * held_velocity_[k]);
  }
}

void ExplicitMotion::bonds_have_broken() {
  if (contact_) contact_->refresh();
  if (!moving_) return;
  // The forces jump, and the kinetic energy that goes by the acceleration with them; the velocities do not.
  const auto d = static_cast<std::size_t>(scene_.dimension());
  double released = trial_.stored + contact_energy_ - lag(masses_, acceleration_, d, last_step_);
  evaluate();
  accelerate();
  trial_.stored += trial_.dissipated;  // flow that the break sets off is the next time step's
  released += lag(masses_, acceleration_, d, last_step_);
  released_ += scene_.body().communicator.sum(released - trial_.stored - contact_energy_);
}

MotionEnergies ExplicitMotion::energies() const {
  const auto d = static_cast<std::size_t>(scene_.dimension());
  double moving = 0;
  for (std::size_t u = 0; u < velocity_.size(); ++u) moving += masses_[u / d] * velocity_[u] * velocity_[u];
  std::vector<double> sums{
      0.5 * moving, lag(masses_, acceleration_, d, last_step_), trial_.stored, contact_energy_, dissipated_, damped_,
      work_};
  scene_.body().communicator.sum(sums);
  MotionEnergies e;
  e.moving = sums[0];
  e.kinetic = sums[0] - sums[1];
  e.stored = sums[2];
  e.contact = sums[3];
  e.dissipated = before_.dissipated + sums[4];
  e.damped = before_.damped + sums[5];
  e.external_work = before_.work + sums[6];
  e.released = released_;
  e.at_start = at_start_;
  return e;
}

bool ExplicitMotion::sound(const MotionEnergies& e) const {
  if (!std::isfinite(e.sum()) || !std::isfinite(e.external_work)) return false;
  // The scheme conserves its energy also where it is unstable: then the kinetic part grows without bound below zero. A
  // little below is what a load has that begins on a body at rest.
  if (-e.kinetic > 2 * std::abs(e.sum()) + least_energy_) return false;
  return e.gain() <= 0.5 * e.scale() + least_energy_;
}

long long ExplicitMotion::yielding() const { return scene_.body().communicator.sum(trial_.yielding); }

const mechanics::Committed& ExplicitMotion::committed() {
  if (!moving_) return committed_;
  if (!up_to_date_) {
    mechanics::Trial copy = trial_;
    committed_.advance(*evaluation_, std::move(copy));
    up_to_date_ = true;
  }
  return committed_;
}

mechanics::Committed ExplicitMotion::release() {
  committed();
  return std::move(committed_);
}

}  // namespace perinox::motion
