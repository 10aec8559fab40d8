#pragma once
/// What of a solid is in one cell, in the pieces that no straight way joins there.
#include <optional>
#include <vector>

#include "cut_cells.hpp"

namespace perinox::body {

struct CellPiece {
  std::optional<Solid> solid{};        ///< none: all that is in the cell
  std::vector<deck::Point> samples{};  ///< points of the piece, spread over it, where they were needed
};

/// False where a cell is sure to hold one piece at most.
bool may_be_divided(const Solid& solid, const CellBox& box);

/// The two lips of a slit that runs through a cell are two pieces, unless the slit is narrower than `bridged`, a
/// length. Pieces are told apart by points on straight lines through the cell and cut out along a surface of the solid
/// between them; what no surface divides stays one piece.
std::vector<CellPiece> pieces_in(const Solid& solid, const CellBox& box, double bridged);

/// Points of what is in the cell, spread over it; none where that is next to nothing.
std::vector<deck::Point> samples_in(const Solid& solid, const CellBox& box);

/// True where a straight line from one of the samples to the point leaves the solid by no more than `bridged`.
bool joined(const std::vector<deck::Point>& samples, const Solid& solid, const deck::Point& point, double bridged);

}  // namespace perinox::body
