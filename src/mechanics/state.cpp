#include "perinox/mechanics/state.hpp"

#include <algorithm>
#include <atomic>

#include "evaluation.hpp"

namespace perinox::mechanics {

namespace {
std::uint64_t next_version() {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}
}  // namespace

Committed::Committed(const Scene& scene)
    : displacement_(scene.local_unknowns(), 0.0),
      point_history_(static_cast<std::size_t>(scene.point_history().back()), 0.0),
      bond_history_(scene.from_sums() ? 0 : static_cast<std::size_t>(scene.bond_history().back()), 0.0),
      mean_(static_cast<std::size_t>(scene.owned()), 0.0),
      plastic_(std::make_shared<PlasticExtension>()),
      version_(next_version()) {}

void Committed::advance(const Scene& scene, Trial&& trial) {
  const bool flows = std::any_of(trial.flow.begin(), trial.flow.end(), [](double flow) { return flow != 0; });
  if (flows)
    scene.evaluation().loops().advance(trial.displacement.data(), trial.mean.data(), trial.flow.data(), *plastic_);
  t_ = trial.t;
  displacement_ = std::move(trial.displacement);
  point_history_ = std::move(trial.point_history);
  bond_history_ = std::move(trial.bond_history);
  mean_ = std::move(trial.mean);
  version_ = next_version();
}

}  // namespace perinox::mechanics
