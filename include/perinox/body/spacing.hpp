#pragma once
namespace perinox::body {

/// Edge of the cube (2-D: side of the square) with this volume (2-D: area).
double edge_of(double volume, int dimension);

}  // namespace perinox::body
