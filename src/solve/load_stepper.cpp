#include "perinox/solve/load_stepper.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "perinox/core/error.hpp"
#include "perinox/solve/arc_length.hpp"

namespace perinox::solve {

namespace {
double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }
}  // namespace

std::unique_ptr<StepControl> LoadStepper::make_control() {
  if (deck_.steps.control == deck::Control::arc_length)
    return std::make_unique<ArcLength>(deck_, scene_, boundary_, newton_);
  return std::make_unique<LoadSteps>(deck_, scene_, boundary_, newton_);
}

LoadStepper::LoadStepper(const deck::Deck& deck, mechanics::Scene& scene)
    : deck_(deck),
      scene_(scene),
      boundary_(deck, scene),
      newton_(deck, scene, boundary_),
      control_(make_control()),
      committed_(scene),
      force_(scene.owned_unknowns(), 0.0),
      external_(scene.owned_unknowns(), 0.0),
      dilatation_(static_cast<std::size_t>(scene.owned()), 0.0),
      stored_energy_(static_cast<std::size_t>(scene.owned()), 0.0),
      history_names_(scene.point_history_names()),
      history_values_(history_names_.size(), std::vector<double>(static_cast<std::size_t>(scene.owned()), 0.0)) {
  const auto asks = [&](const char* field) {
    return std::find(deck.output.fields.begin(), deck.output.fields.end(), field) != deck.output.fields.end();
  };
  if (scene.from_sums() && (asks("stress") || asks("strain") || asks("von_mises_stress")))
    stress_ = std::make_unique<mechanics::Stress>(scene);
  if (deck.breaks()) breaking_ = std::make_unique<BondBreaking>(deck, scene);
  if (asks("plastic_work")) plastic_work_.resize(static_cast<std::size_t>(scene.owned()));
  for (const auto& material : scene.materials()) {
    std::vector<std::size_t>& places = history_place_.emplace_back();
    for (const std::string& name : material->history().point)
      places.push_back(static_cast<std::size_t>(std::find(history_names_.begin(), history_names_.end(), name) -
                                                history_names_.begin()));
  }
}

void LoadStepper::run(Observer& observer) {
  const Communicator& ranks = scene_.body().communicator;
  const double begin = now();
  double step_begin = begin;
  ProfileReading told = ranks.profile().read();  // at the last record
  while (!control_->finished()) {
    mechanics::Trial trial;
    std::vector<double> force;
    NewtonResult result = control_->attempt(committed_, step_ + 1, observer, trial, force);
    if (!result.converged) {
      const double tried = control_->tried();
      observer.step_rejected(committed_.t(), tried, result.reason);
      if (!control_->cut()) stop(observer, tried, result);
      continue;
    }
    if (converged_) converged_(committed_, trial);
    ++step_;
    control_->accept(committed_, trial);
    commit(std::move(trial), std::move(force));
    if (breaking_) {
      const std::string reason = break_bonds(observer, result);
      if (!reason.empty()) lost_equilibrium(observer, reason);
      if (passes_ > 0) control_->jumped();
    }
    last_result_ = result;
    const bool last = control_->finished();
    StepRecord row = record(result, last || step_ % deck_.output.every == 0);
    row.seconds = now() - step_begin;
    row.remaining_seconds = (now() - begin) * (1 / control_->share() - 1);
    row.last = last;
    const ProfileReading reading = ranks.profile().read();
    row.profile = ranks.slowest(reading - told);
    told = reading;
    observer.step_committed(row);
    step_begin = now();
  }
}

void LoadStepper::lost_equilibrium(Observer& observer, const std::string& reason) {
  --step_;
  const StepRecord last = record(last_result_, true);
  observer.run_stopped(step_ > 0 ? &last : nullptr);
  throw RunError(fmt::format("stopped at t = {:.10g} of {:g}, after {} converged steps: {}", committed_.t(),
                             deck_.steps.end, step_, reason));
}

void LoadStepper::stop(Observer& observer, double t, const NewtonResult& result) {
  const StepRecord last = record(last_result_, true);
  observer.run_stopped(step_ > 0 ? &last : nullptr);
  throw RunError(fmt::format(
      "stopped at t = {:.10g} of {:g}, after {} converged steps: the step to t = {:.10g} does not converge{}; {}",
      committed_.t(), deck_.steps.end, step_, t,
      deck_.steps.adaptive ? " at its smallest size" : " and steps.adaptive is false", result.reason));
}

