#pragma once
/// Finds bodies whose shapes take up the same place, where material would count twice.
#include <vector>

#include "perinox/body/particles.hpp"
#include "perinox/deck/deck.hpp"

namespace perinox::body {

/// Two bodies that overlap.
struct Overlap {
  std::size_t earlier = 0, later = 0;  ///< indices into deck.body
  double volume = 0;                   ///< approximate, from lines half a spacing apart; 2-D: area
  deck::Point at{};                    ///< a point in both
};

/// Finds the overlaps of the shapes as the deck writes them that are thicker than a thousandth of the spacing. For a
/// cloud its outline is the shape. Each rank does the whole work and gets the same answer.
std::vector<Overlap> find_overlaps(const deck::Deck& deck);

/// Throws InputError at the later of two bodies that overlap, unless the deck says that the later one wins.
void refuse_overlaps(const deck::Deck& deck);

/// Removes the particles of a point cloud that lie inside the shape of a later body, if the deck says that later bodies
/// win. If overlaps are refused, it throws InputError that names the first of these particles. part: index into
/// deck.body. A particle within a thousandth of its V^(1/d) of the other's surface does not count as inside.
void resolve_cloud_overlaps(const deck::Deck& deck, int part, std::vector<Particle>& particles);

}  // namespace perinox::body
