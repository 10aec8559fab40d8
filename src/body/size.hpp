#pragma once
/// Refuses what cannot be computed before anything is allocated for it.
#include <string>

#include "perinox/core/communicator.hpp"
#include "perinox/deck/deck.hpp"

namespace perinox::body {

/// A horizon of more spacings than this is taken for a slip of the unit or of a digit.
constexpr double most_spacings = 100;
/// Outside of these what is computed of a spacing h leaves double precision: the tangent of flow in 3-D goes with
/// h^-10, and factors with more. Measured: scenes of all kinds agree with those of h = 1 to rounding from 1e-30 to 1e30
/// with moduli near 1000; none does at 1e-40. The rest is for moduli and densities of any unit.
constexpr double smallest_length = 1e-25, largest_length = 1e25;
/// The least that is kept for each particle and each listed bond, bytes; docs/performance.md says what it is in all.
constexpr double least_a_particle = 250, least_a_bond = 12;

/// Throws InputError if the spacing is outside of [smallest_length, largest_length].
void refuse_odd_length(double spacing, const deck::Location& where, const std::string& of);

/// About how many centres of its lattice are inside the shape: every one is looked at where there are few, a regular
/// sample where there are many. Not for a point cloud.
double about_particles(const deck::BodyPart& part, int dimension);

/// Memory of all machines that the ranks run on, bytes; 0 where a system does not say. Collective.
double machine_memory(const Communicator& communicator);

/// Throws InputError: a horizon of more than most_spacings, or bodies whose particles alone need more than `memory`
/// (0: not known), with the estimate.
void refuse_too_large(const deck::Deck& deck, double reach, double spacing, double memory);

/// Throws InputError if `particles` with the mean volume `volume` list more bonds than fit into `memory`.
void refuse_too_many_bonds(const deck::Deck& deck, double reach, double particles, double volume, double memory);

}  // namespace perinox::body
