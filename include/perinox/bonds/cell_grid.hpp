#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "perinox/body/body.hpp"

namespace perinox::bonds {

/// The cells of a lattice that this rank's particles lie on, at most one particle a cell. Rows run along x, unless
/// another axis fills groups of eight clearly better; positions and steps are along the grid's axes. A row's cells are
/// padded to a multiple of eight and nothing else is: the cell one step beyond a row's end is another row's, so whoever
/// steps through the cells must know which bonds there are.
struct CellGrid {
  int dimension = 3;
  double spacing = 0;
  std::array<int, 3> axis{0, 1, 2};            ///< axis of space along each axis of the grid; the first is the row's
  std::array<std::int64_t, 3> cells{1, 1, 1};  ///< of the box that holds the particles
  std::int64_t row = 0;                        ///< step from one row to the next
  std::int64_t plane = 0;                      ///< step from one plane to the next
  std::vector<std::int64_t> cell;              ///< [local] of each particle
  std::vector<LocalIndex> particle;            ///< [size()] of each cell; -1: none

  std::int64_t size() const { return static_cast<std::int64_t>(particle.size()); }
  std::array<std::int64_t, 3> position(std::int64_t c) const { return {c % row, c % plane / row, c / plane}; }
  /// The particle `step` cells away from position `at`; -1: none, or outside.
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

/// The grid, if all particles of this rank, ghosts too, lie on a lattice of the body's spacing (to 1e-11 of it, and the
/// rounding of the coordinates) and fill at least a sixteenth of its box. A body without a spacing has one if all its
/// volumes are V (to 1e-12): V^(1/d). Bodies some of which are clouds, or lattices of other spacings, have none. Only
/// how the bonds are stored depends on it, never what they are.
std::optional<CellGrid> find_grid(const body::Body& body);

}  // namespace perinox::bonds
