#include "perinox/body/overlap.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "perinox/body/shape.hpp"
#include "perinox/body/shape_intervals.hpp"
#include "perinox/body/spacing.hpp"

namespace perinox::body {

namespace {

using deck::Point;

constexpr double thinnest = 1e-3;  // of the spacing: thinner overlaps are the rounding of shapes that touch
constexpr double most_lines = 4e6;

/// The shape that a body's entry writes; null for a cloud without an outline.
const deck::Shape* written(const deck::BodyPart& part) {
  if (part.as_written) return &*part.as_written;
  if (!std::holds_alternative<deck::CloudFile>(part.shape.form)) return &part.shape;
  return part.outline ? &*part.outline : nullptr;
}

/// The lines along one axis through the common box of two shapes.
struct Lines {
  const Solid& one;
  const Solid& other;
  const Bounds& box;
  int dimension;

  struct Sum {
    double length = 0;   ///< length inside of both, over all lines
    double hits = 0;     ///< number of lines with some of it
    double section = 0;  ///< area for which a line stands
    std::optional<Point> at{};
  };
  Sum along(int axis, double step) const {
    std::array<int, 2> across{};
    int count = 0;
    for (int c = 0; c < dimension; ++c)
      if (c != axis) across[static_cast<std::size_t>(count++)] = c;
    std::array<long long, 2> number{1, 1};
    std::array<double, 2> width{1, 1};
    Sum sum;
    sum.section = 1;
    for (int k = 0; k < count; ++k) {
      const auto c = static_cast<std::size_t>(across[static_cast<std::size_t>(k)]);
      const double extent = box.max[c] - box.min[c];
      number[static_cast<std::size_t>(k)] = std::max(1LL, std::llround(std::ceil(extent / step)));
      width[static_cast<std::size_t>(k)] = extent / static_cast<double>(number[static_cast<std::size_t>(k)]);
      sum.section *= width[static_cast<std::size_t>(k)];
    }
    for (long long b = 0; b < number[1]; ++b)
      for (long long a = 0; a < number[0]; ++a) {
        Point from = box.min;
        const std::array<long long, 2> cell{a, b};
        for (int k = 0; k < count; ++k) {
          const auto n = static_cast<std::size_t>(k);
          from[static_cast<std::size_t>(across[n])] += (static_cast<double>(cell[n]) + 0.5) * width[n];
        }
        add(from, axis, sum);
      }
    return sum;
  }

