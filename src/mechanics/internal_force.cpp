#include "perinox/mechanics/internal_force.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "perinox/mechanics/kinematics.hpp"

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
    const materials::TrialHistory history{trial.point_history.data() + scene.history().point[i],
                                          trial.bond_history.data() + scene.history().bond[i]};
    const materials::PointResponse response =
        scene.material(i).respond(family, extension.data(), committed.history(scene, i), force_state.data(), history);
    trial.dilatation[i] = response.dilatation;
    trial.stored_energy[i] = response.stored_energy;
    trial.stored += volume[i] * response.stored_energy;
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

void internal_force(const Scene& scene, const Committed& committed, const double* displacement, Trial& trial,
                    double* force) {
  trial.displacement.resize(scene.local_unknowns());
  std::copy(displacement, displacement + scene.owned_unknowns(), trial.displacement.begin());
  scene.body().halo.update_ghosts(trial.displacement.data(), scene.dimension());
  trial.point_history.resize(committed.point_history().size());
  trial.bond_history.resize(committed.bond_history().size());
  trial.dilatation.resize(static_cast<std::size_t>(scene.owned()));
  trial.stored_energy.resize(static_cast<std::size_t>(scene.owned()));
  trial.stored = trial.dissipated = 0;
  trial.yielding = 0;

  std::vector<double> all(scene.local_unknowns(), 0.0);
  if (scene.dimension() == 3)
    force_of_points<3>(scene, committed, trial, all);
  else
    force_of_points<2>(scene, committed, trial, all);
  scene.body().halo.add_to_owners(all.data(), scene.dimension());
  std::copy(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(scene.owned_unknowns()), force);
}

std::string first_not_finite(const Scene& scene, const Trial& trial, const double* force) {
  const int d = scene.dimension();
  for (LocalIndex i = 0; i < scene.owned(); ++i) {
    const double* f = force + static_cast<std::size_t>(i) * d;
    if (std::all_of(f, f + d, [](double value) { return std::isfinite(value); })) continue;
    const deck::Point x = scene.body().position3(i);
    std::string sentence = fmt::format("the force on particle {} at ({:g}, {:g}, {:g}) is not finite",
                                       scene.body().id[i], x[0], x[1], x[2]);
    const bonds::Bonds& bonds = scene.bonds();
    for (std::int64_t b = bonds.offset[i]; b < bonds.offset[i + 1]; ++b) {
      const LocalIndex j = bonds.neighbor[b];
      double square = 0;
      for (int c = 0; c < d; ++c) {
        const auto ic = static_cast<std::size_t>(i) * d + c, jc = static_cast<std::size_t>(j) * d + c;
        const double y =
            scene.body().reference[jc] + trial.displacement[jc] - scene.body().reference[ic] - trial.displacement[ic];
        square += y * y;
      }
      if (square == 0)
        return sentence + fmt::format(": its bond to particle {} has collapsed to length zero", scene.body().id[j]);
      if (!std::isfinite(square))
        return sentence + fmt::format(": its bond to particle {} has no finite length", scene.body().id[j]);
    }
    return sentence;
  }
  return "";
}

}  // namespace perinox::mechanics
