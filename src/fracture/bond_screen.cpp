#include "perinox/fracture/bond_screen.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "perinox/core/widest.hpp"

namespace perinox::fracture {

namespace {
/// What rounding may take from a bound is far less.
constexpr double slack = 1 - 1e-5;
constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr int lanes = 8;
using Lanes = double __attribute__((vector_size(sizeof(double) * lanes)));
using Flags = signed char __attribute__((vector_size(lanes)));

/// What is the same for all bonds of one offset.
struct Offset {
  double twice[3];  ///< 2 X
  std::int64_t to;
  double inverse;  ///< 1/(2 xi)
  double length;
  double weight;
  double change;  ///< least critical c of a stretch
};
/// Arrays from the first of eight cells on.
struct Cells {
  const double* u[3];
  const double* radial;  ///< bound of radial + N . H
  const double* shear;
};
struct Limits {
  double energy;
  double square;  ///< 1; 0: small strain, which leaves U . U out
};

/// Bit k: lane k is above zero.
inline __attribute__((always_inline)) std::uint8_t bits_of(const Lanes& beyond) {
  const auto may = beyond > Lanes{};
  const Flags flags = __builtin_convertvector(may, Flags);
  std::uint64_t word;
  std::memcpy(&word, &flags, sizeof word);
  unsigned bits = 0;
  if (word)
    for (int k = 0; k < lanes; ++k) bits |= (flags[k] ? 1u : 0u) << k;
  return static_cast<std::uint8_t>(bits);
}

/// Sets bit k of found[o] where the bond of cell k along offset o may be critical.
template <int d, bool energies>
inline __attribute__((always_inline)) void screen(const Cells& at, const Offset* offsets, std::size_t count,
                                                  const Limits& limits, std::uint8_t* found) {
  Lanes u[d], radial{}, shear{};
  for (int c = 0; c < d; ++c) std::memcpy(&u[c], at.u[c], sizeof(Lanes));
  if (energies) {
    std::memcpy(&radial, at.radial, sizeof(Lanes));
    std::memcpy(&shear, at.shear, sizeof(Lanes));
  }
  const Lanes zero{};
  for (std::size_t o = 0; o < count; ++o) {
    const Offset& offset = offsets[o];
    Lanes change{};
    for (int c = 0; c < d; ++c) {
      Lanes far;
      std::memcpy(&far, at.u[c] + offset.to, sizeof(Lanes));
      far -= u[c];
      change += far * (offset.twice[c] + limits.square * far);
    }
    // One comparison: GCC 12 takes the lanes apart to join the results of two.
    Lanes beyond = change - offset.change;
    if (energies) {
      Lanes radials, shears;
      std::memcpy(&radials, at.radial + offset.to, sizeof(Lanes));
      std::memcpy(&shears, at.shear + offset.to, sizeof(Lanes));
      const Lanes extension = (change > zero ? change : zero) * offset.inverse;
      const Lanes energy =
          offset.weight * extension * (offset.length * (radials + radial) + 0.5 * extension * (shears + shear));
      const Lanes above = energy - limits.energy;
      beyond = above > beyond ? above : beyond;
    }
    found[o] = bits_of(beyond);
  }
}

/// The pairs of one particle of a cloud, and a row of eight for each of them: X, U, bound of radial + N . H, shear.
struct Pairs {
  const double* rows;       ///< [slots * lanes]
  const std::int32_t* far;  ///< [count] slots
  const double* length;     ///< [count]
  const double* weight;     ///< [count]; null: 1
  std::int64_t count;       ///< a multiple of lanes
};

/// Rows of eight bonds to columns.
inline __attribute__((always_inline)) void transpose(Lanes* r) {
  Lanes even[4], odd[4];
  for (int k = 0; k < 4; ++k) {
    even[k] = __builtin_shufflevector(r[2 * k], r[2 * k + 1], 0, 8, 2, 10, 4, 12, 6, 14);
    odd[k] = __builtin_shufflevector(r[2 * k], r[2 * k + 1], 1, 9, 3, 11, 5, 13, 7, 15);
  }
  for (int k = 0; k < 2; ++k) {
    const Lanes* from = k ? odd : even;
    const Lanes low = __builtin_shufflevector(from[0], from[1], 0, 1, 8, 9, 4, 5, 12, 13);
    const Lanes high = __builtin_shufflevector(from[0], from[1], 2, 3, 10, 11, 6, 7, 14, 15);
    const Lanes low2 = __builtin_shufflevector(from[2], from[3], 0, 1, 8, 9, 4, 5, 12, 13);
    const Lanes high2 = __builtin_shufflevector(from[2], from[3], 2, 3, 10, 11, 6, 7, 14, 15);
    r[k] = __builtin_shufflevector(low, low2, 0, 1, 2, 3, 8, 9, 10, 11);
    r[k + 4] = __builtin_shufflevector(low, low2, 4, 5, 6, 7, 12, 13, 14, 15);
    r[k + 2] = __builtin_shufflevector(high, high2, 0, 1, 2, 3, 8, 9, 10, 11);
    r[k + 6] = __builtin_shufflevector(high, high2, 4, 5, 6, 7, 12, 13, 14, 15);
  }
}
}  // namespace

PERINOX_WIDEST void screen_plane(const Cells& at, const Offset* offsets, std::size_t count, const Limits& limits,
                                 std::uint8_t* found) {
  if (at.radial)
    screen<2, true>(at, offsets, count, limits, found);
  else
    screen<2, false>(at, offsets, count, limits, found);
}
PERINOX_WIDEST void screen_solid(const Cells& at, const Offset* offsets, std::size_t count, const Limits& limits,
                                 std::uint8_t* found) {
  if (at.radial)
    screen<3, true>(at, offsets, count, limits, found);
  else
    screen<3, false>(at, offsets, count, limits, found);
}

/// Sets bit k of found[g] where pair 8 g + k of the particle in slot `near` may be critical; whether one may.
PERINOX_WIDEST bool screen_pairs(int near, const Pairs& pairs, double stretch, const Limits& limits,
                                 std::uint8_t* found) {
  const double* own = pairs.rows + static_cast<std::ptrdiff_t>(lanes) * near;
  const Lanes zero{}, one = zero + 1.0;
  unsigned any = 0;
  for (std::int64_t k = 0; k < pairs.count; k += lanes) {
    Lanes r[lanes], length, weight = one;
    for (int lane = 0; lane < lanes; ++lane)
      std::memcpy(&r[lane], pairs.rows + static_cast<std::ptrdiff_t>(lanes) * pairs.far[k + lane], sizeof(Lanes));
    transpose(r);
    std::memcpy(&length, pairs.length + k, sizeof(Lanes));
    if (pairs.weight) std::memcpy(&weight, pairs.weight + k, sizeof(Lanes));
    Lanes change = zero;
    for (int c = 0; c < 3; ++c) {
      const Lanes relative = r[3 + c] - own[3 + c];
      change += (2.0 * (r[c] - own[c]) + limits.square * relative) * relative;
    }
    change = change > zero ? change : zero;
    const Lanes square = length * length;
    // Energies without a division: times 2 xi^2 for the first term, 4 xi^2 for the second.
    const Lanes energy = weight * change * (2.0 * square * (r[6] + own[6]) + 0.5 * change * (r[7] + own[7])) -
                         4.0 * limits.energy * square;
    Lanes beyond = change - 2.0 * stretch * square;
    beyond = energy > beyond ? energy : beyond;
    found[k / lanes] = bits_of(beyond);
    any |= found[k / lanes];
  }
  return any != 0;
}

BondScreen::BondScreen(const mechanics::Scene& scene, const std::vector<BondLimit>& limits)
    : scene_(scene), stretch_(infinite), energy_(infinite), dimension_(scene.dimension()) {
  for (const BondLimit& limit : limits) {
    if (limit.kind == BondLimit::Kind::stretch) stretch_ = std::min(stretch_, limit.limit * slack);
    if (limit.kind == BondLimit::Kind::energy) energy_ = std::min(energy_, limit.limit * slack);
    if (limit.kind == BondLimit::Kind::ductile) stretch_ = 0;
  }
}

const std::vector<BondScreen::Candidate>& BondScreen::find(const double* displacement, const double* points) {
  const auto d = static_cast<std::size_t>(dimension_);
  const auto n = static_cast<std::size_t>(bonds::mandel_size(dimension_));
  const bonds::LatticeFamilies* lattice = scene_.lattice();
  if (lattice && values_.empty()) {
    for (const bonds::StencilOffset& offset : lattice->offsets())
      guard_ = std::max(guard_, std::abs(offset.step[0] + offset.step[1] * lattice->grid().row +
                                         offset.step[2] * lattice->grid().plane));
    cells_ = lattice->grid().size() + 2 * guard_ + lanes;
    values_.assign(static_cast<std::size_t>(cells_) * (d + 2), 0.0);
  } else if (values_.empty()) {
    // What is not there compares with nothing.
    values_.assign(static_cast<std::size_t>(scene_.pairs()->slots()) * lanes, 0.0);
    std::fill(values_.end() - lanes, values_.end(), std::numeric_limits<double>::quiet_NaN());
  }
  for (LocalIndex i = 0; i < scene_.local(); ++i) {
    double radial = 0, shear = 0;
    if (points) {
      const double* point = points + (2 + n) * static_cast<std::size_t>(i);
      double square = 0;
      for (std::size_t k = 0; k < n; ++k) square += point[2 + k] * point[2 + k];
      radial = point[0] + (square > 0 ? std::sqrt(square) : 0);
      shear = std::max(point[1], 0.0);
    }
    const double* u = displacement + static_cast<std::size_t>(i) * d;
    if (lattice) {
      double* to = values_.data() + guard_ + lattice->grid().cell[i];
      for (std::size_t c = 0; c < d; ++c, to += cells_) *to = u[c];
      to[0] = radial;
      to[cells_] = shear;
    } else {
      double* to = values_.data() + static_cast<std::size_t>(scene_.pairs()->slot()[i]) * lanes;
      for (std::size_t c = 0; c < d; ++c) {
        to[c] = scene_.body().position(i)[c];
        to[3 + c] = u[c];
      }
      to[6] = radial;
      to[7] = shear;
    }
  }
  found_.clear();
  if (lattice)
    find_on_lattice();
  else
    find_in_pairs();
  return found_;
}

void BondScreen::find_on_lattice() {
  const bonds::LatticeFamilies& families = *scene_.lattice();
  const bonds::CellGrid& grid = families.grid();
  const Limits limits{energy_, scene_.small_strain() ? 0.0 : 1.0};
  std::vector<Offset> offsets;
  for (const bonds::StencilOffset& from : families.offsets()) {
    Offset offset{};
    for (std::size_t k = 0; k < 3; ++k) offset.twice[grid.axis[k]] = 2 * grid.spacing * from.step[k];
    offset.to = from.step[0] + from.step[1] * grid.row + from.step[2] * grid.plane;
    offset.inverse = 0.5 / from.length;
    offset.length = from.length;
    offset.weight = from.influence * from.share;
    offset.change = 2 * stretch_ * from.length * from.length;
    offsets.push_back(offset);
  }
  std::vector<std::uint8_t> found(offsets.size());
  const auto screen_all = dimension_ == 3 ? screen_solid : screen_plane;
  for (const bonds::LatticeFamilies::Block& block : families.blocks()) {
    Cells at{};
    const double* first = values_.data() + guard_ + block.cell;
    for (int c = 0; c < dimension_; ++c) at.u[c] = first + c * cells_;
    if (energy_ < infinite) {
      at.radial = first + dimension_ * cells_;
      at.shear = at.radial + cells_;
    }
    screen_all(at, offsets.data(), offsets.size(), limits, found.data());
    for (std::size_t o = 0; o < offsets.size(); ++o) {
      if (!found[o]) continue;
      const unsigned there = block.mask < 0 ? 0xFFu : families.masks()[static_cast<std::size_t>(block.mask) + o];
      for (int lane = 0; lane < lanes; ++lane)
        if ((there & found[o]) >> lane & 1u)
          found_.push_back({grid.particle[static_cast<std::size_t>(block.cell + lane)],
                            grid.particle[static_cast<std::size_t>(block.cell + lane + offsets[o].to)],
                            offsets[o].length, offsets[o].weight});
    }
  }
}

void BondScreen::find_in_pairs() {
  const bonds::PairFamilies& families = *scene_.pairs();
  const int none = families.slots() - 1, owned = scene_.owned();
  const double* weight = families.weight().empty() ? nullptr : families.weight().data();
  const Limits limits{energy_, scene_.small_strain() ? 0.0 : 1.0};
  std::vector<std::uint8_t> found;
  for (int s = 0; s < owned; ++s) {
    const std::int64_t begin = families.begin()[s];
    const Pairs pairs{values_.data(), families.far().data() + begin, families.length().data() + begin,
                      weight ? weight + begin : nullptr, families.begin()[s + 1] - begin};
    found.resize(static_cast<std::size_t>(pairs.count / lanes));
    if (!screen_pairs(s, pairs, stretch_, limits, found.data())) continue;
    for (std::int64_t k = 0; k < pairs.count; ++k)
      if ((found[static_cast<std::size_t>(k / lanes)] >> (k % lanes) & 1u) && pairs.far[k] != none)
        found_.push_back({families.particle()[s], families.particle()[pairs.far[k]], pairs.length[k],
                          pairs.weight ? pairs.weight[k] : 1.0});
  }
}

}  // namespace perinox::fracture
