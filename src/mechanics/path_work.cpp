#include "perinox/mechanics/path_work.hpp"

#include "evaluation.hpp"

namespace perinox::mechanics {

namespace {

/// The state at a displacement, [local * dimension], as seen from the committed one.
Trial state_at(const Scene& scene, const Committed& committed, const std::vector<double>& displacement) {
  Trial trial;
  trial.prepare(scene, committed);
  scene.evaluation().at(scene, committed, displacement.data());
  scene.evaluation().answers(scene, committed, trial);
  return trial;
}

/// Of the state that state_at() was asked for last.
double turning_work(const Scene& scene, const Committed& committed, const std::vector<double>& step) {
  const Evaluation::Law& law = scene.evaluation().law();
  return scene.evaluation().loops().turning_work(law.radial.data(), law.shear.data(),
                                                 law.yielded.empty() ? nullptr : law.yielded.data(), law.state.data(),
                                                 committed.plastic(), step.data());
}

}  // namespace

PathWork::PathWork(const Scene& scene, const Committed& committed, const Trial& trial) {
  if (!scene.from_sums()) return;
  const bool turns = !scene.small_strain(), flows = scene.body().communicator.any(trial.yielding > 0);
  std::vector<double> step;
  if (turns) {
    step = committed.displacement();
    for (std::size_t u = 0; u < step.size(); ++u) step[u] -= trial.displacement[u];
    state_at(scene, committed, trial.displacement);
    work_ -= 0.5 * turning_work(scene, committed, step);
  }
  if (!turns && !flows) return;
  const double energy = state_at(scene, committed, committed.displacement()).unflowed;
  if (turns) {
    for (double& u : step) u = -u;
    work_ += 0.5 * turning_work(scene, committed, step);
  }
  if (!flows) return;
  // Plastic work less the mean force state of the step's two ends over its flow, which is
  // (W(u0, p0) - W(u0, p1) + W(u1, p0) - W(u1, p1))/2 for a quadratic W(u, p).
  work_ += trial.dissipated - 0.5 * (energy + trial.unflowed - trial.stored);
  start_ = committed.displacement();
}

double PathWork::beyond_chord(const Scene& scene, const Committed& committed) const {
  return start_.empty() ? work_ : work_ + 0.5 * state_at(scene, committed, start_).unflowed;
}

}  // namespace perinox::mechanics
