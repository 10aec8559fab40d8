#include "size.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>

#include "lattice.hpp"
#include "perinox/body/shape.hpp"

namespace perinox::body {

namespace {

std::string gigabytes(double bytes) { return fmt::format("{:.3g} GB", bytes / 1e9); }

/// Number of neighbours that fill the ball (2-D: the disc) around a particle.
double family_of(double reach, double volume, int dimension) {
  constexpr double pi = 3.14159265358979323846;
  return (dimension == 3 ? 4 * pi / 3 * reach * reach * reach : pi * reach * reach) / volume;
}

/// True if all bodies lie on lattices of one spacing. The bonds are then a stencil and no list.
bool is_one_lattice(const deck::Deck& deck) {
  return std::all_of(deck.body.begin(), deck.body.end(), [&](const deck::BodyPart& part) {
    return !std::holds_alternative<deck::CloudFile>(part.shape.form) && part.spacing == deck.body.front().spacing;
  });
}

/// Memory of this machine, or of the container in which the program runs; 0 if the system does not say.
double local_memory() {
  double bytes = 0;
  std::ifstream system("/proc/meminfo");
  for (std::string word; bytes == 0 && system >> word;) {
    double kilobytes = 0;
    if (word == "MemTotal:" && system >> kilobytes) bytes = 1024 * kilobytes;
  }
  double limit = 0;
  std::ifstream container("/sys/fs/cgroup/memory.max");
  if (container >> limit && limit > 0) bytes = bytes > 0 ? std::min(bytes, limit) : limit;
  return bytes;
}

}  // namespace

void refuse_odd_length(double spacing, const deck::Location& where, const std::string& of) {
  if (spacing >= smallest_length && spacing <= largest_length) return;
  deck::refuse(where, fmt::format("the spacing {:g} of {} is out of what double precision can compute with; choose "
                                  "units in which it lies between {:g} and {:g}",
                                  spacing, of, smallest_length, largest_length));
}

double about_particles(const deck::BodyPart& part, int dimension) {
  const Lattice lattice(part, dimension);
  constexpr double enough = 1e5;
  const auto points = static_cast<double>(lattice.cells[0]) * static_cast<double>(lattice.rows());
  const auto stride = static_cast<long long>(std::ceil(std::pow(std::max(1.0, points / enough), 1.0 / dimension)));
  long long seen = 0, inside = 0;
  const Solid solid = solid_of(part.shape, dimension);
  deck::Point point = lattice.first;
  for (long long z = 0; z < lattice.cells[2]; z += stride)
    for (long long y = 0; y < lattice.cells[1]; y += stride)
      for (long long x = 0; x < lattice.cells[0]; x += stride) {
        const std::array<long long, 3> cell{x, y, z};
        for (std::size_t c = 0; c < 3; ++c)
          point[c] = lattice.first[c] + static_cast<double>(cell[c]) * lattice.spacing;
        ++seen;
        inside += contains(solid, point) ? 1 : 0;
      }
  return points * static_cast<double>(inside) / static_cast<double>(seen);
}

double machine_memory(const Communicator& communicator) {
  MPI_Comm machine = MPI_COMM_NULL;
  MPI_Comm_split_type(communicator.mpi(), MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine);
  int rank = 0;
  MPI_Comm_rank(machine, &rank);
  MPI_Comm_free(&machine);
  const double mine = local_memory();
  const double all = communicator.sum(rank == 0 ? mine : 0.0);
  return communicator.any(mine == 0) ? 0 : all;
}

void refuse_too_large(const deck::Deck& deck, double reach, double spacing, double memory) {
  const int dimension = deck::unknowns(deck.dimension);
  if (reach > most_spacings * spacing) {
    deck::refuse(
        deck.horizon.location,
        fmt::format("the horizon reaches {:.4g} spacings of {:g} far, more than {:g}: each particle could have "
                    "about {:.2g} neighbours; make it smaller, 3 spacings are usual",
                    reach / spacing, spacing, most_spacings, family_of(reach / spacing, 1, dimension)));
  }
  double particles = 0;
  for (const deck::BodyPart& part : deck.body) {
    if (std::holds_alternative<deck::CloudFile>(part.shape.form)) continue;
    particles += about_particles(part, dimension);
    const double bytes = least_a_particle * particles;
    if (memory > 0 && bytes > memory)
      deck::refuse(
          part.shape.location,
          fmt::format("the bodies up to {} would have about {:.3g} particles, which take {} at the least, more "
                      "than the {} of this machine; make the spacing larger than {:g}, or use more machines",
                      part.name, particles, gigabytes(bytes), gigabytes(memory), part.spacing));
  }
}

void refuse_too_many_bonds(const deck::Deck& deck, double reach, double particles, double volume, double memory) {
  if (memory == 0 || is_one_lattice(deck)) return;
  const double family = std::min(particles, family_of(reach, volume, deck::unknowns(deck.dimension)));
  const double bytes = least_a_particle * particles + least_a_bond * family * particles;
  // Near surfaces, and where the particles are spread unevenly, families are smaller than this, but never by half.
  if (bytes < 2 * memory) return;
  deck::refuse(deck.horizon.location,
               fmt::format("{:.3g} particles with about {:.2g} neighbours each take about {}, more than the {} of this "
                           "machine; make the horizon smaller, or use more machines",
                           particles, family, gigabytes(bytes), gigabytes(memory)));
}

}  // namespace perinox::body
