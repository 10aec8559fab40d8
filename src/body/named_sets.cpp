#include "perinox/body/named_sets.hpp"

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
  double slack;  ///< length: at the bounds of conditions and boxes

  template <class Condition>
  Members where(Condition&& holds) const {
    Members members;
    for (LocalIndex i = 0; i < body.owned; ++i) {
      if (holds(body.position3(i))) members.push_back(i);
    }
    return members;
  }

  Members operator()(const deck::SetWhere& form) const {
    const deck::Condition condition(form.condition);
    return where([&](const deck::Point& x) { return condition.holds(x, slack); });
  }
  Members operator()(const deck::SetBox& box) const {
    return where([&](const deck::Point& x) {
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

/// 1e-9 of the spacing, and the rounding of the largest coordinate. Collective.
double slack_of(const Body& body, double spacing) {
  double largest = 0;
  for (const double coordinate : body.reference) largest = std::max(largest, std::abs(coordinate));
  return 1e-9 * spacing + 8 * std::numeric_limits<double>::epsilon() * body.communicator.max(largest);
}

}  // namespace

std::map<std::string, Members> find_sets(const deck::Deck& deck, const Body& body, double spacing) {
  std::map<std::string, Members> sets;
  const double slack = slack_of(body, spacing);
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
    together(body.communicator, [&] { members = std::visit(Find{deck, body, set, slack}, set.form); });
    if (body.communicator.sum(static_cast<long long>(members.size())) == 0) {
      deck::refuse(set.location, fmt::format("the set {} is empty: none of the {} particles is in it; widen its "
                                             "condition or take the set out",
                                             set.name, body.total));
    }
    sets[set.name] = std::move(members);
  }
  return sets;
}

}  // namespace perinox::body
