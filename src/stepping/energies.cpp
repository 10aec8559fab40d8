#include "perinox/stepping/energies.hpp"

#include <algorithm>
#include <cmath>

#include "perinox/motion/explicit_motion.hpp"

namespace perinox::stepping {

double Energies::unaccounted() const {
  return scale > 0 ? (external_work - stored - dissipated - released - relaxed - damped) / scale : 0;
}

double Energies::lost_since(const Energies& before) const {
  return before.stored - stored + before.dissipated - dissipated + external_work - before.external_work;
}

void Energies::add_phase(const motion::MotionEnergies& phase) {
  stored = phase.stored;
  dissipated += phase.dissipated;
  external_work += phase.external_work;
  released += phase.released;
  damped += phase.damped + phase.kinetic + phase.contact;
}

void Energies::raise_scale(double least) {
  scale = std::max({scale, std::abs(external_work), std::abs(stored), std::abs(dissipated), least});
}

}  // namespace perinox::stepping
