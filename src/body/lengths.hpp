#pragma once
#include "perinox/deck/deck.hpp"

namespace perinox::body {

/// Refuses lengths that cannot belong together, before they show as an empty set or a particle without neighbours: a
/// spacing larger than its body, and a `reach` of the bonds shorter than a body's spacing. The message names `horizon`.
/// Every rank comes to the same answer. Throws InputError at the spacing or the horizon.
void refuse_unfit_lengths(const deck::Deck& deck, double horizon, double reach);

}  // namespace perinox::body
