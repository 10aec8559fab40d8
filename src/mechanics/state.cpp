#include "perinox/mechanics/state.hpp"

#include <algorithm>
#include <atomic>
#include <utility>

#include "evaluation.hpp"

namespace perinox::mechanics {

std::uint64_t Committed::new_version() {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

Committed::Committed(const Scene& scene)
    : displacement_(scene.local_unknowns(), 0.0),
      point_history_(static_cast<std::size_t>(scene.point_history().back()), 0.0),
      bond_history_(scene.from_sums() ? 0 : static_cast<std::size_t>(scene.bond_history().back()), 0.0),
      mean_(static_cast<std::size_t>(scene.owned()), 0.0),
      plastic_(std::make_shared<PlasticExtension>()),
      version_(new_version()) {}

void Committed::advance(const Scene& scene, Trial&& trial) {
  const bool flows = std::any_of(trial.flow.begin(), trial.flow.end(), [](double flow) { return flow != 0; });
  if (flows) {
    scene.evaluation().loops().advance(trial.displacement.data(), trial.mean.data(), trial.flow.data(), *plastic_);
    plastic_->mark(trial.flow);
  }
  t_ = trial.t;
  // Exchanged rather than moved: who commits every time step uses the trial's arrays again.
  std::swap(displacement_, trial.displacement);
  std::swap(point_history_, trial.point_history);
  std::swap(bond_history_, trial.bond_history);
  std::swap(mean_, trial.mean);
  version_ = new_version();
}

}  // namespace perinox::mechanics
