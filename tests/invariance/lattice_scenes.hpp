#pragma once
/// Random scenes of bodies that are generated as lattices.
#include "random_scenes.hpp"

namespace perinox::invariance {

/// A box of whole cells, perhaps with a crack.
RandomScene one_lattice(Lot& lot);
/// Boxes in a row that touch and are bonded, each with a spacing and a place of its own.
RandomScene several_lattices(Lot& lot);
/// Two boxes that are not bonded, near each other, under pressure. Each must be as if the other were not there.
RandomScene bodies_apart(Lot& lot);
/// A box whose faces cut cells. It must be the same as a union of two parts of it.
RandomScene box_that_cuts_cells(Lot& lot);

}  // namespace perinox::invariance
