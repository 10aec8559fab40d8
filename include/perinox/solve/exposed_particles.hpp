#pragma once
#include <array>
#include <vector>

#include "perinox/mechanics/scene.hpp"

namespace perinox::solve {

/// The particles at which a body can be touched, of the owned ones: those whose intact bonds lean to one side, as at a
/// surface or a crack; lie in a plane or on a line, as in a body one particle thick; or are few. All of it follows from
/// the particle's own family, so that nothing far away changes the answer.
struct ExposedParticles {
  std::vector<LocalIndex> particle;           ///< ascending
  std::vector<std::vector<GlobalId>> bonded;  ///< of each: who it shares an intact bond with, ascending
  std::vector<std::array<double, 3>> lean;    ///< of each: mean of its bonds' reference directions; zero without bonds
};
ExposedParticles find_exposed(const mechanics::Scene& scene);

/// Lattice spacing of each of the deck's bodies; 0 for a cloud.
std::vector<double> lattice_spacings(const deck::Deck& deck);
/// Distance of particle i from its neighbours, length: that of its own lattice, which does not go by the part of a cell
/// that i stands for; V^(1/d) in a cloud. spacings: of each of the deck's bodies; empty: all are clouds.
double particle_spacing(const body::Body& body, const std::vector<double>& spacings, LocalIndex i);

}  // namespace perinox::solve
