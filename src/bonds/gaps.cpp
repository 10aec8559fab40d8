#include "gaps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "perinox/body/convexity.hpp"
#include "perinox/body/shape.hpp"
#include "perinox/body/shape_intervals.hpp"
#include "perinox/body/together.hpp"

namespace perinox::bonds {

namespace {

// In spacings: a bond that leaves the material by no more than that much stays.
constexpr double for_rounding = 1e-9;
constexpr double on_an_outline = 0.01;  // of the horizon: points of a cloud this near to its outline lie on it

bool convex(const deck::Shape& shape) {
  return std::holds_alternative<deck::Box>(shape.form) || std::holds_alternative<deck::Sphere>(shape.form) ||
         std::holds_alternative<deck::Cylinder>(shape.form);
}

/// The solid with every surface counting as touched from a distance of `by` outside.
body::Solid grown(body::Solid solid, double by) {
  for (body::Surface& surface : solid.surfaces) surface.slack = std::max(surface.slack, by);
  for (body::Solid& part : solid.parts) part = grown(std::move(part), by);
  return solid;
}

/// Refuses points of a cloud outside its outline. Such a point would have no bond along the outline, and it would lose
/// the others to nothing but the outline.
void refuse_outside(const deck::Deck& deck, const body::Body& body,
                    const std::vector<std::optional<body::Solid>>& solid) {
  std::string sentence;
  GlobalId id = 0;
  for (LocalIndex i = 0; i < body.owned && sentence.empty(); ++i) {
    const auto k = static_cast<std::size_t>(body.part[static_cast<std::size_t>(i)]);
    const deck::BodyPart& part = deck.body[k];
    if (!solid[k] || !part.outline || body::contains(*solid[k], body.position3(i))) continue;
    const deck::Point x = body.position3(i);
    id = body.id[static_cast<std::size_t>(i)];
    sentence = deck::placed(
        part.outline->location,
        fmt::format("particle {} of the body {} at ({:g}, {:g}, {:g}) lies outside of the body's outline, which has to "
                    "hold all its points; make the outline larger, or take the point out",
                    id, part.name, x[0], x[1], x[2]));
  }
  body::refuse_first(body.communicator, id, sentence);
}

}  // namespace

Gaps::Gaps(const deck::Deck& deck, const body::Body& body, double horizon, double reach)
    : body_(body), reach_(reach), together_(deck.bond_bodies && deck.body.size() > 1) {
  if (deck.across_gaps == deck::AcrossGaps::keep) return;
  for (const deck::BodyPart& part : deck.body) {
    const bool cloud = std::holds_alternative<deck::CloudFile>(part.shape.form);
    shape_.push_back(cloud ? nullptr : &part.shape);
    solid_.emplace_back();
    if (!cloud)
      solid_.back() = body::solid_of(part.shape, body.dimension);
    else if (part.outline)
      solid_.back() = grown(body::solid_of(*part.outline, body.dimension), on_an_outline * horizon);
    looked_at_ = looked_at_ || (solid_.back() && (cloud || !convex(part.shape)));
  }
  looked_at_ = looked_at_ || together_;
  refuse_outside(deck, body, solid_);
}

bool Gaps::leaves(LocalIndex i, LocalIndex j) const {
  if (body_.id[static_cast<std::size_t>(i)] > body_.id[static_cast<std::size_t>(j)]) std::swap(i, j);
  const auto part = static_cast<std::size_t>(body_.part[static_cast<std::size_t>(i)]);
  const auto other = static_cast<std::size_t>(body_.part[static_cast<std::size_t>(j)]);
  if (!solid_[part] || !solid_[other]) return false;
  const deck::Point from = body_.position3(i), to = body_.position3(j);
  const double length =
      std::sqrt(std::pow(to[0] - from[0], 2) + std::pow(to[1] - from[1], 2) + std::pow(to[2] - from[2], 2));
  const double allowed = (body::bridged_gap + for_rounding) * (body_.spacing_of(i) + body_.spacing_of(j)) / 2;
  if (length <= allowed) return false;
  body::Intervals inside = body::intervals_inside(*solid_[part], from, to);
  if (length * (1 - body::length(inside)) <= allowed) return false;
  if (!together_) return true;
  for (std::size_t k = 0; k < solid_.size(); ++k)
    if (k != part && solid_[k]) inside = body::unite(inside, body::intervals_inside(*solid_[k], from, to));
  return length * (1 - body::length(inside)) > allowed;
}

int Gaps::remove(LocalIndex i, std::vector<FoundBond>& found) const {
  if (!looked_at_) return 0;
  const auto part = static_cast<std::size_t>(body_.part[static_cast<std::size_t>(i)]);
  if (!solid_[part]) return 0;
  // Centres of a lattice's cells are inside of its shape. Points of a cloud may be anywhere.
  const bool stays = shape_[part] && body::convex_within(*shape_[part], body_.position3(i), reach_, body_.dimension);
  const auto last = std::remove_if(found.begin(), found.end(), [&](const FoundBond& bond) {
    const bool own = body_.part[static_cast<std::size_t>(bond.neighbor)] == body_.part[static_cast<std::size_t>(i)];
    return !(own && stays) && leaves(i, bond.neighbor);
  });
  const auto removed = static_cast<int>(found.end() - last);
  found.erase(last, found.end());
  return removed;
}

}  // namespace perinox::bonds
