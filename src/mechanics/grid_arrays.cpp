#include "grid_arrays.hpp"

#include <algorithm>

namespace perinox::mechanics {

namespace {
constexpr std::int64_t line = 8;      // doubles a cache line
constexpr std::int64_t page = 512;    // doubles a page
constexpr std::int64_t stagger = 24;  // doubles between the places of a page where consecutive arrays begin

std::int64_t room_of(std::int64_t guard) { return (guard + line) / line * line; }
std::int64_t length_of(std::int64_t cells, std::int64_t guard) {
  return (cells + 2 * room_of(guard) + page - 1) / page * page + stagger;
}
}  // namespace

std::size_t GridArrays::bytes_of(int count, std::int64_t cells, std::int64_t guard) {
  return static_cast<std::size_t>(count * length_of(cells, guard) + 2 * page) * sizeof(double);
}

void GridArrays::allocate(int count, std::int64_t cells, std::int64_t guard, int number) {
  cells_ = cells;
  const std::int64_t room = room_of(guard), length = length_of(cells, guard);
  memory_.assign(static_cast<std::size_t>(count * length + 2 * page), 0.0);
  auto* first = memory_.data();
  while (reinterpret_cast<std::uintptr_t>(first) % (page * sizeof(double)) != 0) ++first;
  first += number * stagger % page;  // two pages are room for this and for the alignment
  start_.clear();
  for (int k = 0; k < count; ++k) start_.push_back(first + k * length + room);
}

void GridArrays::clear(int k) { std::fill_n(start_[k], cells_, 0.0); }

}  // namespace perinox::mechanics
