#pragma once
/// Refuses scenes that cannot be computed before anything is allocated for them.
#include <string>

#include "perinox/core/communicator.hpp"
#include "perinox/deck/deck.hpp"

namespace perinox::body {

/// A horizon of more spacings than this is taken for a slip of the unit or of a digit.
constexpr double most_spacings = 100;
/// Spacings outside of these bounds are refused, because numbers computed from a spacing h would leave double
/// precision: the tangent of flow in 3-D goes with h^-10, and factors come on top. Measured with moduli near 1000,
/// scenes of all kinds agree with those of h = 1 to rounding from 1e-30 to 1e30, and none does at 1e-40. The remaining
/// margin is for moduli and densities of any unit.
constexpr double smallest_length = 1e-25, largest_length = 1e25;
/// The least memory for each particle and each listed bond, bytes. docs/performance.md has the whole of it.
constexpr double least_a_particle = 250, least_a_bond = 12;

/// Throws InputError if the spacing is outside of [smallest_length, largest_length].
void refuse_odd_length(double spacing, const deck::Location& where, const std::string& of);

/// Estimates how many centres of its lattice are inside the shape. Every centre is looked at where there are few, a
/// regular sample where there are many. Not for a point cloud.
double about_particles(const deck::BodyPart& part, int dimension);

/// Memory of all machines on which the ranks run, bytes. It is 0 where a system does not say. Collective.
double machine_memory(const Communicator& communicator);

/// Throws InputError for a horizon of more than most_spacings, and for bodies whose particles alone need more than
/// `memory` bytes (0: not known). The message has the estimate.
void refuse_too_large(const deck::Deck& deck, double reach, double spacing, double memory);

/// Throws InputError if `particles` of mean volume `volume` list more bonds than fit into `memory` bytes.
void refuse_too_many_bonds(const deck::Deck& deck, double reach, double particles, double volume, double memory);

}  // namespace perinox::body
