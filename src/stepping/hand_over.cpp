#include "perinox/stepping/hand_over.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "perinox/core/restored.hpp"
#include "perinox/fracture/let_go.hpp"
#include "perinox/motion/stable_step.hpp"

namespace perinox::stepping {

namespace {
/// Time steps between two looks at the energies, which cost a sum over the ranks.
constexpr long long between_looks = 10;
/// The stable time step is estimated again after so many: bonds that turn and stretch change it.
constexpr long long between_estimates = 1000;
/// Passages of a wave after which a run that finds no rest stops, and damping over one passage, unless the deck says.
constexpr double most_passages = 1000, damping_over_passage = 2;
}  // namespace

double passage_time(const deck::Deck& deck, const mechanics::Scene& scene, const loads::Parts& parts) {
  const int d = scene.dimension();
  std::vector<double> speed;
  for (std::size_t m = 0; m < deck.materials.size(); ++m) {
    if (!deck.materials[m].density)
      deck::refuse(deck.materials[m].location,
                   fmt::format("the material {} needs the key density", deck.materials[m].name));
    const materials::ElasticModuli moduli = scene.materials()[m]->elastic_moduli(d);
    speed.push_back(std::sqrt((moduli.bulk + 2 * moduli.shear * (1 - 1.0 / d)) / *deck.materials[m].density));
  }
  std::vector<double> slowness(parts.count(), 0.0);
  for (LocalIndex i = 0; i < scene.owned(); ++i) {
    double& most = slowness[parts.of(i)];
    most = std::max(most, 1 / speed[static_cast<std::size_t>(scene.body().material[i])]);
  }
  scene.body().communicator.max(slowness);
  const bool any = std::count(parts.moves.begin(), parts.moves.end(), 1) > 0;
  double longest = 0;
  for (std::size_t k = 0; k < parts.count(); ++k)
    if (!any || parts.moves[k])
      longest = std::max(longest, std::max(parts.diagonal[k], scene.families().horizon) * slowness[k]);
  return longest;
}

HandOver::HandOver(const deck::Deck& deck, mechanics::Scene& scene, loads::Boundary& boundary,
                   fracture::BondBreaking* breaking, double passage, std::shared_ptr<mechanics::Evaluation> evaluation)
    : deck_(deck),
      scene_(scene),
      boundary_(boundary),
      breaking_(breaking),
      passage_(passage),
      evaluation_(std::move(evaluation)) {}

void HandOver::make_motion(mechanics::Committed&& state, double rate) {
  motion::ExplicitMotion::Settings settings;
  settings.damping = deck_.hand_over.damping.value_or(damping_over_passage / (passage_ * patience_));
  settings.contact = deck_.motion.contact;
  settings.rate = rate;
  settings.safety = motion::time_step_safety(deck_, scene_);
  motion_ = std::make_unique<motion::ExplicitMotion>(scene_, boundary_, motion::particle_masses(deck_, scene_),
                                                     std::move(state), settings, evaluation_);
}

void HandOver::begin(mechanics::Committed&& state, double t, double patience) {
  patience_ = patience;
  const double rate = deck_.hand_over.rate > 0 ? deck_.hand_over.rate : (t - state.t()) / passage_;
  to_ = t;
  make_motion(std::move(state), rate);
}

void HandOver::save(StateWriter& writer) const {
  writer.number("phase/to", to_);
  writer.number("phase/patience", patience_);
  writer.number("phase/last_break", last_break_);
  writer.number("phase/most_stored", most_stored_);
  writer.integer("phase/estimated", estimated_);
  writer.integer("phase/broken", result_.broken);
  writer.number("phase/most_kinetic", result_.most_kinetic);
  motion_->save(writer);
}

void HandOver::restore(StateReader& reader) {
  to_ = reader.number("phase/to");
  patience_ = restored_number(reader, "phase/patience", 1);
  last_break_ = reader.number("phase/last_break");
  most_stored_ = reader.number("phase/most_stored");
  constexpr long long most = std::numeric_limits<long long>::max();
  estimated_ = restored_integer(reader, "phase/estimated", 0, most);
  result_.broken = restored_integer(reader, "phase/broken", 0, most);
  result_.most_kinetic = reader.number("phase/most_kinetic");
  make_motion(mechanics::Committed(scene_), 0);
  motion_->restore(reader);
}

void HandOver::advance(double dt) {
  const deck::HandOver& said = deck_.hand_over;
  if (deck_.motion.time_step) dt = std::min(dt, *deck_.motion.time_step);
  if (said.rate == 0 && motion_->t() < to_ && motion_->time() + dt >= passage_) dt = passage_ - motion_->time();
  motion_->step(dt);
  if (said.rate == 0 && motion_->time() >= passage_ * (1 - 1e-12)) motion_->go_on_at(to_, 0);
  if (said.rate > 0 && motion_->t() >= deck_.steps.end) motion_->go_on_at(deck_.steps.end, 0);
  if (const long long broken = breaking_ ? breaking_->break_all(*motion_) : 0; broken > 0) {
    result_.broken += broken;
    last_break_ = motion_->time();
  }
}

HandOver::Result HandOver::run(mechanics::Committed& state, Observer& observer, std::vector<double>& force,
                               std::vector<double>& external, const Passing& passing) {
  const deck::HandOver& said = deck_.hand_over;
  const double quiet = said.quiet_time.value_or(passage_) * patience_,
               longest = said.longest_time.value_or(most_passages * patience_ * passage_);
  for (;;) {
    const double dt = motion_->stable_time_step();
    if (!std::isfinite(dt)) {  // nothing is free to move
      motion_->begin(0);       // for the energies and forces of where it stands
      result_.at_rest = true;
      break;
    }
    advance(dt);
    if (motion_->time_steps() % between_looks != 0) continue;
    if (motion_->time_steps() - estimated_ >= between_estimates) {
      estimated_ = motion_->time_steps();
      motion_->estimate_again();
    }
    motion_->gather_sums();
    const motion::MotionEnergies now = motion_->energies();
    most_stored_ = std::max(most_stored_, std::max(now.stored, now.at_start));
    result_.most_kinetic = std::max(result_.most_kinetic, now.kinetic);
    observer.moves(
        {motion_->t(), motion_->time(), motion_->time_steps(), now.kinetic, now.stored, now.damped, result_.broken});
    if (!motion_->sound(now)) {
      result_.reason = "the energies of the motion grow though nothing does that work; take a smaller explicit.safety";
      break;
    }
    if (motion_->time() - last_break_ >= quiet && motion_->time() >= quiet) {
      if (let_loose_go(observer)) {
        last_break_ = motion_->time();
        motion_->gather_sums();  // what went with them, before a checkpoint has the sum
      }
      if (motion_->energies().moving <= said.kinetic_share / patience_ * most_stored_) {
        result_.at_rest = true;
        break;
      }
    }
    if (motion_->time() > longest) {
      result_.reason = fmt::format("the body is not at rest after {:.4g} of time (hand_over.longest_time)", longest);
      break;
    }
    if (passing) passing(motion_->t());
  }
  result_.time = motion_->time();
  result_.time_steps = motion_->time_steps();
  result_.energies = motion_->energies();
  force = motion_->force();
  external = motion_->external();
  state = motion_->release();
  motion_.reset();
  return result_;
}

bool HandOver::let_loose_go(Observer& observer) {
  if (!breaking_) return false;
  const fracture::LetGo changed =
      fracture::let_loose_go(scene_, boundary_, *breaking_, motion_->plastic(), {motion_->loads(), motion_->external()},
                             observer, motion_.get());
  return changed.bonds || changed.particles;
}

}  // namespace perinox::stepping
