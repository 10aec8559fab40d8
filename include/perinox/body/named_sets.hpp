#pragma once
#include <map>
#include <string>
#include <vector>

#include "perinox/body/body.hpp"
#include "perinox/deck/deck.hpp"

namespace perinox::body {

/// Owned particles of every named set of the deck, of `all` and of every body. A particle on the surface of a box
/// (within 1e-9 of `spacing`) is in it; in 2-D a box's z is ignored. Collective. Throws InputError at the set's place:
/// a set empty over all ranks, an id that no particle has, a name taken twice, a body that is not there.
std::map<std::string, std::vector<LocalIndex>> find_sets(const deck::Deck& deck, const Body& body, double spacing);

}  // namespace perinox::body
