#include "perinox/equilibrium/step_control.hpp"

#include <algorithm>

#include "perinox/core/restored.hpp"

namespace perinox::equilibrium {

namespace {
/// steps.max_cuts is at most this.
constexpr int most_cuts = 60;
}  // namespace

LoadSteps::LoadSteps(const deck::Deck& deck, medium::Medium& medium, const loads::Boundary& boundary, Newton& newton)
    : steps_(deck.steps),
      medium_(medium),
      boundary_(boundary),
      newton_(newton),
      size_(steps_.count > 0 ? steps_.end / steps_.count : 0),
      previous_displacement_(medium.model().owned_unknowns(), 0.0) {}

double LoadSteps::next(double t) const {
  // A remainder shorter than a thousandth of the step joins it.
  return t + size_ * 1.001 >= whole_end() ? whole_end() : t + size_;
}

NewtonResult LoadSteps::attempt(int step, Observer& observer, std::vector<double>& force) {
  tried_ = next(medium_.t());
  return newton_.solve(tried_, step, first_guess(tried_), observer, force);
}

void LoadSteps::accept() {
  if (medium_.trial().t >= whole_end()) ++done_;
  previous_t_ = medium_.t();
  previous_displacement_ = medium::owned_displacement(medium_);
  has_previous_ = true;
  if (cuts_ > 0) {
    --cuts_;
    size_ *= 2;
  }
  accepted_cuts_ = cuts_;
}

void LoadSteps::forget_cuts() {
  for (; cuts_ > accepted_cuts_; --cuts_) size_ *= 2;
}

void LoadSteps::jumped(double t) {
  has_previous_ = false;
  while (!finished() && t >= whole_end() * (1 - 1e-12)) ++done_;
  if (tried_ < t) tried_ = t;
}

bool LoadSteps::cut() {
  if (!steps_.adaptive || cuts_ >= steps_.max_cuts) return false;
  ++cuts_;
  size_ /= 2;
  return true;
}

std::vector<double> LoadSteps::first_guess(double t) const {
  if (!has_previous_) return {};
  // The last increment again, in proportion: nearly right wherever the loading goes on as before.
  const double ratio = (t - medium_.t()) / (medium_.t() - previous_t_);
  std::vector<double> guess(medium_.model().owned_unknowns());
  for (std::size_t u = 0; u < guess.size(); ++u)
    guess[u] = medium_.displacement()[u] + ratio * (medium_.displacement()[u] - previous_displacement_[u]);
  // Loose particles stay where they are.
  const int d = medium_.model().dimension();
  const std::vector<char>& loose = boundary_.loose();
  for (std::size_t i = 0; i < loose.size(); ++i)
    if (loose[i]) std::copy_n(&medium_.displacement()[i * d], d, &guess[i * d]);
  return guess;
}

// The steps done are not saved but counted anew, so that the deck may have others now.
void LoadSteps::save(StateWriter& writer) const {
  writer.integer("steps/cuts", cuts_);
  writer.integer("steps/has_previous", has_previous_ ? 1 : 0);
  writer.number("steps/previous_t", previous_t_);
  writer.particles("steps/previous_displacement", previous_displacement_.data(), medium_.model().dimension());
}

void LoadSteps::restore(StateReader& reader) {
  const int cuts = restored_count(reader, "steps/cuts", most_cuts);
  for (cuts_ = 0; cuts_ < cuts; ++cuts_) size_ /= 2;
  accepted_cuts_ = cuts_;
  for (done_ = 0; !finished() && medium_.t() >= whole_end() * (1 - 1e-12);) ++done_;
  tried_ = medium_.t();
  has_previous_ = reader.integer("steps/has_previous") != 0;
  previous_t_ = reader.number("steps/previous_t");
  previous_displacement_ = reader.particles("steps/previous_displacement", medium_.model().dimension());
}

}  // namespace perinox::equilibrium
