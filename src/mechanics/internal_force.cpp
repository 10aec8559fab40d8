#include "perinox/mechanics/internal_force.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "evaluation.hpp"
#include "stored_force.hpp"

namespace perinox::mechanics {

namespace {

void prepare(const Scene& scene, const Committed& committed, Trial& trial) {
  const auto owned = static_cast<std::size_t>(scene.owned());
  trial.point_history.resize(committed.point_history().size());
  trial.dilatation.resize(owned);
  trial.mean.assign(owned, 0.0);
  trial.stored_energy.resize(owned);
  trial.flow.resize(scene.plastic() ? owned : 0);
  trial.stored = trial.unflowed = trial.dissipated = 0;
  trial.yielding = 0;
}

/// The materials' answers to the sums of the last evaluation: what the sweep of the forces needs, and the trial.
Evaluation::Law& answers(const Scene& scene, const Committed& committed, Trial& trial) {
  Evaluation& evaluation = scene.evaluation();
  const auto owned = static_cast<std::size_t>(scene.owned());
  Evaluation::Law& law = evaluation.law();
  law.radial.resize(owned);
  law.shear.resize(owned);
  law.yielded.resize(evaluation.has_back_stress() ? owned : 0);
  law.state.resize(scene.families().moments.size());
  materials::StrainFit fit;
  for (LocalIndex i = 0; i < scene.owned(); ++i) {
    const materials::PointState point =
        scene.material(i).state(evaluation.sums(scene, committed, i, fit), committed.point_history(scene, i),
                                trial.point_history.data() + scene.point_history()[i]);
    const bonds::Moment* moment = scene.families().moment(i);
    law.radial[i] = moment ? 0 : point.radial;
    law.shear[i] = point.shear;
    if (!law.yielded.empty()) law.yielded[i] = point.shear - point.back;
    if (moment) law.state[static_cast<std::size_t>(scene.families().fit[i])] = force_of_fit(*moment, fit, point);
    trial.mean[i] = point.mean;
    if (!trial.flow.empty()) trial.flow[i] = point.flow;
    trial.dilatation[i] = point.response.dilatation;
    trial.stored_energy[i] = point.response.stored_energy;
    trial.stored += scene.body().volume[i] * point.response.stored_energy;
    trial.unflowed += scene.body().volume[i] * point.response.unflowed_energy;
    trial.dissipated += scene.body().volume[i] * point.response.dissipation;
    trial.yielding += point.response.yielding ? 1 : 0;
  }
  return law;
}

/// By the sweeps: sums, the materials' answers to them, forces.
void swept_force(const Scene& scene, const Committed& committed, const double* displacement, Trial& trial,
                 std::vector<double>& force) {
  Evaluation& evaluation = scene.evaluation();
  evaluation.at(scene, committed, displacement);
  trial.displacement = evaluation.displacement();
  const Evaluation::Law& law = answers(scene, committed, trial);
  evaluation.loops().forces(law.radial.data(), law.shear.data(), law.yielded.empty() ? nullptr : law.yielded.data(),
                            law.state.data(), committed.plastic(), force.data());
}

}  // namespace

void internal_force(const Scene& scene, const Committed& committed, const double* displacement, Trial& trial,
                    double* force) {
  prepare(scene, committed, trial);
  std::vector<double> all(scene.local_unknowns(), 0.0);
  if (scene.from_sums()) {
    swept_force(scene, committed, displacement, trial, all);
  } else {
    trial.displacement.resize(scene.local_unknowns());
    std::copy(displacement, displacement + scene.owned_unknowns(), trial.displacement.begin());
    scene.body().halo.update_ghosts(trial.displacement.data(), scene.dimension());
    stored_force(scene, committed, trial, all);
  }
  scene.body().halo.add_to_owners(all.data(), scene.dimension());
  std::copy(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(scene.owned_unknowns()), force);
}

double unflowed_energy(const Scene& scene, const Committed& committed, const double* displacement) {
  Evaluation& evaluation = scene.evaluation();
  evaluation.at(scene, committed, displacement);
  double energy = 0;
  std::vector<double> scratch;
  materials::StrainFit fit;
  for (LocalIndex i = 0; i < scene.owned(); ++i) {
    scratch.resize(static_cast<std::size_t>(scene.point_history()[i + 1] - scene.point_history()[i]));
    const materials::PointState point = scene.material(i).state(evaluation.sums(scene, committed, i, fit),
                                                                committed.point_history(scene, i), scratch.data());
    energy += scene.body().volume[i] * point.response.unflowed_energy;
  }
  return energy;
}

void force_states(const Scene& scene, const Committed& state, double* points) {
  Evaluation& evaluation = scene.evaluation();
  evaluation.at(scene, state, state.displacement().data());
  const auto n = static_cast<std::size_t>(bonds::mandel_size(scene.dimension()));
  std::vector<double> scratch;
  materials::StrainFit fit;
  for (LocalIndex i = 0; i < scene.owned(); ++i) {
    scratch.resize(static_cast<std::size_t>(scene.point_history()[i + 1] - scene.point_history()[i]));
    const materials::PointState point =
        scene.material(i).state(evaluation.sums(scene, state, i, fit), state.point_history(scene, i), scratch.data());
    const bonds::Moment* moment = scene.families().moment(i);
    double* to = points + (2 + n) * static_cast<std::size_t>(i);
    to[0] = moment ? 0 : point.radial;
    to[1] = point.shear;
    const bonds::Mandel along = moment ? force_of_fit(*moment, fit, point) : bonds::Mandel{};
    std::copy_n(along.begin(), n, to + 2);
  }
}

void internal_force_in_motion(const Scene& scene, const Committed& committed, Trial& trial, double* force) {
  const Profile::Scope timed(scene.body().communicator.profile(), Section::force);
  if (!scene.from_sums()) {
    const std::vector<double> displacement(
        trial.displacement.begin(), trial.displacement.begin() + static_cast<std::ptrdiff_t>(scene.owned_unknowns()));
    internal_force(scene, committed, displacement.data(), trial, force);
    return;
  }
  prepare(scene, committed, trial);
  Evaluation& evaluation = scene.evaluation();
  evaluation.moved(scene, committed, trial.displacement.data());
  const Evaluation::Law& law = answers(scene, committed, trial);
  evaluation.loops().moving_forces(law.radial.data(), law.shear.data(),
                                   law.yielded.empty() ? nullptr : law.yielded.data(), law.state.data(),
                                   committed.plastic(), force);
}

void force_states_in_motion(const Scene& scene, double* points) {
  const Evaluation::Law& law = scene.evaluation().law();
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
