#include "stored_force.hpp"

#include "kinematics.hpp"

namespace perinox::mechanics {

namespace {

template <int d>
void force_of_points(const Scene& scene, const Committed& committed, Trial& trial, std::vector<double>& force) {
  const bonds::Bonds& bonds = scene.bonds();
  const std::vector<double>& volume = scene.body().volume;
  const auto largest = static_cast<std::size_t>(scene.largest_family());
  std::vector<double> extension(largest), stretched(largest), force_state(largest), direction(largest * d);

  for (LocalIndex i = 0; i < scene.owned(); ++i) {
    const materials::Family family = scene.family(i);
    family_kinematics<d>(scene, i, trial.displacement.data(), extension.data(), direction.data(), stretched.data());
    const std::int64_t place = scene.bond_history()[i];
    const materials::PointResponse response = scene.material(i).respond(
        family, extension.data(), {committed.point_history(scene, i), committed.bond_history().data() + place},
        force_state.data(), {trial.point_history.data() + scene.point_history()[i], trial.bond_history.data() + place});
    trial.dilatation[i] = response.dilatation;
    trial.stored_energy[i] = response.stored_energy;
    trial.stored += volume[i] * response.stored_energy;
    trial.unflowed += volume[i] * response.unflowed_energy;
    trial.dissipated += volume[i] * response.dissipation;
    trial.yielding += response.yielding ? 1 : 0;

    const LocalIndex* neighbor = bonds.neighbor.data() + bonds.offset[i];
    double own[d] = {};
    for (int j = 0; j < family.count; ++j) {
      const double strength = volume[i] * family.weight[j] * force_state[j];
      double* other = &force[static_cast<std::size_t>(neighbor[j]) * d];
      for (int c = 0; c < d; ++c) {
        const double pull = strength * direction[j * d + c];
        own[c] += pull;
        other[c] -= pull;
      }
    }
    for (int c = 0; c < d; ++c) force[static_cast<std::size_t>(i) * d + c] += own[c];
  }
}

}  // namespace

void stored_force(const Scene& scene, const Committed& committed, Trial& trial, std::vector<double>& force) {
  trial.bond_history.resize(committed.bond_history().size());
  if (scene.dimension() == 3)
    force_of_points<3>(scene, committed, trial, force);
  else
    force_of_points<2>(scene, committed, trial, force);
}

}  // namespace perinox::mechanics
