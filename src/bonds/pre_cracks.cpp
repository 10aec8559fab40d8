#include "pre_cracks.hpp"

#include <fmt/format.h>

#include "perinox/body/together.hpp"

namespace perinox::bonds {

PreCracks::PreCracks(const deck::Deck& deck, const body::Body& body, double horizon, double reach)
    : deck_(deck), body_(body), reach_(reach * (1 + 1e-6)) {
  for (const deck::Crack& crack : deck.cracks) surfaces_.emplace_back(crack, 1e-9 * horizon);
  cut_by_.assign(surfaces_.size(), 0);
  held_.resize(surfaces_.size());
}

void PreCracks::approach(LocalIndex i) {
  near_.clear();
  if (surfaces_.empty()) return;
  const deck::Point at = body_.position3(i);
  for (std::size_t k = 0; k < surfaces_.size(); ++k) {
    if (!surfaces_[k].within(at, reach_)) continue;
    near_.push_back(k);
    if (surfaces_[k].holds(at)) held_[k].push_back(i);
  }
}

bool PreCracks::cut(LocalIndex i, LocalIndex j) {
  bool any = false;
  for (const std::size_t k : near_) {
    if (!surfaces_[k].cuts(body_.position3(i), body_.position3(j))) continue;
    ++cut_by_[k];
    any = true;
  }
  return any;
}

void PreCracks::refuse_unclear() const {
  for (std::size_t k = 0; k < surfaces_.size(); ++k) {
    const deck::Location& where = deck_.cracks[k].location;
    if (const long long held = body_.communicator.sum(static_cast<long long>(held_[k].size())); held > 0) {
      std::string sentence;
      GlobalId id = 0;
      for (const LocalIndex i : held_[k]) {
        if (!sentence.empty() && body_.id[static_cast<std::size_t>(i)] > id) continue;
        id = body_.id[static_cast<std::size_t>(i)];
        const deck::Point x = body_.position3(i), &n = surfaces_[k].normal();
        sentence = fmt::format(
            "this crack runs through the centre of particle {} at ({:g}, {:g}, {:g}){}, which would be on neither side "
            "of it; move the crack by a part of the spacing, for example by {:g} along its normal ({:.3g}, {:.3g}, "
            "{:.3g})",
            id, x[0], x[1], x[2], held > 1 ? fmt::format(" and of {} more", held - 1) : std::string(),
            body_.spacing_of(i) / 4, n[0] + 0.0, n[1] + 0.0, n[2] + 0.0);
      }
      body::refuse_first(body_.communicator, id, sentence.empty() ? sentence : deck::placed(where, sentence));
    }
    if (body_.communicator.sum(cut_by_[k]) > 0) continue;
    deck::refuse(where,
                 "this crack cuts no bond; move it into the body, make it larger than the spacing, or take it out");
  }
}

}  // namespace perinox::bonds
