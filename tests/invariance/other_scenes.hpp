#pragma once
/// Random scenes of bodies that are not one box.
#include "random_scenes.hpp"

namespace perinox::invariance {

/// A disc, ball, cylinder or ring under pressure from all sides. It must be the same as facing a direction and its
/// opposite.
RandomScene curved_body(Lot& lot);
/// A box with a slit that is cut out and a crack that runs into it. How far it runs within the slit must not matter.
RandomScene slit_body(Lot& lot);
/// A box in one piece. It must be the same as two bodies of one material and lattice.
RandomScene split_body(Lot& lot);

}  // namespace perinox::invariance
