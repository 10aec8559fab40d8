#include "path_work.hpp"

namespace perinox::mechanics {

namespace {

/// The state at a displacement as seen from the committed one.
Trial state_at(Evaluation& evaluation, const Committed& committed, const medium::At& at) {
  Trial trial;
  trial.prepare(evaluation.scene(), committed);
  evaluation.at(committed, at);
  evaluation.answers(committed, trial);
  return trial;
}

/// What turning bonds do over a step that begins or ends at the state of the last state_at(). step: [local *
/// dimension].
double turning_work(Evaluation& evaluation, const Committed& committed, const std::vector<double>& step) {
  const Evaluation::Law& law = evaluation.law();
  return evaluation.loops().turning_work(law.radial.data(), law.shear.data(), law.yielded_or_null(), law.state.data(),
                                         committed.plastic(), step.data());
}

}  // namespace

PathWork::PathWork(Evaluation& evaluation, const Committed& committed, const Trial& trial) {
  const Scene& scene = evaluation.scene();
  if (!scene.from_sums()) return;
  const bool turns = !scene.small_strain(), flows = scene.body().communicator.any(trial.yielding > 0);
  std::vector<double> step;
  if (turns) {
    step = committed.displacement();
    for (std::size_t u = 0; u < step.size(); ++u) step[u] -= trial.displacement[u];
    state_at(evaluation, committed, trial.at());
    work_ -= 0.5 * turning_work(evaluation, committed, step);
  }
  if (!turns && !flows) return;
  const double energy = state_at(evaluation, committed, committed.at()).unflowed;
  if (turns) {
    for (double& u : step) u = -u;
    work_ += 0.5 * turning_work(evaluation, committed, step);
  }
  if (!flows) return;
  // Plastic work less the mean force state of the step's two ends over its flow, which is
  // (W(u0, p0) - W(u0, p1) + W(u1, p0) - W(u1, p1))/2 for a quadratic W(u, p).
  work_ += trial.dissipated - 0.5 * (energy + trial.unflowed - trial.stored);
  start_.emplace(committed.displacement());
}

double PathWork::beyond_chord(Evaluation& evaluation, const Committed& committed) const {
  return start_ ? work_ + 0.5 * state_at(evaluation, committed, start_->at()).unflowed : work_;
}

}  // namespace perinox::mechanics
