#pragma once
/// The part of a solid that is in one cell, divided into the pieces that no straight way joins there.
#include <optional>
#include <vector>

#include "cut_cells.hpp"

namespace perinox::body {

struct CellPiece {
  std::optional<Solid> solid{};        ///< none: all that is in the cell
  std::vector<deck::Point> samples{};  ///< points spread over the piece, where they were needed
};

/// False if the cell surely holds one piece at most.
bool may_be_divided(const Solid& solid, const CellBox& box);

/// Divides what is in a cell into pieces. The two lips of a slit that runs through a cell are two pieces, unless the
/// slit is narrower than `bridged`, a length. Pieces are told apart by points on straight lines through the cell and
/// cut out along a surface of the solid between them. What no surface divides stays one piece.
std::vector<CellPiece> pieces_in(const Solid& solid, const CellBox& box, double bridged);

/// Points spread over what is in the cell. There are none where that is next to nothing.
std::vector<deck::Point> samples_in(const Solid& solid, const CellBox& box);

/// True if a straight line from one of the samples to the point leaves the solid by no more than `bridged`, a length.
bool joined(const std::vector<deck::Point>& samples, const Solid& solid, const deck::Point& point, double bridged);

}  // namespace perinox::body
