#include "lattice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "cut_cells.hpp"
#include "perinox/body/shape.hpp"
#include "perinox/body/together.hpp"
#include "size.hpp"

namespace perinox::body {

Lattice::Lattice(const deck::BodyPart& part, int dimension_) : first{}, spacing(part.spacing), dimension(dimension_) {
  if (!(spacing > 0) || !std::isfinite(spacing)) {
    deck::refuse(part.location,
                 fmt::format("the body {} needs a spacing greater than 0, but has {:g}", part.name, spacing));
  }
  refuse_odd_length(spacing, part.location, "the body " + part.name);
  const Bounds box = bounds(part.shape);
  std::array<double, 3> count{1, 1, 1};
  for (int axis = 0; axis < dimension; ++axis) {
    const double length = box.max[axis] - box.min[axis];
    if (!(length > 0)) {
      deck::refuse(part.shape.location, fmt::format("the shape of the body {} has no extent along {}; make its max "
                                                    "greater than its min",
                                                    part.name, "xyz"[axis]));
    }
    count[axis] = std::max(1.0, std::floor((length + tolerance(part)) / spacing + 0.5));
    first[axis] = box.min[axis] + (length - count[axis] * spacing) / 2 + spacing / 2;
  }
  const double points = count[0] * count[1] * count[2];
  if (points > most_lattice_points) {
    deck::refuse(
        part.shape.location,
        fmt::format("the body {} would have about {:.3g} particles at spacing {:g}, more than {:.3g}; make the "
                    "spacing larger, or check that spacing and shape are in the same unit",
                    part.name, points, spacing, most_lattice_points));
  }
  for (std::size_t axis = 0; axis < 3; ++axis) cells[axis] = static_cast<long long>(count[axis]);
}

double Lattice::volume() const { return dimension == 3 ? spacing * spacing * spacing : spacing * spacing; }

double Lattice::tolerance(const deck::BodyPart& part) const {
  return 1e-9 * spacing +
         16 * std::numeric_limits<double>::epsilon() * largest_coordinate(bounds(part.shape), dimension);
}

std::vector<Particle> generate(const deck::Deck& deck, int part, GlobalId first_id, const Communicator& communicator) {
  const deck::BodyPart& body = deck.body[part];
  const int dimension = deck::unknowns(deck.dimension);
  const Lattice lattice(body, dimension);  // the same on every rank: all refuse together

  const long long begin = lattice.rows() * communicator.rank() / communicator.size();
  const long long end = lattice.rows() * (communicator.rank() + 1) / communicator.size();
  const double whole = lattice.volume();
  CutCells cells(body, dimension);
  std::vector<Particle> particles;
  for (long long row = begin; row < end; ++row) {
    deck::Point point = lattice.first;
    point[1] += static_cast<double>(row % lattice.cells[1]) * lattice.spacing;
    point[2] += static_cast<double>(row / lattice.cells[1]) * lattice.spacing;
    for (long long i = 0; i < lattice.cells[0]; ++i) {
      point[0] = lattice.first[0] + static_cast<double>(i) * lattice.spacing;
      if (!contains(cells.solid(), point)) continue;
      const double volume =
          cells.none() ? whole : whole * cells.volume({i, row % lattice.cells[1], row / lattice.cells[1]});
      particles.push_back({0, point, volume, part});
    }
  }
  const auto count = static_cast<long long>(particles.size());
  if (communicator.sum(count) == 0) {
    deck::refuse(
        body.shape.location,
        fmt::format("the body {} has no particles: none of the {} x {} x {} centres of its lattice is inside its "
                    "shape{}",
                    body.name, lattice.cells[0], lattice.cells[1], lattice.cells[2],
                    body.as_written ? ", without what later bodies take of it (overlap: later-wins); put the "
                                      "body after those that it is to displace"
                                    : fmt::format("; make the spacing smaller than {:g}", lattice.spacing)));
  }
  GlobalId id = first_id + communicator.exclusive_scan(count);
  for (Particle& particle : particles) particle.id = id++;
  return particles;
}

}  // namespace perinox::body
