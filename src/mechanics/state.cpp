#include "perinox/mechanics/state.hpp"

namespace perinox::mechanics {

Committed::Committed(const Scene& scene)
    : displacement_(scene.local_unknowns(), 0.0),
      point_history_(static_cast<std::size_t>(scene.history().point.back()), 0.0),
      bond_history_(static_cast<std::size_t>(scene.history().bond.back()), 0.0) {}

Committed::Committed(Trial&& trial)
    : t_(trial.t),
      displacement_(std::move(trial.displacement)),
      point_history_(std::move(trial.point_history)),
      bond_history_(std::move(trial.bond_history)) {}

}  // namespace perinox::mechanics
