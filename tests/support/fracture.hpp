#pragma once
/// Decks whose bonds break.
#include <fmt/format.h>

#include <array>
#include <set>
#include <string>
#include <vector>

#include "support/runs.hpp"

namespace perinox::test {

using BrokenSet = std::set<std::array<GlobalId, 2>>;

/// Records the passes and the sentences too.
class FractureRecorder : public Recorder {
 public:
  void bonds_broken(const BreakingPass& row) override { passes.push_back(row); }
  void note(const std::string& sentence) override { notes.push_back(sentence); }
  void phase_begins(const MotionPhase& phase) override { begun.push_back(phase); }
  void phase_ended(const MotionPhase& phase) override { phases.push_back(phase); }
  bool noted(const std::string& part) const {
    return std::any_of(notes.begin(), notes.end(),
                       [&](const std::string& note) { return note.find(part) != std::string::npos; });
  }
  std::vector<BreakingPass> passes;
  std::vector<std::string> notes;
  std::vector<MotionPhase> begun, phases;
};

/// A quasi-static run and what it broke.
struct FractureRun {
  explicit FractureRun(deck::Deck the_deck, MPI_Comm comm = MPI_COMM_SELF)
      : deck(std::move(the_deck)), scene(mechanics::build_scene(deck, Communicator(comm))), stepper(deck, scene) {
    try {
      stepper.run(records);
    } catch (const RunError& error) {
      stopped = error.what();
    }
  }
  /// The bonds broken on this rank.
  BrokenSet broken() const { return {scene.broken().begin(), scene.broken().end()}; }
  /// Energy that the balance leaves unaccounted for, over the external work.
  double energy_gap() const {
    const stepping::Energies& e = stepper.energies();
    const double sum = e.stored + e.dissipated + e.released + e.relaxed + e.damped;
    return std::abs(sum / e.external_work - 1);
  }

  deck::Deck deck;
  mechanics::Scene scene;
  stepping::LoadStepper stepper;
  FractureRecorder records;
  std::string stopped;
};

inline deck::Deck input_deck(const std::string& name, const std::vector<std::string>& overrides = {}) {
  return deck::read(PERINOX_SOURCE_DIR "/inputs/" + name + ".yaml", materials::full_schema(), overrides);
}

/// A square of 12 x 12 particles of spacing 1, held at the bottom. damage: a law.
inline std::string square_plate(const std::string& damage, const std::string& rest = "") {
  return fmt::format(R"(
dimension: plane-stress
body: [{{name: plate, shape: {{box: {{min: [0, 0], max: [12, 12]}}}}, spacing: 1, material: brittle}}]
horizon: {{ratio: 3.015}}
quadrature: whole
materials: {{brittle: {{model: elastic, young_modulus: 1000, poisson_ratio: 0.3, damage: {{{}}}}}}}
sets: {{bottom: {{where: "y < 3"}}, top: {{where: "y > 9"}}, left: {{where: "x < 3"}}}}
boundary: [{{set: bottom, displacement: {{x: 0, y: 0}}}}]
{})",
                     damage, rest);
}

/// A scene of one rank that a test moves as it wants, without load steps.
struct Plate {
  explicit Plate(const std::string& yaml)
      : deck(deck_of(yaml)), scene(mechanics::build_scene(deck, Communicator(MPI_COMM_SELF))), committed(scene) {}
  /// Moves every particle by u(x, y).
  template <class Field>
  void move(const Field& field) {
    std::vector<double> u(scene.owned_unknowns()), force(scene.owned_unknowns());
    for (LocalIndex i = 0; i < scene.owned(); ++i) {
      const std::array<double, 2> value = field(scene.body().position(i)[0], scene.body().position(i)[1]);
      u[2 * i] = value[0];
      u[2 * i + 1] = value[1];
    }
    mechanics::Trial trial;
    mechanics::Evaluation evaluation(scene);
    mechanics::internal_force(evaluation, committed, u.data(), trial, force.data());
    stored = trial.stored;
    committed.advance(evaluation, std::move(trial));
  }
  double stored_now() {
    mechanics::Trial trial;
    std::vector<double> force(scene.owned_unknowns());
    mechanics::Evaluation evaluation(scene);
    mechanics::internal_force(evaluation, committed, committed.at(), trial, force.data());
    return trial.stored;
  }
  double stretch(const std::array<GlobalId, 2>& ids) const {
    const double *x = scene.body().position(static_cast<LocalIndex>(ids[0])),
                 *y = scene.body().position(static_cast<LocalIndex>(ids[1]));
    const double* u = committed.displacement().data();
    const double length = std::hypot(y[0] - x[0], y[1] - x[1]);
    return std::hypot(y[0] + u[2 * ids[1]] - x[0] - u[2 * ids[0]],
                      y[1] + u[2 * ids[1] + 1] - x[1] - u[2 * ids[0] + 1]) /
               length -
           1;
  }
  deck::Deck deck;
  mechanics::Scene scene;
  mechanics::Committed committed;
  double stored = 0;
};

}  // namespace perinox::test
