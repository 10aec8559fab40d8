#include "body/cloud.hpp"

#include <cmath>

#include "../targets.hpp"
#include "accepted.hpp"
#include "body/neighbor_count.hpp"
#include "perinox/body/neighbor_search.hpp"
#include "perinox/body/spacing.hpp"

namespace perinox::fuzz {

namespace {

bool cloud_in(deck::Dimension dimension, const std::string& path) {
  deck::Deck deck;
  deck.dimension = dimension;
  deck::BodyPart part;
  part.name = "cloud";
  part.shape.form = deck::CloudFile{path};
  deck.body.push_back(part);
  std::vector<body::Particle> particles;
  if (!accepted([&] { particles = body::read_cloud(deck, 0, 0); })) return false;
  demand(!particles.empty(), "a cloud without particles");
  const int d = deck::unknowns(dimension);
  double volume = 0;
  for (const body::Particle& particle : particles) {
    demand(particle.volume > 0, "a volume that is not positive");
    for (const double x : particle.position) demand(std::isfinite(x), "a position that is not finite");
    demand(d == 3 || particle.position[2] == 0, "a particle outside the plane");
    volume += particle.volume;
  }
  constexpr std::size_t enough = 100;
  const double reach = 3 * body::edge_of(volume / static_cast<double>(particles.size()), d);
  if (particles.size() > enough || !std::isfinite(reach) || !(reach > 0)) return true;
  const std::vector<double> points = body::coordinates(particles, d);
  body::count_within(points, d, static_cast<int>(particles.size()), reach);
  body::neighbors_within(points, d, static_cast<int>(particles.size()), reach);
  return true;
}

}  // namespace

bool cloud(const std::string& input) {
  static MemoryFile file;
  file.put(input);
  const bool solid = cloud_in(deck::Dimension::three, file.path());
  const bool flat = cloud_in(deck::Dimension::plane_strain, file.path());
  return solid || flat;
}

}  // namespace perinox::fuzz
