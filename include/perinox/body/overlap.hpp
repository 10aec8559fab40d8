#pragma once
/// Bodies whose shapes take up the same place, where material would count twice.
#include <vector>

#include "perinox/body/particles.hpp"
#include "perinox/deck/deck.hpp"

namespace perinox::body {

/// Two bodies that overlap.
struct Overlap {
  std::size_t earlier = 0, later = 0;  ///< indices into deck.body
  double volume = 0;                   ///< about: lines half a spacing apart; 2-D: area
  deck::Point at{};                    ///< a point in both
};

/// Overlaps of the shapes as the deck writes them, thicker than a thousandth of the spacing; of clouds by their
/// outlines. One rank's work, the same on every rank.
std::vector<Overlap> find_overlaps(const deck::Deck& deck);

/// Throws InputError at the later of two bodies that overlap, unless the deck says that the later one wins.
void refuse_overlaps(const deck::Deck& deck);

/// Takes the particles of a point cloud that lie inside the shape of a later body out, where later bodies win; where
/// overlaps are refused, throws InputError naming the first of them. part: index into deck.body. What lies within a
/// thousandth of its V^(1/d) of the other's surface is not inside.
void resolve_cloud_overlaps(const deck::Deck& deck, int part, std::vector<Particle>& particles);

}  // namespace perinox::body