 private:
  void add(const Point& from, int axis, Sum& sum) const {
    const auto c = static_cast<std::size_t>(axis);
    Point to = from;
    to[c] = box.max[c];
    const Intervals both = intersect(intervals_inside(one, from, to), intervals_inside(other, from, to));
    const double inside = length(both) * (to[c] - from[c]);
    if (!(inside > 0)) return;
    sum.length += inside;
    sum.hits += 1;
    if (sum.at) return;
    sum.at = from;
    (*sum.at)[c] += (both.front().first + both.front().second) / 2 * (to[c] - from[c]);
  }
};

std::optional<Overlap> overlap_of(const deck::Deck& deck, std::size_t earlier, std::size_t later) {
  const deck::Shape *one = written(deck.body[earlier]), *other = written(deck.body[later]);
  const int d = deck::unknowns(deck.dimension);
  Bounds box = bounds(*one);
  const Bounds second = bounds(*other);
  double measure = 1;
  for (std::size_t c = 0; c < 3; ++c) {
    box.min[c] = c < static_cast<std::size_t>(d) ? std::max(box.min[c], second.min[c]) : 0;
    box.max[c] = c < static_cast<std::size_t>(d) ? std::min(box.max[c], second.max[c]) : 0;
    if (c < static_cast<std::size_t>(d)) measure *= box.max[c] > box.min[c] ? box.max[c] - box.min[c] : 0;
  }
  if (measure == 0) return std::nullopt;
  double spacing = 0;
  for (const std::size_t part : {earlier, later})
    if (const double h = deck.body[part].spacing; h > 0) spacing = spacing > 0 ? std::min(spacing, h) : h;
  // Two clouds without spacings: this is fine enough for what their outlines have in common.
  if (!(spacing > 0)) spacing = edge_of(measure, d) / 50;
  double step = spacing / 2;
  for (int axis = 0; axis < d; ++axis) {
    const auto c = static_cast<std::size_t>(axis);
    const double section = measure / (box.max[c] - box.min[c]);
    step = std::max(step, std::pow(section / most_lines, 1.0 / std::max(1, d - 1)));
  }
  const Solid solid = solid_of(*one, d), more = solid_of(*other, d);
  const Lines lines{solid, more, box, d};
  std::optional<Overlap> found;
  for (int axis = 0; axis < d; ++axis) {  // thick enough along every axis
    const Lines::Sum sum = lines.along(axis, step);
    if (!(sum.hits > 0 && sum.length / sum.hits > thinnest * spacing)) return std::nullopt;
    if (!found) found = Overlap{earlier, later, sum.length * sum.section, *sum.at};
  }
  return found;
}

Solid shrunk(Solid solid, double by) {
  for (Surface& surface : solid.surfaces) surface.slack = -by;
  for (Solid& part : solid.parts) part = shrunk(std::move(part), by);
  return solid;
}

}  // namespace

std::vector<Overlap> find_overlaps(const deck::Deck& deck) {
  std::vector<Overlap> found;
  for (std::size_t later = 1; later < deck.body.size(); ++later)
    for (std::size_t earlier = 0; earlier < later; ++earlier) {
      if (!written(deck.body[earlier]) || !written(deck.body[later])) continue;
      if (const auto overlap = overlap_of(deck, earlier, later)) found.push_back(*overlap);
    }
  return found;
}

void refuse_overlaps(const deck::Deck& deck) {
  if (deck.overlap == deck::Overlap::later_wins) return;
  const std::vector<Overlap> found = find_overlaps(deck);
  if (found.empty()) return;
  const Overlap& first = found.front();
  const deck::BodyPart &earlier = deck.body[first.earlier], &later = deck.body[first.later];
  deck::refuse(later.location,
               fmt::format("the body {} overlaps the body {} by about {:.4g}, for example at ({:.6g}, {:.6g}, {:.6g}), "
                           "where material would count twice; take one shape from the other with difference, or write "
                           "overlap: later-wins",
                           later.name, earlier.name, first.volume, first.at[0], first.at[1], first.at[2]));
}

void resolve_cloud_overlaps(const deck::Deck& deck, int part, std::vector<Particle>& particles) {
  const auto own = static_cast<std::size_t>(part);
  const int d = deck::unknowns(deck.dimension);
  const bool wins = deck.overlap == deck::Overlap::later_wins;
  for (std::size_t other = 0; other < deck.body.size(); ++other) {
    const deck::Shape* shape = written(deck.body[other]);
    if (other == own || !shape || (wins && other < own)) continue;
    const Solid solid = solid_of(*shape, d);
    const auto inside = [&](const Particle& particle) {
      const Solid smaller = shrunk(solid, thinnest * edge_of(particle.volume, d));
      return !intervals_inside(smaller, particle.position, particle.position).empty();
    };
    if (wins) {
      particles.erase(std::remove_if(particles.begin(), particles.end(), inside), particles.end());
      continue;
    }
    const auto first = std::find_if(particles.begin(), particles.end(), inside);
    if (first == particles.end()) continue;
    deck::refuse(deck.body[own].location,
                 fmt::format("particle {} of the body {} at ({:g}, {:g}, {:g}) lies inside the body {}, where material "
                             "would count twice; take it out of the cloud, or write overlap: later-wins",
                             first->id, deck.body[own].name, first->position[0], first->position[1], first->position[2],
                             deck.body[other].name));
  }
}

}  // namespace perinox::body
