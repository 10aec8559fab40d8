#pragma once
#include <map>
#include <string>
#include <vector>

#include "perinox/body/body.hpp"
#include "perinox/deck/deck.hpp"

namespace perinox::body {

/// Owned particles of every named set of the deck, of `all` and of every body. Boxes and the comparisons of conditions
/// (deck/condition.hpp) take the same slack at their bounds: 1e-9 of the particle's spacing and the rounding of its
/// coordinates, so that a particle on the surface of a box is in it. In 2-D a box's z is ignored. Collective. Throws
/// InputError at the set's place: a set empty over all ranks, an id that no particle has, a name taken twice, a body
/// that is not there.
std::map<std::string, std::vector<LocalIndex>> find_sets(const deck::Deck& deck, const Body& body);

}  // namespace perinox::body
