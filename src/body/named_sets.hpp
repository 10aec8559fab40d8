#pragma once
#include <map>
#include <string>
#include <vector>

#include "perinox/body/body.hpp"
#include "perinox/deck/deck.hpp"

namespace perinox::body {

/// Finds the owned particles of every named set of the deck, of `all` and of every body. Boxes and the comparisons of
/// conditions (deck/condition.hpp) have the same slack at their bounds: 1e-9 of the particle's spacing and the rounding
/// of its coordinates. A particle on the surface of a box is therefore in it. In 2-D a box's z is ignored. Collective.
/// Throws InputError at the set's place for a set that is empty over all ranks, an id that no particle has, a name
/// taken twice, and a body that is not there.
std::map<std::string, std::vector<LocalIndex>> find_sets(const deck::Deck& deck, const Body& body);

}  // namespace perinox::body
