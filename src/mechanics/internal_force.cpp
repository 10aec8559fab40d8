#include "perinox/mechanics/internal_force.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "stored_force.hpp"

namespace perinox::mechanics {

void internal_force(Evaluation& evaluation, const Committed& committed, const medium::At& at, Trial& trial,
                    double* force) {
  const Scene& scene = evaluation.scene();
  trial.prepare(scene, committed);
  trial.version = at.version;
  std::vector<double> all(scene.local_unknowns(), 0.0);
  if (scene.from_sums()) {
    evaluation.at(committed, at);
    trial.displacement = evaluation.displacement();
    const Evaluation::Law& law = evaluation.answers(committed, trial);
    evaluation.loops().forces(law.radial.data(), law.shear.data(), law.yielded_or_null(), law.state.data(),
                              committed.plastic(), all.data());
  } else {
    trial.displacement.resize(scene.local_unknowns());
    std::copy(at.displacement, at.displacement + scene.owned_unknowns(), trial.displacement.begin());
    scene.body().halo.update_ghosts(trial.displacement.data(), scene.dimension());
    stored_force(scene, committed, trial, all);
  }
  scene.body().halo.add_to_owners(all.data(), scene.dimension());
  std::copy(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(scene.owned_unknowns()), force);
}

void internal_force_in_motion(Evaluation& evaluation, const Committed& committed, Trial& trial, double* force) {
  const Scene& scene = evaluation.scene();
  const Profile::Scope timed(scene.body().communicator.profile(), Section::force);
  if (!scene.from_sums()) {
    const std::vector<double> displacement(
        trial.displacement.begin(), trial.displacement.begin() + static_cast<std::ptrdiff_t>(scene.owned_unknowns()));
    internal_force(evaluation, committed, displacement.data(), trial, force);
    return;
  }
  trial.prepare(scene, committed);
  trial.version = 0;  // a motion numbers no states
  evaluation.moved(committed, trial.displacement.data());
  const Evaluation::Law& law = evaluation.answers(committed, trial);
  evaluation.loops().moving_forces(law.radial.data(), law.shear.data(), law.yielded_or_null(), law.state.data(),
                                   committed.plastic(), force);
}

void force_states(Evaluation& evaluation, const Committed& state, double* points) {
  Trial trial;
  trial.prepare(evaluation.scene(), state);
  evaluation.at(state, state.at());
  evaluation.answers(state, trial);
  held_force_states(evaluation, points);
}

void held_force_states(const Evaluation& evaluation, double* points) {
  const Evaluation::Law& law = evaluation.law();
  const Scene& scene = evaluation.scene();
  const auto n = static_cast<std::size_t>(bonds::mandel_size(scene.dimension()));
  const std::vector<std::int32_t>& fit = scene.families().fit;
  for (LocalIndex i = 0; i < scene.owned(); ++i, points += 2 + n) {
    points[0] = law.radial[i];
    points[1] = law.shear[i];
    if (!fit.empty() && fit[i] >= 0)
      std::copy_n(law.state[static_cast<std::size_t>(fit[i])].begin(), n, points + 2);
    else
      std::fill_n(points + 2, n, 0.0);
  }
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
      // As the sweeps have it: what is left is the rounding of the two places.
      if (std::sqrt(square) <= 2e-13 * bonds.length[b])
        return sentence + fmt::format(": its bond to particle {} has collapsed to length zero", scene.body().id[j]);
      if (!std::isfinite(square))
        return sentence + fmt::format(": its bond to particle {} has no finite length", scene.body().id[j]);
    }
    return sentence;
  }
  return "";
}

}  // namespace perinox::mechanics