void LoadStepper::commit(mechanics::Trial&& trial, std::vector<double>&& force) {
  std::vector<double> external(scene_.owned_unknowns());
  boundary_.external_force(trial.t, external.data());
  // Outside forces on the body: the given ones, and on prescribed unknowns whatever balances the internal force.
  double work = 0;
  for (std::size_t u = 0; u < force.size(); ++u) {
    const double before = boundary_.prescribed()[u] ? -force_[u] : external_[u];
    const double after = boundary_.prescribed()[u] ? -force[u] : external[u];
    work += 0.5 * (before + after) * (trial.displacement[u] - committed_.displacement()[u]);
  }
  std::vector<double> sums{work, trial.stored, trial.dissipated};
  scene_.body().communicator.sum(sums);
  energies_.external_work += sums[0];
  energies_.stored = sums[1];
  energies_.dissipated += sums[2];

  dilatation_ = std::move(trial.dilatation);
  stored_energy_ = std::move(trial.stored_energy);
  committed_.advance(scene_, std::move(trial));
  force_ = std::move(force);
  external_ = std::move(external);

  for (LocalIndex i = 0; i < scene_.owned(); ++i) {
    const std::vector<std::size_t>& places = history_place_[static_cast<std::size_t>(scene_.body().material[i])];
    for (std::size_t k = 0; k < places.size(); ++k)
      history_values_[places[k]][i] = committed_.point_history(scene_, i)[k];
  }
}

StepRecord LoadStepper::record(const NewtonResult& result, bool written) {
  StepRecord row;
  row.step = step_;
  row.t = committed_.t();
  row.newton_iterations = result.newton_iterations;
  row.linear_iterations = result.linear_iterations;
  row.stored_energy = energies_.stored;
  row.dissipated_energy = energies_.dissipated;
  row.external_work = energies_.external_work;
  if (breaking_) row.fracture = FractureRow{passes_, breaking_->broken(), energies_.released, energies_.relaxed};
  row.end = deck_.steps.end;
  row.history = history();
  row.fields = fields(written);
  return row;
}

std::vector<double> LoadStepper::history() const {
  std::vector<double> values;
  for (const deck::HistoryEntry& entry : deck_.history) values.push_back(entry_value(entry));
  return values;
}

double LoadStepper::entry_value(const deck::HistoryEntry& entry) const {
  const std::vector<LocalIndex>& set = scene_.body().sets.at(entry.set);
  const int d = scene_.dimension();
  std::vector<double> sums(2, 0.0);
  for (const LocalIndex i : set) {
    const auto unknown = static_cast<std::size_t>(i) * d + entry.component;
    sums[1] += 1;
    if (entry.kind == deck::HistoryKind::reaction) {
      sums[0] -= force_[unknown] + external_[unknown];  // what the support does to the body
    } else if (entry.kind == deck::HistoryKind::displacement) {
      sums[0] += committed_.displacement()[unknown];
    } else {
      for (std::size_t k = 0; k < history_names_.size(); ++k)
        if (history_names_[k] == "plastic_multiplier" && history_values_[k][i] > 0) sums[0] += 1;
    }
  }
  scene_.body().communicator.sum(sums);
  return entry.kind == deck::HistoryKind::reaction ? sums[0] : sums[0] / sums[1];
}

std::vector<Field> LoadStepper::fields(bool written) {
  std::vector<Field> all{{"displacement", scene_.dimension(), committed_.displacement().data()},
                         {"force", scene_.dimension(), force_.data()},
                         {"dilatation", 1, dilatation_.data()},
                         {"stored_energy", 1, stored_energy_.data()},
                         {"damage", 1, scene_.families().damage.data()},
                         {"weighted_volume", 1, scene_.families().weighted_volume.data()}};
  for (std::size_t k = 0; k < history_names_.size(); ++k)
    all.push_back({history_names_[k], 1, history_values_[k].data()});
  if (!plastic_work_.empty()) {
    for (LocalIndex i = 0; i < scene_.owned(); ++i)
      plastic_work_[i] = scene_.material(i).plastic_work(committed_.point_history(scene_, i));
    all.push_back({"plastic_work", 1, plastic_work_.data()});
  }
  if (stress_) {
    if (written) stress_->evaluate(committed_);
    all.push_back({"stress", 6, stress_->stress().data()});
    all.push_back({"strain", 6, stress_->strain().data()});
    all.push_back({"von_mises_stress", 1, stress_->von_mises().data()});
  }
  return all;
}

}  // namespace perinox::solve
