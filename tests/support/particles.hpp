#pragma once
/// A finished run particle by particle, for tests that compare it with a field.
#include <gtest/gtest.h>

#include <array>
#include <functional>

#include "support/runs.hpp"

namespace perinox::test {

struct Particle {
  deck::Point x{};               ///< reference position
  double volume = 0;             ///< in 2-D: area
  std::array<double, 3> u{};     ///< displacement
  std::array<double, 3> pull{};  ///< the force of a support on it: minus the internal force
  double dilatation = 0;
  double stress_xx = 0;                  ///< 0 unless the deck has output.fields: [stress]
  double energy = 0;                     ///< stored energy a volume
  double equivalent_plastic_strain = 0;  ///< 0 where the material has none
};

/// The values after one committed step.
struct Step {
  double t = 0, stored = 0, dissipated = 0, work = 0;
  std::vector<double> history;  ///< the deck's history entries, in its order
};

struct Solution {
  std::vector<Particle> particles;
  std::vector<Step> steps;
  std::string stopped;  ///< the reason, if it stopped short
};

using Enough = std::function<bool(const Step&)>;

/// Runs a deck on one rank. A run that stops short keeps its last committed step. A run that may stop earlier does so
/// after the first step that is `enough`.
inline Solution solve(const std::string& yaml, const Enough& enough = nullptr) {
  class Watch : public Observer {
   public:
    explicit Watch(Enough stop) : enough(std::move(stop)) {}
    void step_committed(const StepRecord& record) override {
      steps.push_back({record.t, record.stored_energy, record.dissipated_energy, record.external_work, record.history});
      values.clear();
      for (const Field& field : record.fields)
        if (field.components == 1)
          values[field.name].assign(field.values, field.values + owned);
        else if (field.name == "stress")
          for (std::size_t i = 0; i < owned; ++i) values[field.name].push_back(field.values[6 * i]);
      if (enough && enough(steps.back())) throw RunError("enough");
    }
    Enough enough;
    std::vector<Step> steps;
    std::map<std::string, std::vector<double>> values;
    std::size_t owned = 0;
  };
  const deck::Deck deck = test::deck_of(yaml);
  mechanics::Scene scene = mechanics::build_scene(deck, Communicator(MPI_COMM_SELF));
  stepping::LoadStepper stepper(deck, scene);
  Watch watch(enough);
  watch.owned = static_cast<std::size_t>(scene.owned());
  Solution solution;
  try {
    stepper.run(watch);
  } catch (const RunError& error) {
    solution.stopped = error.what();
  }
  solution.steps = std::move(watch.steps);
  solution.particles.resize(watch.owned);
  const auto d = static_cast<std::size_t>(scene.dimension());
  for (std::size_t i = 0; i < watch.owned; ++i) {
    Particle& particle = solution.particles[i];
    particle.x = scene.body().position3(static_cast<LocalIndex>(i));
    particle.volume = scene.body().volume[i];
    for (std::size_t c = 0; c < d; ++c) {
      particle.u[c] = stepper.committed().displacement()[i * d + c];
      particle.pull[c] = -stepper.force()[i * d + c];
    }
    const auto value = [&](const char* name) {
      const auto found = watch.values.find(name);
      return found == watch.values.end() ? 0 : found->second[i];
    };
    particle.dilatation = value("dilatation");
    particle.stress_xx = value("stress");
    particle.energy = value("stored_energy");
    particle.equivalent_plastic_strain = value("equivalent_plastic_strain");
  }
  return solution;
}

/// Runs a deck that has to reach its end.
inline Solution solve_to_end(const std::string& yaml) {
  Solution solution = solve(yaml);
  EXPECT_EQ(solution.stopped, "");
  return solution;
}

/// Root mean square of u - exact over that of exact, both over the particles that `counts` accepts.
inline double field_error(const Solution& solution, const std::function<bool(const deck::Point&)>& counts,
                          const std::function<std::array<double, 3>(const deck::Point&)>& exact) {
  double error = 0, size = 0;
  for (const Particle& particle : solution.particles) {
    if (!counts(particle.x)) continue;
    const std::array<double, 3> u = exact(particle.x);
    for (std::size_t c = 0; c < 3; ++c) {
      error += particle.volume * std::pow(particle.u[c] - u[c], 2);
      size += particle.volume * u[c] * u[c];
    }
  }
  return std::sqrt(error / size);
}

/// Slope of `value` over `place` by least squares, over the particles that `counts` accepts.
inline double slope(const Solution& solution, const std::function<bool(const Particle&)>& counts,
                    const std::function<double(const Particle&)>& place,
                    const std::function<double(const Particle&)>& value) {
  double n = 0, p1 = 0, v1 = 0, p2 = 0, pv = 0;
  for (const Particle& particle : solution.particles) {
    if (!counts(particle)) continue;
    const double p = place(particle), v = value(particle);
    n += 1, p1 += p, v1 += v, p2 += p * p, pv += p * v;
  }
  return (n * pv - p1 * v1) / (n * p2 - p1 * p1);
}

/// Sum of `value` over the particles that `counts` accepts.
inline double total(const Solution& solution, const std::function<bool(const Particle&)>& counts,
                    const std::function<double(const Particle&)>& value) {
  double sum = 0;
  for (const Particle& particle : solution.particles)
    if (counts(particle)) sum += value(particle);
  return sum;
}

}  // namespace perinox::test
