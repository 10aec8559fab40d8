#pragma once
/// Random scenes of point clouds.
#include "random_scenes.hpp"

namespace perinox::invariance {

/// Points near those of a lattice, with volumes that vary.
RandomScene jittered_cloud(Lot& lot, const std::string& folder);
/// A perfect lattice that is turned against the body, given as points.
RandomScene turned_cloud(Lot& lot, const std::string& folder);
/// A cloud bonded to a lattice.
RandomScene cloud_and_lattice(Lot& lot, const std::string& folder);

}  // namespace perinox::invariance
