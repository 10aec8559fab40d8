#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "perinox/body/body.hpp"

namespace perinox::bonds {

/// The cells of a lattice on which this rank's particles lie, at most one particle a cell. Rows run along x, unless
/// another axis fills groups of eight cells clearly better. Positions and steps are along the grid's axes. A row's
/// cells are padded to a multiple of eight, and nothing else is padded: the cell one step beyond a row's end belongs to
/// another row. Code that steps through the cells must therefore know which bonds there are.
struct CellGrid {
  int dimension = 3;
  double spacing = 0;
  /// Axis of space that lies along each axis of the grid; the first is the row's.
  std::array<int, 3> axis{0, 1, 2};
  /// Number of cells along each axis of the grid, of the box that holds the particles.
  std::array<std::int64_t, 3> cells{1, 1, 1};
  std::int64_t row = 0;              ///< step from one row to the next
  std::int64_t plane = 0;            ///< step from one plane to the next
  std::vector<std::int64_t> cell;    ///< [local] cell of each particle
  std::vector<LocalIndex> particle;  ///< [size()] particle in each cell; -1: none

  std::int64_t size() const { return static_cast<std::int64_t>(particle.size()); }
  std::array<std::int64_t, 3> position(std::int64_t c) const { return {c % row, c % plane / row, c / plane}; }
  /// The particle `step` cells away from position `at`; -1 if there is none or if that is outside the grid.
  LocalIndex neighbor(const std::array<std::int64_t, 3>& at, const std::array<int, 3>& step) const {
    std::int64_t c = 0;
    const std::int64_t strides[3] = {1, row, plane};
    for (int k = 0; k < 3; ++k) {
      const std::int64_t to = at[k] + step[k];
      if (to < 0 || to >= cells[k]) return -1;
      c += to * strides[k];
    }
    return particle[c];
  }
};

/// Finds the grid of a body. It exists if all particles of this rank, ghosts included, lie on a lattice of the body's
/// spacing (to 1e-11 of it and the rounding of the coordinates) and fill at least a sixteenth of its box (4096 cells
/// more are allowed, for small bodies). A body without a spacing has one if all its volumes are the same V (to 1e-12);
/// the spacing is then V^(1/d). Where some bodies are clouds and others lattices, or lattices differ in spacing, there
/// is no grid. Only the storage of the bonds depends on the grid, never which bonds there are. Not collective.
std::optional<CellGrid> find_grid(const body::Body& body);

}  // namespace perinox::bonds
