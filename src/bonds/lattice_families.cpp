#include "perinox/bonds/lattice_families.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace perinox::bonds {

namespace {
bool forward(const std::array<int, 3>& step) { return std::tie(step[2], step[1], step[0]) > std::make_tuple(0, 0, 0); }
// Rows and planes are worked on in tiles of this size, so that what they share stays in the second-level cache.
constexpr std::int64_t tile = 8;
}  // namespace

LatticeFamilies::LatticeFamilies(const body::Body& body, CellGrid grid) : grid_(std::move(grid)), owned_(body.owned) {
  const double h = grid_.spacing;
  volume_ = body.spacing == 0 ? body.volume[0] : body.dimension == 3 ? h * h * h : h * h;
  reach_ = static_cast<int>(body.reach / grid_.spacing * (1 + 1e-10));
  const auto groups = static_cast<std::size_t>(grid_.size() / lanes);
  touches_ghost_.assign(groups, 0);
  block_of_.assign(groups, -1);
}

int LatticeFamilies::number_of(const std::array<int, 3>& step) {
  const int largest = std::max({std::abs(step[0]), std::abs(step[1]), std::abs(step[2])});
  if (largest > reach_ || numbers_.empty()) {  // a body made by hand has no reach on record
    reach_ = std::max(reach_, largest);
    const int width = 2 * reach_ + 1;
    numbers_.assign(static_cast<std::size_t>(width * width * width), -1);
    for (std::size_t o = 0; o < offsets_.size(); ++o) {
      const auto& s = offsets_[o].step;
      numbers_[((s[2] + reach_) * width + s[1] + reach_) * width + s[0] + reach_] = static_cast<int>(o);
    }
  }
  const int width = 2 * reach_ + 1;
  int& number = numbers_[((step[2] + reach_) * width + step[1] + reach_) * width + step[0] + reach_];
  if (number < 0) {
    number = static_cast<int>(offsets_.size());
    offsets_.push_back({step, 0, 0, 0});
    bits_.emplace_back(static_cast<std::size_t>(grid_.size() / lanes), std::uint8_t{0});
  }
  return number;
}

void LatticeFamilies::receive(LocalIndex i, const std::vector<FoundBond>& family, const body::Body& body) {
  const std::int64_t own = grid_.cell[i];
  const auto at = grid_.position(own);
  for (const FoundBond& found : family) {
    const std::int64_t other = grid_.cell[found.neighbor];
    const auto to = grid_.position(other);
    std::array<int, 3> step{};
    for (int c = 0; c < 3; ++c) step[c] = static_cast<int>(to[c] - at[c]);
    const bool near = forward(step);
    if (!near)
      for (int& s : step) s = -s;
    const std::int64_t cell = near ? own : other;
    const int number = number_of(step);
    StencilOffset& offset = offsets_[number];
    offset.length = found.length;
    offset.share = found.weight / body.volume[found.neighbor];
    offset.influence = found.influence;
    bits_[number][cell / lanes] |= static_cast<std::uint8_t>(1u << (cell % lanes));
    if (found.neighbor >= owned_) touches_ghost_[cell / lanes] = 1;
  }
}

void LatticeFamilies::complete() {
  // The step along the row varies slowest in the order of the offsets, so that what one offset adds to a cell is read
  // again only many offsets later, when the store has left the pipeline.
  std::vector<std::size_t> order(offsets_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return offsets_[a].step < offsets_[b].step; });
  std::vector<StencilOffset> sorted;
  for (const std::size_t o : order) sorted.push_back(offsets_[o]);
  for (StencilOffset& offset : sorted) {  // the same on every rank and for every body: not as the coordinates round
    double square = 0;
    for (const int s : offset.step) square += s * s;
    offset.length = grid_.spacing * std::sqrt(square);
  }
  offsets_ = std::move(sorted);

  const auto groups = static_cast<std::size_t>(grid_.size() / lanes);
  for (std::size_t g = 0; g < groups; ++g) {
    bool any = false, all = true;
    for (const std::size_t o : order) {
      any = any || bits_[o][g] != 0;
      all = all && bits_[o][g] == 0xFF;
    }
    if (!any) continue;
    Block block{static_cast<std::int64_t>(g) * lanes, -1};
    if (!all) {
      block.mask = static_cast<std::int64_t>(masks_.size());
      for (const std::size_t o : order) masks_.push_back(bits_[o][g]);
    }
    blocks_.push_back(block);
  }
  const auto key = [&](const Block& block) {
    const auto at = grid_.position(block.cell);
    return std::make_tuple(touches_ghost_[block.cell / lanes], at[2] / tile, at[1] / tile, at[2], at[1], at[0]);
  };
  std::sort(blocks_.begin(), blocks_.end(), [&](const Block& a, const Block& b) { return key(a) < key(b); });
  interior_ = 0;
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    block_of_[blocks_[b].cell / lanes] = static_cast<int>(b);
    if (!touches_ghost_[blocks_[b].cell / lanes]) interior_ = b + 1;
  }
  bits_ = {};
  touches_ghost_ = {};
  numbers_ = {};
}

LatticeFamilies::Place LatticeFamilies::find(LocalIndex i, LocalIndex j) const {
  const auto from = grid_.position(grid_.cell[i]), to = grid_.position(grid_.cell[j]);
  std::array<int, 3> step{};
  for (int c = 0; c < 3; ++c) step[c] = static_cast<int>(to[c] - from[c]);
  const bool far = !forward(step);
  const std::int64_t cell = grid_.cell[far ? j : i];
  if (far)
    for (int& s : step) s = -s;
  const auto found =
      std::find_if(offsets_.begin(), offsets_.end(), [&](const StencilOffset& offset) { return offset.step == step; });
  const auto o = static_cast<int>(found - offsets_.begin());
  if (found == offsets_.end() || !bond(cell, o)) return {-1, 0, 0, 0, false};
  return {j, static_cast<std::size_t>(block_of_[cell / lanes]), static_cast<int>(cell % lanes), o, far};
}

const StencilOffset* LatticeFamilies::remove(LocalIndex i, LocalIndex j) {
  const Place place = find(i, j);
  if (place.neighbor < 0) return nullptr;
  Block& block = blocks_[place.block];
  if (block.mask < 0) {
    block.mask = static_cast<std::int64_t>(masks_.size());
    masks_.resize(masks_.size() + offsets_.size(), 0xFF);
  }
  masks_[static_cast<std::size_t>(block.mask + place.offset)] &= static_cast<std::uint8_t>(~(1u << place.lane));
  return &offsets_[static_cast<std::size_t>(place.offset)];
}

void LatticeFamilies::places(LocalIndex i, std::vector<Place>& places) const {
  places.clear();
  for (int o = 0; o < static_cast<int>(offsets_.size()); ++o)
    for (const bool far : {false, true})
      visit_end(grid_.cell[i], end(o, far), [&](const Place& place) { places.push_back(place); });
}

LatticeFamilies::End LatticeFamilies::end(int offset, bool far) const {
  const std::array<int, 3>& step = offsets_[static_cast<std::size_t>(offset)].step;
  const std::int64_t ahead = step[0] + step[1] * grid_.row + step[2] * grid_.plane;
  return {far ? -ahead : ahead, far ? -ahead : 0, offset, far};
}

std::size_t LatticeFamilies::bytes() const {
  return grid_.cell.size() * sizeof(std::int64_t) + grid_.particle.size() * sizeof(LocalIndex) +
         blocks_.size() * sizeof(Block) + masks_.size() + block_of_.size() * sizeof(int);
}

}  // namespace perinox::bonds
