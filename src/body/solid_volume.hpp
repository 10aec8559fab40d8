#pragma once
#include "arrangement.hpp"

namespace perinox::body {

/// Share of a box (2-D: a rectangle at z = 0) that is inside of a solid, 0 to 1. Lines through the box are cut exactly.
/// Their lengths are summed by quadratures that are split where the lengths change form. Shapes with plane faces are
/// exact to rounding, curved ones to about 1e-8.
double share_inside(const Solid& solid, const CellBox& cell);

}  // namespace perinox::body
