#pragma once
/// Decks of bodies in motion, and questions about their runs.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "support/runs.hpp"

namespace perinox::test {

/// A scene of a deck with `dynamics: explicit` and its stepper.
struct InMotion {
  explicit InMotion(deck::Deck the_deck, MPI_Comm comm = MPI_COMM_SELF)
      : deck(std::move(the_deck)), scene(mechanics::build_scene(deck, Communicator(comm))), stepper(deck, scene) {}
  deck::Deck deck;
  mechanics::Scene scene;
  stepping::TimeStepper stepper;
  Recorder records;

  /// Runs the stepper. Returns the reason if it stopped short.
  std::string run() {
    try {
      stepper.run(records);
    } catch (const RunError& error) {
      return error.what();
    }
    return "";
  }
  /// Momentum of the particles of a set on this rank.
  std::array<double, 3> momentum(const std::string& set = "all") {
    std::array<double, 3> sum{};
    const auto d = static_cast<std::size_t>(scene.dimension());
    for (const LocalIndex i : scene.body().sets.at(set))
      for (std::size_t c = 0; c < d; ++c)
        sum[c] += stepper.motion().masses()[i] * stepper.motion().velocity()[static_cast<std::size_t>(i) * d + c];
    return sum;
  }
  double mass(const std::string& set = "all") const {
    double sum = 0;
    for (const LocalIndex i : scene.body().sets.at(set)) sum += scene.body().volume[i] * *deck.materials[0].density;
    return sum;
  }
};

/// Energy that the rows leave unaccounted for, over the largest energy, from the columns of history.csv.
inline double worst_gap(const std::vector<StepRecord>& rows) {
  double gap = 0, size = 0;
  for (const StepRecord& row : rows) {
    const MotionRow& motion = *row.motion;
    const double sum = motion.kinetic_energy + row.stored_energy + row.dissipated_energy + motion.damped_energy +
                       motion.contact_energy;
    size = std::max({size, std::abs(motion.kinetic_energy), row.stored_energy, std::abs(row.external_work)});
    gap = std::max(gap, std::abs(sum - row.external_work));
  }
  return size > 0 ? gap / size : gap;
}

/// Steel in mm, t, s: longitudinal waves in a bar run at 5.172e6 mm/s.
constexpr double bar_speed = 5.1722e6;
inline std::string steel_box(double a, double b, double c, const std::string& rest,
                             const std::string& model = "elastic") {
  return fmt::format(R"(
dimension: 3
body: [{{name: block, shape: {{box: {{min: [0, 0, 0], max: [{}, {}, {}]}}}}, spacing: 1, material: steel}}]
horizon: {{ratio: 3.015}}
materials: {{steel: {{model: {}, young_modulus: 210e3, poisson_ratio: 0.3, density: 7.85e-9{}}}}}
dynamics: explicit
{})",
                     a, b, c, model, model == "elastic" ? "" : ", yield_stress: {tension: 300}", rest);
}

}  // namespace perinox::test
