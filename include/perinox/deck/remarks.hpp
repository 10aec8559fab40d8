#pragma once
#include <string>
#include <vector>

#include "perinox/deck/deck.hpp"
#include "perinox/deck/schema.hpp"

namespace perinox::deck {

/// What a deck says that can be computed but is hardly meant, each in one sentence with its place: loads that are there
/// in full from the first step on, a horizon of about one spacing.
std::vector<std::string> remarks(const Deck& deck);
/// Output fields that the deck asks for and that its runs do not have, each in one sentence with its place.
std::vector<std::string> remarks_on_fields(const Deck& deck, const Schema& schema);

}  // namespace perinox::deck
