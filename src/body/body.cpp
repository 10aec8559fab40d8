#include "perinox/body/body.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "cloud.hpp"
#include "ghosts.hpp"
#include "lattice.hpp"
#include "lengths.hpp"
#include "named_sets.hpp"
#include "neighbor_count.hpp"
#include "partition.hpp"
#include "perinox/body/neighbor_search.hpp"
#include "perinox/body/overlap.hpp"
#include "perinox/body/spacing.hpp"
#include "perinox/body/together.hpp"
#include "size.hpp"

namespace perinox::body {

namespace {

/// The particles of one rank: those it owns, and its copies of others' particles within reach.
struct Share {
  std::vector<Particle> owned, ghosts;

  std::vector<double> points(int dimension) const {
    std::vector<double> all = coordinates(owned, dimension);
    const std::vector<double> others = coordinates(ghosts, dimension);
    all.insert(all.end(), others.begin(), others.end());
    return all;
  }
};

/// Makes the particles of all bodies. Every rank makes its run of each lattice. A cloud is read by the root alone and
/// spread by the partition.
std::vector<Particle> make_particles(const deck::Deck& deck, const Communicator& communicator) {
  std::vector<Particle> all;
  GlobalId total = 0;
  for (std::size_t k = 0; k < deck.body.size(); ++k) {
    const auto part = static_cast<int>(k);
    std::vector<Particle> some;
    if (std::holds_alternative<deck::CloudFile>(deck.body[k].shape.form)) {
      together(communicator, [&] {
        if (!communicator.is_root()) return;
        some = read_cloud(deck, part, total);
        resolve_cloud_overlaps(deck, part, some);
      });
    } else {
      some = generate(deck, part, total, communicator);
    }
    total += communicator.sum(static_cast<long long>(some.size()));
    if (static_cast<double>(total) > most_lattice_points) {
      deck::refuse(
          deck.body[k].location,
          fmt::format("the bodies up to {} have {} particles together, more than {:.3g}; make a spacing larger",
                      deck.body[k].name, total, most_lattice_points));
    }
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

/// Refuses two particles in one place, because they have no bond direction. It is enough to look at the nearest other
/// particle, even where a whole cloud is one point.
void refuse_coincident(const deck::Deck& deck, const Share& share, int dimension, const Communicator& communicator) {
  constexpr double kCoincident = 1e-8;  // of the spacing
  const std::vector<double> points = share.points(dimension);
  const NeighborSearch search(points, dimension);
  std::string sentence;
  GlobalId first = 0;
  for (std::size_t i = 0; i < share.owned.size() && sentence.empty(); ++i) {
    const Particle& particle = share.owned[i];
    double distance = 0;
    const LocalIndex j = search.nearest(particle.position.data(), distance, static_cast<LocalIndex>(i));
    if (j < 0 || distance >= kCoincident * edge_of(particle.volume, dimension)) continue;
    const auto near = static_cast<std::size_t>(j);
    const Particle& other = near < share.owned.size() ? share.owned[near] : share.ghosts[near - share.owned.size()];
    first = particle.id;
    const Particle& later = particle.id > other.id ? particle : other;
    sentence = deck::placed(
        deck.body[static_cast<std::size_t>(later.part)].location,
        fmt::format("particles {} and {} are in the same place ({:g}, {:g}, {:g}); take one of them out, or move "
                    "the bodies apart so that they do not overlap",
                    std::min(particle.id, other.id), std::max(particle.id, other.id), particle.position[0],
                    particle.position[1], particle.position[2]));
  }
  refuse_first(communicator, first, sentence);
}

/// Distributes the particles over the ranks by the work that each will cost, the number of particles within reach. The
/// first partition is unweighted, because neighbours can only be counted where they are on the same rank. The second
/// one is weighted by the counts.
Share distribute(const deck::Deck& deck, std::vector<Particle> particles, double reach, int dimension,
                 const Communicator& communicator) {
  Share share;
  share.owned = migrate(particles, partition(particles, {}, dimension, communicator), communicator);
  particles = {};
  share.ghosts = find_ghosts(share.owned, reach, dimension, communicator);
  refuse_coincident(deck, share, dimension, communicator);
  if (communicator.size() == 1) return share;

  const std::vector<double> counts =
      count_within(share.points(dimension), dimension, static_cast<int>(share.owned.size()), reach);
  for (std::size_t i = 0; i < counts.size(); ++i) share.owned[i].neighbors = static_cast<int>(counts[i]);
  share.owned = migrate(share.owned, partition(share.owned, counts, dimension, communicator), communicator);
  share.ghosts = find_ghosts(share.owned, reach, dimension, communicator);
  return share;
}

PartitionReport report_of(const Share& share, const Communicator& communicator) {
  const auto imbalance = [&](double value) {
    const double mean = communicator.sum(value) / communicator.size();
    return mean > 0 ? communicator.max(value) / mean : 1.0;
  };
  double bonds = 0;
  for (const Particle& particle : share.owned) bonds += particle.neighbors;  // one rank alone has no need to count
  PartitionReport report;
  report.bond_imbalance = imbalance(bonds);
  report.particle_imbalance = imbalance(static_cast<double>(share.owned.size()));
  report.owned = communicator.gather(static_cast<long long>(share.owned.size()));
  report.ghosts = communicator.gather(static_cast<long long>(share.ghosts.size()));
  return report;
}

/// Index into deck.materials of every body's material.
std::vector<int> material_indices(const deck::Deck& deck) {
  std::vector<int> indices;
  for (const deck::BodyPart& part : deck.body) {
    const auto found = std::find_if(deck.materials.begin(), deck.materials.end(),
                                    [&](const deck::Material& material) { return material.name == part.material; });
    if (found == deck.materials.end()) {
      deck::refuse(part.location, fmt::format("the body {} is made of {}, which is not one of the materials; declare "
                                              "it under materials",
                                              part.name, part.material));
    }
    indices.push_back(static_cast<int>(found - deck.materials.begin()));
  }
  return indices;
}

/// Spacing of every body's own lattice. It is 0 for a cloud, whatever spacing its entry gives.
std::vector<double> lattice_spacings(const deck::Deck& deck) {
  std::vector<double> spacings;
  for (const deck::BodyPart& part : deck.body)
    spacings.push_back(std::holds_alternative<deck::CloudFile>(part.shape.form) ? 0 : part.spacing);
  return spacings;
}

/// Finest place over the spacing. Places that differ by less than this share of the spacing, or of the horizon, count
/// as one (ties at the horizon, particles in a crack's plane), so coordinates have to tell them apart.
constexpr double finest_place = 1e-6;

/// Refuses particles so far from the origin that their coordinates have no digits left for what is between two of them.
void refuse_far_from_origin(const deck::Deck& deck, const Body& body) {
  std::string sentence;
  GlobalId id = 0;
  for (LocalIndex i = 0; i < body.owned && sentence.empty(); ++i) {
    if (body.rounding(i) <= finest_place * body.spacing_of(i)) continue;
    const deck::BodyPart& part = deck.body[static_cast<std::size_t>(body.part[i])];
    const deck::Point x = body.position3(i);
    id = body.id[i];
    sentence = deck::placed(
        part.location,
        fmt::format("the particle of the body {} at ({:g}, {:g}, {:g}) is so far from the origin that its coordinates "
                    "are only good to {:.1g}, too coarse for the spacing {:g}; move the bodies nearer to the origin",
                    part.name, x[0], x[1], x[2], body.rounding(i), body.spacing_of(i)));
  }
  refuse_first(body.communicator, id, sentence);
}

void append(Body& body, const std::vector<Particle>& particles, const std::vector<int>& materials) {
  for (const Particle& particle : particles) {
    body.id.push_back(particle.id);
    body.volume.push_back(particle.volume);
    body.part.push_back(particle.part);
    body.material.push_back(materials[particle.part]);
    body.reference.insert(body.reference.end(), particle.position.begin(), particle.position.begin() + body.dimension);
  }
}

}  // namespace

Body build(const deck::Deck& deck, const Communicator& communicator, double reach, PartitionReport* report) {
  const double spacing = largest_spacing(deck, communicator);
  if (!(reach > 0) || !std::isfinite(reach)) throw std::logic_error("the reach of a body must be a positive length");
  Body body;
  body.communicator = communicator;
  body.dimension = deck::unknowns(deck.dimension);
  body.reach = reach;
  body.lattice_spacing = lattice_spacings(deck);
  const std::vector<double>& spacings = body.lattice_spacing;
  if (std::adjacent_find(spacings.begin(), spacings.end(), std::not_equal_to<>()) == spacings.end())
    body.spacing = spacings.front();
  const std::vector<int> materials = material_indices(deck);

  refuse_unfit_lengths(deck, deck.horizon.length.value_or(deck.horizon.ratio.value_or(0) * spacing), reach);
  const double memory = machine_memory(communicator);
  refuse_too_large(deck, reach, spacing, memory);
  refuse_overlaps(deck);
  std::vector<Particle> particles = make_particles(deck, communicator);
  double volume = 0;
  for (const Particle& particle : particles) volume += particle.volume;
  const auto count = static_cast<double>(communicator.sum(static_cast<long long>(particles.size())));
  refuse_too_many_bonds(deck, reach, count, communicator.sum(volume) / count, memory);
  const Share share = distribute(deck, std::move(particles), reach, body.dimension, communicator);
  body.owned = static_cast<int>(share.owned.size());
  body.ghosts = static_cast<int>(share.ghosts.size());
  body.total = communicator.sum(static_cast<long long>(body.owned));
  append(body, share.owned, materials);
  append(body, share.ghosts, materials);
  refuse_far_from_origin(deck, body);
  body.halo = Halo(communicator, body.id, body.owned);
  body.sets = find_sets(deck, body);
  if (report) *report = report_of(share, communicator);
  return body;
}

}  // namespace perinox::body
