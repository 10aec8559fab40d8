#pragma once
#include <cstdint>
#include <vector>

#include "perinox/bonds/bonds.hpp"
#include "perinox/bonds/cell_grid.hpp"

namespace perinox::bonds {

/// One offset of the half stencil. It stands for the bond to the cell `step` further on and for the reverse bond.
struct StencilOffset {
  std::array<int, 3> step{};  ///< cells along the grid's axes
  double length = 0;          ///< xi
  double share = 0;           ///< the quadrature's share of the far volume
  double influence = 0;       ///< omega(xi)
};

/// The families of a lattice body, stored without a word a bond. All particles share one stencil. Every eight
/// neighbouring cells of a row that do not have all of its bonds keep one bit a bond. Bonds between two ghosts are left
/// out.
class LatticeFamilies {
 public:
  /// Eight neighbouring cells of a row that have at least one bond of the half stencil.
  struct Block {
    std::int64_t cell = 0;   ///< first of the eight cells
    std::int64_t mask = -1;  ///< index of the first of its offsets().size() masks; -1: every bond is there
  };

  LatticeFamilies(const body::Body& body, CellGrid grid);
  /// Takes the family of one owned particle. It is to be called for every one of them; then complete().
  void receive(LocalIndex i, const std::vector<FoundBond>& family, const body::Body& body);
  void complete();

  const CellGrid& grid() const { return grid_; }
  double volume() const { return volume_; }  ///< of a whole cell
  const std::vector<StencilOffset>& offsets() const { return offsets_; }
  /// The blocks. Those whose bonds join owned particles only come first: [0, interior()).
  const std::vector<Block>& blocks() const { return blocks_; }
  std::size_t interior() const { return interior_; }
  /// [masks] one bit for each cell of a block and offset: 1 where the bond is there.
  const std::vector<std::uint8_t>& masks() const { return masks_; }
  std::size_t bytes() const;

  /// Removes the bond between two particles for good. Returns its offset, or null if there is no such bond.
  const StencilOffset* remove(LocalIndex i, LocalIndex j);
  /// Calls visit(near end, far end, offset) once for every bond.
  template <class Visit>
  void each(const Visit& visit) const;

  /// One end of a bond, as the sweeps over the lattice see it.
  struct Place {
    LocalIndex neighbor;
    std::size_t block;  ///< index into blocks()
    int lane;           ///< cell within the block that keeps the bond
    int offset;         ///< index into offsets()
    bool far;           ///< true: the particle is the far end, the bond is the reverse of the offset
  };
  /// Finds all bonds of particle i, in no particular order. Replaces what is in `places`.
  void places(LocalIndex i, std::vector<Place>& places) const;
  /// One end of an offset's bonds, as seen from a particle at that end.
  struct End {
    std::int64_t to_neighbor = 0;  ///< step in cells from the particle to its neighbour
    std::int64_t to_near = 0;      ///< step in cells from the particle to the cell that keeps the bond
    int offset = 0;
    bool far = false;
  };
  End end(int offset, bool far) const;
  /// Calls visit(place) for the bonds of particle i in the order of `ends`.
  template <class Visit>
  void each_of(LocalIndex i, const std::vector<End>& ends, const Visit& visit) const {
    for (const End& end : ends) visit_end(grid_.cell[i], end, visit);
  }
  /// Finds particle i's end of its bond to j; the neighbor of the result is -1 if there is none.
  Place find(LocalIndex i, LocalIndex j) const;

 private:
  static constexpr int lanes = 8;
  int number_of(const std::array<int, 3>& step);
  /// Calls visit(place) if the particle of cell `own` has this end of a bond.
  template <class Visit>
  void visit_end(std::int64_t own, const End& end, const Visit& visit) const;
  bool bond(std::int64_t cell, int offset) const {
    const int b = block_of_[cell / lanes];
    if (b < 0) return false;
    const Block& block = blocks_[b];
    return block.mask < 0 || (masks_[block.mask + offset] >> (cell % lanes) & 1) != 0;
  }

  CellGrid grid_;
  double volume_ = 0;
  int owned_ = 0;
  std::vector<StencilOffset> offsets_;
  std::vector<Block> blocks_;
  std::vector<std::uint8_t> masks_;
  std::vector<int> block_of_;  ///< [grid size/8] index into blocks_; -1: no bonds
  std::size_t interior_ = 0;

  // The following are used while the families come in.
  std::vector<std::vector<std::uint8_t>> bits_;  ///< [offset][grid size/8]
  std::vector<std::uint8_t> touches_ghost_;      ///< [grid size/8]
  int reach_ = 0;
  std::vector<int> numbers_;  ///< [(2 reach + 1)^3] number of an offset, -1 not met yet
};

template <class Visit>
void LatticeFamilies::each(const Visit& visit) const {
  for (const Block& block : blocks_)
    for (std::size_t o = 0; o < offsets_.size(); ++o) {
      const std::array<int, 3>& step = offsets_[o].step;
      const std::int64_t to = step[0] + step[1] * grid_.row + step[2] * grid_.plane;
      const unsigned bits = block.mask < 0 ? 0xFFu : masks_[static_cast<std::size_t>(block.mask) + o];
      for (int lane = 0; lane < lanes; ++lane)
        if (bits >> lane & 1u)
          visit(grid_.particle[static_cast<std::size_t>(block.cell + lane)],
                grid_.particle[static_cast<std::size_t>(block.cell + lane + to)], offsets_[o]);
    }
}

template <class Visit>
void LatticeFamilies::visit_end(std::int64_t own, const End& end, const Visit& visit) const {
  // A step may leave the row. But a cell that has the bond has it to this particle and to no other.
  const std::int64_t cell = own + end.to_near;
  if (cell < 0 || !bond(cell, end.offset)) return;
  visit(Place{grid_.particle[own + end.to_neighbor], static_cast<std::size_t>(block_of_[cell / lanes]),
              static_cast<int>(cell % lanes), end.offset, end.far});
}

}  // namespace perinox::bonds
