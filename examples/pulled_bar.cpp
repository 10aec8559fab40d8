/// perinox as a library: builds a scene from a deck, solves its load steps and reads the reactions.
///     ninja -C build example_pulled_bar && build/example_pulled_bar
///     mpirun -np 2 build/example_pulled_bar
#include <mpi.h>

#include <Tpetra_Core.hpp>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <vector>

#include "perinox/core/communicator.hpp"
#include "perinox/core/record.hpp"
#include "perinox/deck/read.hpp"
#include "perinox/materials/material.hpp"
#include "perinox/mechanics/scene.hpp"
#include "perinox/stepping/load_stepper.hpp"

namespace {

using namespace perinox;

/// A steel bar of 5 x 5 x 30 mm. Its ends are three particles deep; one is held and the other is pulled by 0.03 mm. The
/// text is the same as that of a deck for the program `perinox`.
const char* const deck_text = R"(
dimension: 3
body: [{name: bar, shape: {box: {min: [0, 0, 0], max: [5, 5, 30]}}, spacing: 1, material: steel}]
horizon: {ratio: 3.015}
materials: {steel: {model: elastic, young_modulus: 210e3, poisson_ratio: 0.3}}
sets: {foot: {where: "z < 3"}, head: {where: "z > 27"}}
boundary:
  - {set: foot, displacement: {x: 0, y: 0, z: 0}}
  - {set: head, displacement: {x: 0, y: 0, z: "0.03*t"}}
steps: {end: 1, count: 2}
history:
  - {name: pull, reaction: head, component: z}
)";

/// Hears of every committed step. A record has the values of the deck's history entries and every field of the owned
/// particles; all ranks are told, and the first one prints.
class Listener : public Observer {
 public:
  explicit Listener(bool prints) : prints_(prints) {}
  void step_committed(const StepRecord& step) override {
    if (prints_)
      std::printf("t = %g: the head is pulled with %.2f N, %d Newton iterations\n", step.t, step.history.at(0),
                  step.newton_iterations);
  }

 private:
  bool prints_;
};

/// The reaction of a set, summed over its particles on all ranks, from the internal force: what the support does to the
/// body is the opposite of what the body does to it.
double reaction(const mechanics::Scene& scene, const stepping::LoadStepper& stepper, const std::string& set,
                int component) {
  double sum = 0;
  for (const LocalIndex i : scene.body().sets.at(set))
    sum -= stepper.force()[static_cast<std::size_t>(i) * static_cast<std::size_t>(scene.dimension()) +
                           static_cast<std::size_t>(component)];
  return scene.body().communicator.sum(sum);
}

void pull_bar() {
  const Communicator ranks(MPI_COMM_WORLD);
  // The schema knows every registered material. A mistake in the text throws InputError with its line and a remedy.
  const deck::Deck deck = deck::read_text(deck_text, "pulled_bar.yaml", materials::full_schema(), {});
  // Particles, their partition over the ranks, and the families of bonds.
  mechanics::Scene scene = mechanics::build_scene(deck, ranks);
  stepping::LoadStepper stepper(deck, scene);
  Listener listener(ranks.is_root());
  stepper.run(listener);  // throws RunError where it cannot go on

  const double foot = reaction(scene, stepper, "foot", 2), head = reaction(scene, stepper, "head", 2);
  if (ranks.is_root())
    std::printf("reactions: foot %.2f N, head %.2f N; stored energy %.4f mJ\n", foot, head, stepper.energies().stored);
}

}  // namespace

int main(int argc, char** argv) {
  const Tpetra::ScopeGuard mpi(&argc, &argv);
  try {
    pull_bar();
  } catch (const std::exception& failure) {
    std::fprintf(stderr, "%s\n", failure.what());
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
