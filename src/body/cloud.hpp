#pragma once
#include <vector>

#include "perinox/body/particles.hpp"
#include "perinox/deck/deck.hpp"

namespace perinox::body {

/// Reads the particles of a point cloud (CSV: x,y,z,volume) in the order of its rows, with ids counted from `first_id`.
/// In 2-D z must be 0 and volume is area. Does not communicate: one rank reads. Throws InputError with the cloud's
/// line.
std::vector<Particle> read_cloud(const deck::Deck& deck, int part, GlobalId first_id);

}  // namespace perinox::body
