#pragma once
/// Runs of decks that are written in the test itself, and what they leave behind.
#include <fmt/format.h>
#include <mpi.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "perinox/core/error.hpp"
#include "perinox/deck/read.hpp"
#include "perinox/materials/material.hpp"
#include "perinox/mechanics/scene.hpp"
#include "perinox/stepping/load_stepper.hpp"
#include "perinox/stepping/time_stepper.hpp"
#include "support/decks.hpp"

namespace perinox::test {

/// Keeps every record of a run.
class Recorder : public Observer {
 public:
  void newton_iteration(const NewtonIteration& row) override { iterations.push_back(row); }
  void step_rejected(double t_from, double t_to, const std::string& reason) override {
    rejected.push_back({t_from, t_to});
    reasons.push_back(reason);
  }
  void run_begins(const StepRecord& record) override {
    begins.push_back(record);
    begins.back().fields.clear();
  }
  void step_committed(const StepRecord& record) override {
    steps.push_back(record);
    steps.back().fields.clear();  // they point into the stepper
  }
  void run_stopped(const StepRecord* last) override { stopped_after = last ? last->step : 0; }
  /// Residuals of the last attempt at one step, iteration 0 first.
  std::vector<double> residuals(int step) const {
    std::vector<double> found;
    for (const NewtonIteration& row : iterations) {
      if (row.step != step) continue;
      if (row.iteration == 0) found.clear();
      found.push_back(row.residual);
    }
    return found;
  }

  std::vector<NewtonIteration> iterations;
  std::vector<StepRecord> begins;  ///< step 0; empty for a run that goes on
  std::vector<StepRecord> steps;
  std::vector<std::pair<double, double>> rejected;
  std::vector<std::string> reasons;
  int stopped_after = -1;  ///< last converged step as reported on stopping; -1: the run did not stop short
};

/// A finished run: its records, and the final displacement and force by particle id (owned particles of this rank).
struct RunResult {
  Recorder records;
  std::map<GlobalId, std::vector<double>> displacement, force;
  std::string stopped;  ///< the reason, if it stopped short
  stepping::Energies energies;
  motion::MotionEnergies motion;  ///< for `dynamics: explicit`
  std::string preconditioner;
};

/// Runs a stepper and keeps the last force and displacement.
template <class Stepper>
RunResult run_with(Stepper& stepper) {
  RunResult run;
  try {
    stepper.run(run.records);
  } catch (const RunError& error) {
    run.stopped = error.what();
  }
  return run;
}

inline void keep(const mechanics::Scene& scene, const std::vector<double>& displacement,
                 const std::vector<double>& force, RunResult& run) {
  const int d = scene.dimension();
  for (LocalIndex i = 0; i < scene.owned(); ++i)
    for (int c = 0; c < d; ++c) {
      const auto u = static_cast<std::size_t>(i) * d + c;
      run.displacement[scene.body().id[i]].push_back(displacement[u]);
      run.force[scene.body().id[i]].push_back(force[u]);
    }
}

inline RunResult run_deck(const deck::Deck& deck, MPI_Comm comm = MPI_COMM_SELF) {
  const Communicator ranks(comm);
  mechanics::Scene scene = mechanics::build_scene(deck, ranks);
  if (deck.dynamics == deck::Dynamics::explicit_) {
    stepping::TimeStepper stepper(deck, scene);
    RunResult run = run_with(stepper);
    keep(scene, stepper.motion().committed().displacement(), stepper.motion().force(), run);
    run.motion = stepper.energies();
    run.energies = {run.motion.stored, run.motion.dissipated, run.motion.external_work};
    return run;
  }
  stepping::LoadStepper stepper(deck, scene);
  RunResult run = run_with(stepper);
  keep(scene, stepper.committed().displacement(), stepper.force(), run);
  run.energies = stepper.energies();
  run.preconditioner = stepper.newton().system().preconditioner_name();
  return run;
}

/// Largest difference of two fields over the largest size. The first field may hold a part of the second's particles.
inline double relative_difference(const std::map<GlobalId, std::vector<double>>& part,
                                  const std::map<GlobalId, std::vector<double>>& whole) {
  double difference = 0, size = 0;
  for (const auto& [id, values] : whole)
    for (const double value : values) size = std::max(size, std::abs(value));
  for (const auto& [id, values] : part)
    for (std::size_t c = 0; c < values.size(); ++c)
      difference = std::max(difference, std::abs(values[c] - whole.at(id)[c]));
  return size > 0 ? difference / size : difference;
}

/// A perfectly plastic aluminium cube of n^3 particles of spacing h (mm). Two layers are held at each end in z, and it
/// is pulled by `pull` (mm) over `steps` steps.
inline std::string pulled_cube(int n, double pull, int steps, const std::string& extra = "", double h = 1) {
  return fmt::format(R"(
title: pulled cube
dimension: 3
body:
  - {{name: cube, shape: {{box: {{min: [0, 0, 0], max: [{0}, {0}, {0}]}}}}, spacing: {1}, material: aluminium}}
horizon: {{ratio: 3.015}}
materials:
  aluminium: {{model: elastic-plastic, bulk_modulus: 67.5e3, shear_modulus: 25.9e3, yield_stress: {{shear: 117.3}}}}
sets:
  foot: {{where: "z < {2}"}}
  head: {{where: "z > {3}"}}
boundary:
  - {{set: foot, displacement: {{x: 0, y: 0, z: 0}}}}
  - {{set: head, displacement: {{x: 0, y: 0, z: "{4}*t"}}}}
steps: {{end: 1.0, count: {5}}}
history:
  - {{name: pull, reaction: head, component: z}}
  - {{name: hold, reaction: foot, component: z}}
  - {{name: stretch, displacement: head, component: z}}
{6})",
                     n * h, h, 2 * h, (n - 2) * h, pull, steps, extra);
}

}  // namespace perinox::test
