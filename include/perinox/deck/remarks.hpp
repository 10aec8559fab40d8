#pragma once
#include <string>
#include <vector>

#include "perinox/deck/deck.hpp"
#include "perinox/deck/schema.hpp"

namespace perinox::deck {

/// Remarks on what a deck says that can be computed but is hardly meant, each in one sentence with its place. Examples
/// are loads that act in full from the first step on and a horizon of about one spacing.
std::vector<std::string> remarks(const Deck& deck);
/// Remarks on output fields that the deck asks for but its runs do not have, each in one sentence with its place.
std::vector<std::string> remarks_on_fields(const Deck& deck, const Schema& schema);

}  // namespace perinox::deck
