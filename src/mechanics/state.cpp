#include "perinox/mechanics/state.hpp"

#include <algorithm>
#include <utility>

#include "perinox/mechanics/evaluation.hpp"

namespace perinox::mechanics {

void Trial::prepare(const Scene& scene, const Committed& committed) {
  const auto owned = static_cast<std::size_t>(scene.owned());
  point_history.resize(committed.point_history().size());
  dilatation.resize(owned);
  mean.assign(owned, 0.0);
  stored_energy.resize(owned);
  flow.resize(scene.plastic_here() ? owned : 0);
  stored = unflowed = dissipated = 0;
  yielding = 0;
}

Committed::Committed(const Scene& scene)
    : displacement_(scene.local_unknowns(), 0.0),
      point_history_(static_cast<std::size_t>(scene.point_history().back()), 0.0),
      bond_history_(scene.from_sums() ? 0 : static_cast<std::size_t>(scene.bond_history().back()), 0.0),
      mean_(static_cast<std::size_t>(scene.owned()), 0.0),
      plastic_(std::make_shared<PlasticExtension>()),
      version_(medium::new_version()) {}

bonds::BrokenElastic Committed::broken_elastic(const Scene& scene, LocalIndex i) const {
  // Of a particle without bonds nothing is left.
  return broken_elastic_.empty() || scene.families().size[i] == 0 ? bonds::BrokenElastic()
                                                                  : broken_elastic_[static_cast<std::size_t>(i)];
}

/// e_p += flow (e - mean xi - e_p) of the broken bonds, as of the others: e - e_p becomes (1 - flow) (e - e_p) + flow
/// mean xi.
void Committed::flow_of_broken(const Scene& scene, const Trial& trial) {
  const std::vector<bonds::BrokenExtension>& broken = scene.families().broken_extension;
  if (broken.empty()) return;
  broken_elastic_.resize(broken.size());
  for (std::size_t i = 0; i < broken.size(); ++i) {
    if (trial.flow[i] == 0) continue;
    bonds::BrokenElastic& of = broken_elastic_[i];
    const double rest = 1 - trial.flow[i], added = trial.flow[i] * trial.mean[i];
    double along = 0, volume = 0;  // traces: sum omega xi (e - e_p) weight, sum omega xi^2 weight
    for (std::size_t k = 0; k < static_cast<std::size_t>(scene.dimension()); ++k) {
      along += of.fit[k];
      volume += broken[i].second[k];
    }
    of.square = rest * rest * of.square + added * (2 * rest * along + added * volume);
    for (std::size_t k = 0; k < of.fit.size(); ++k) of.fit[k] = rest * of.fit[k] + added * broken[i].second[k];
  }
}

void Committed::advance(Evaluation& evaluation, Trial&& trial) {
  const bool flows = std::any_of(trial.flow.begin(), trial.flow.end(), [](double flow) { return flow != 0; });
  if (flows) {
    evaluation.loops().advance(trial.displacement.data(), trial.mean.data(), trial.flow.data(), *plastic_);
    plastic_->mark(trial.flow);
    flow_of_broken(evaluation.scene(), trial);
  }
  t_ = trial.t;
  // Exchanged rather than moved: who commits every time step uses the trial's arrays again.
  std::swap(displacement_, trial.displacement);
  std::swap(point_history_, trial.point_history);
  std::swap(bond_history_, trial.bond_history);
  std::swap(mean_, trial.mean);
  trial.version = 0;  // its displacement is another one now
  version_ = medium::new_version();
}

}  // namespace perinox::mechanics
