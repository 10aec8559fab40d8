#include "perinox/solve/hand_over.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "perinox/solve/loose_pieces.hpp"
#include "perinox/solve/stable_step.hpp"

namespace perinox::solve {

namespace {
/// Time steps between two looks at the energies, which cost a sum over the ranks.
constexpr long long between_looks = 10;
/// The stable time step is estimated again after so many: bonds that turn and stretch change it.
constexpr long long between_estimates = 1000;
/// Passages of a wave after which a run that finds no rest stops, and damping over one passage, unless the deck says.
constexpr double most_passages = 1000, damping_over_passage = 2;
}  // namespace

double passage_time(const deck::Deck& deck, const mechanics::Scene& scene) {
  const body::Body& body = scene.body();
  const int d = scene.dimension();
  double square = 0;
  for (int c = 0; c < d; ++c) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (LocalIndex i = 0; i < body.owned; ++i) {
      low = std::min(low, body.position(i)[c]);
      high = std::max(high, body.position(i)[c]);
    }
    const double length = body.communicator.max(high) - body.communicator.min(low);
    square += length * length;
  }
  double slowest = std::numeric_limits<double>::infinity();
  for (std::size_t m = 0; m < deck.materials.size(); ++m) {
    if (!deck.materials[m].density)
      deck::refuse(deck.materials[m].location,
                   fmt::format("the material {} needs the key density", deck.materials[m].name));
    const materials::ElasticModuli moduli = scene.materials()[m]->elastic_moduli(d);
    slowest =
        std::min(slowest, std::sqrt((moduli.bulk + 2 * moduli.shear * (1 - 1.0 / d)) / *deck.materials[m].density));
  }
  return std::max(std::sqrt(square), scene.families().horizon) / slowest;
}

HandOver::HandOver(const deck::Deck& deck, mechanics::Scene& scene, Boundary& boundary, BondBreaking* breaking)
    : deck_(deck), scene_(scene), boundary_(boundary), breaking_(breaking), passage_(passage_time(deck, scene)) {}

HandOver::Result HandOver::run(mechanics::Committed& state, double t, Observer& observer, std::vector<double>& force,
                               std::vector<double>& external) {
  const deck::HandOver& said = deck_.hand_over;
  const double begin_t = state.t();
  ExplicitMotion::Settings settings;
  settings.damping = said.damping.value_or(damping_over_passage / passage_);
  settings.contact = deck_.motion.contact;
  settings.rate = said.rate > 0 ? said.rate : (t - begin_t) / passage_;
  settings.safety = deck_.motion.safety;
  ExplicitMotion motion(scene_, boundary_, particle_masses(deck_, scene_), std::move(state), settings);
  const double quiet = said.quiet_time.value_or(passage_),
               longest = said.longest_time.value_or(most_passages * passage_);

  Result result;
  double last_break = 0, most_stored = 0;
  long long estimated = 0;
  for (;;) {
    double dt = motion.stable_time_step();
    if (!std::isfinite(dt)) {  // nothing is free to move
      result.at_rest = true;
      break;
    }
    if (deck_.motion.time_step) dt = std::min(dt, *deck_.motion.time_step);
    if (said.rate == 0 && motion.t() < t && motion.time() + dt >= passage_) dt = passage_ - motion.time();
    motion.step(dt);
    if (said.rate == 0 && motion.time() >= passage_ * (1 - 1e-12)) motion.go_on_at(t, 0);
    if (said.rate > 0 && motion.t() >= deck_.steps.end) motion.go_on_at(deck_.steps.end, 0);
    if (const long long broken = break_bonds(motion); broken > 0) {
      result.broken += broken;
      last_break = motion.time();
    }
    if (motion.time_steps() % between_looks != 0) continue;
    if (motion.time_steps() - estimated >= between_estimates) {
      estimated = motion.time_steps();
      motion.estimate_again();
    }
    const MotionEnergies now = motion.energies();
    most_stored = std::max(most_stored, std::max(now.stored, now.at_start));
    result.most_kinetic = std::max(result.most_kinetic, now.kinetic);
    if (!motion.sound(now)) {
      result.reason = "the energies of the motion grow though nothing does that work; take a smaller explicit.safety";
      break;
    }
    if (motion.time() - last_break >= quiet && motion.time() >= quiet) {
      if (let_loose_go(motion, observer)) last_break = motion.time();
      if (motion.energies().moving <= said.kinetic_share * most_stored) {
        result.at_rest = true;
        break;
      }
    }
    if (motion.time() > longest) {
      result.reason = fmt::format("the body is not at rest after {:.4g} of time (hand_over.longest_time)", longest);
      break;
    }
  }
  result.time = motion.time();
  result.time_steps = motion.time_steps();
  result.energies = motion.energies();
  force = motion.force();
  external = motion.external();
  state = motion.release();
  return result;
}

long long HandOver::break_bonds(ExplicitMotion& motion) {
  if (!breaking_) return 0;
  const long long broken = breaking_->break_all(motion);
  if (broken > 0) motion.bonds_have_broken();
  return broken;
}

bool HandOver::let_loose_go(ExplicitMotion& motion, Observer& observer) {
  if (!breaking_) return false;
  const LoosePieces found = find_loose(scene_, boundary_);
  breaking_->count_also(found.broken);
  for (const std::string& sentence : found.sentences) observer.note(sentence);
  const bool any = scene_.body().communicator.any(
      std::any_of(found.loose.begin(), found.loose.end(), [](char c) { return c != 0; }));
  if (found.broken > 0) motion.bonds_have_broken();
  if (!any) return found.broken > 0;
  boundary_.let_go(found.loose);
  motion.supports_have_changed();
  return true;
}

}  // namespace perinox::solve
