#include "named_sets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "perinox/body/together.hpp"
#include "perinox/deck/condition.hpp"

namespace perinox::body {

namespace {

using Members = std::vector<LocalIndex>;

Members of_part(const Body& body, int part) {
  Members members;
  for (LocalIndex i = 0; i < body.owned; ++i) {
    if (body.part[i] == part) members.push_back(i);
  }
  return members;
}

struct Find {
  const deck::Deck& deck;
  const Body& body;
  const deck::Set& set;

  /// Slack at the bounds of conditions and boxes, length: 1e-9 of the particle's spacing, and the rounding of its
  /// coordinates.
  double slack_of(LocalIndex i) const { return 1e-9 * body.spacing_of(i) + 2 * body.rounding(i); }
  template <class Condition>
  Members where(Condition&& holds) const {
    Members members;
    for (LocalIndex i = 0; i < body.owned; ++i) {
      if (holds(body.position3(i), slack_of(i))) members.push_back(i);
    }
    return members;
  }

  Members operator()(const deck::SetWhere& form) const {
    const deck::Condition condition(form.condition);
    return where([&](const deck::Point& x, double slack) {
      const bool in = condition.holds(x, slack);
      if (condition.undefined())
        deck::refuse(set.location, fmt::format("the condition of the set {} is not a number at the particle at ({:g}, "
                                               "{:g}, {:g}); ask first for what makes it one, as in \"x > 0 && "
                                               "sqrt(x) < 2\"",
                                               set.name, x[0], x[1], x[2]));
      return in;
    });
  }
  Members operator()(const deck::SetBox& box) const {
    return where([&](const deck::Point& x, double slack) {
      for (int axis = 0; axis < body.dimension; ++axis) {
        if (x[axis] < box.min[axis] - slack || x[axis] > box.max[axis] + slack) return false;
      }
      return true;
    });
  }
  Members operator()(const deck::SetIds& form) const {
    Members members;
    for (const long long id : form.ids) {
      if (id < 0 || id >= body.total) {
        deck::refuse(set.location, fmt::format("the set {} names particle {}, but the particles are numbered from 0 to "
                                               "{}; take that id out",
                                               set.name, id, body.total - 1));
      }
      const auto end = body.id.begin() + body.owned;
      const auto found = std::lower_bound(body.id.begin(), end, id);
      if (found != end && *found == id) members.push_back(static_cast<LocalIndex>(found - body.id.begin()));
    }
    std::sort(members.begin(), members.end());
    members.erase(std::unique(members.begin(), members.end()), members.end());
    return members;
  }
  Members operator()(const deck::SetBody& form) const {
    for (std::size_t part = 0; part < deck.body.size(); ++part) {
      if (deck.body[part].name == form.body) return of_part(body, static_cast<int>(part));
    }
    deck::refuse(set.location,
                 fmt::format("the set {} names the body {}, which the deck does not have", set.name, form.body));
  }
};

/// The box around the particles of all ranks in words: "from (0.5, 0.5) to (3.5, 1.5)". Collective.
std::string place_of_particles(const Body& body) {
  std::vector<std::string> lows, highs;
  for (int axis = 0; axis < body.dimension; ++axis) {
    double low = std::numeric_limits<double>::max(), high = std::numeric_limits<double>::lowest();
    for (LocalIndex i = 0; i < body.owned; ++i) {
      low = std::min(low, body.position(i)[axis]);
      high = std::max(high, body.position(i)[axis]);
    }
    lows.push_back(fmt::format("{:g}", body.communicator.min(low)));
    highs.push_back(fmt::format("{:g}", body.communicator.max(high)));
  }
  return fmt::format("from ({}) to ({})", fmt::join(lows, ", "), fmt::join(highs, ", "));
}

}  // namespace

std::map<std::string, Members> find_sets(const deck::Deck& deck, const Body& body) {
  std::map<std::string, Members> sets;
  for (LocalIndex i = 0; i < body.owned; ++i) sets["all"].push_back(i);
  sets["all"];  // an empty rank has the set too
  for (std::size_t part = 0; part < deck.body.size(); ++part) {
    sets[deck.body[part].name] = of_part(body, static_cast<int>(part));
  }
  for (const deck::Set& set : deck.sets) {
    if (sets.count(set.name)) {
      deck::refuse(set.location,
                   fmt::format("the name {} is taken by another set or by a body; choose another", set.name));
    }
    Members members;
    together(body.communicator, [&] { members = std::visit(Find{deck, body, set}, set.form); });
    if (body.communicator.sum(static_cast<long long>(members.size())) == 0) {
      deck::refuse(set.location, fmt::format("the set {} is empty: none of the {} particles is in it; widen its "
                                             "condition or take the set out (the particles lie {})",
                                             set.name, body.total, place_of_particles(body)));
    }
    sets[set.name] = std::move(members);
  }
  return sets;
}

}  // namespace perinox::body
