#include "perinox/solve/bond_screen.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

// The widest vectors that the machine has are chosen when the program starts.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define PERINOX_WIDEST __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define PERINOX_WIDEST
#endif

namespace perinox::solve {

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
    auto may = change > offset.change;
    if (energies) {
      Lanes radials, shears;
      std::memcpy(&radials, at.radial + offset.to, sizeof(Lanes));
      std::memcpy(&shears, at.shear + offset.to, sizeof(Lanes));
      const Lanes extension = change * offset.inverse;
      const Lanes energy =
          offset.weight * extension * (offset.length * (radials + radial) + 0.5 * extension * (shears + shear));
      may = may | ((change > zero) & (energy > limits.energy));
    }
    const Flags flags = __builtin_convertvector(may, Flags);
    std::uint64_t word;
    std::memcpy(&word, &flags, sizeof word);
    std::uint8_t bits = 0;
    if (word)
      for (int k = 0; k < lanes; ++k) bits = static_cast<std::uint8_t>(bits | ((flags[k] ? 1 : 0) << k));
    found[o] = bits;
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
  const std::size_t stride = 2 * d + 2;
  if (lattice && values_.empty()) {
    for (const bonds::StencilOffset& offset : lattice->offsets())
      guard_ = std::max(guard_, std::abs(offset.step[0] + offset.step[1] * lattice->grid().row +
                                         offset.step[2] * lattice->grid().plane));
    cells_ = lattice->grid().size() + 2 * guard_ + lanes;
    values_.assign(static_cast<std::size_t>(cells_) * (d + 2), 0.0);
  } else if (values_.empty()) {
    values_.assign(static_cast<std::size_t>(scene_.pairs()->slots()) * stride, 0.0);
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
      double* to = values_.data() + stride * static_cast<std::size_t>(scene_.pairs()->slot()[i]);
      for (std::size_t c = 0; c < d; ++c) {
        to[c] = scene_.body().position(i)[c];
        to[d + c] = u[c];
      }
      to[2 * d] = radial;
      to[2 * d + 1] = shear;
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
  const auto d = static_cast<std::size_t>(dimension_), stride = 2 * d + 2;
  const double square = scene_.small_strain() ? 0.0 : 1.0;
  const int none = families.slots() - 1, owned = scene_.owned();
  for (int s = 0; s < owned; ++s) {
    const double* near = values_.data() + stride * static_cast<std::size_t>(s);
    for (std::int64_t k = families.begin()[s]; k < families.begin()[s + 1]; ++k) {
      const int slot = families.far()[k];
      if (slot == none) continue;
      const double* far = values_.data() + stride * static_cast<std::size_t>(slot);
      double change = 0;
      for (std::size_t c = 0; c < d; ++c) {
        const double relative = far[d + c] - near[d + c];
        change += (2 * (far[c] - near[c]) + square * relative) * relative;
      }
      if (!(change > 0)) continue;
      const double length = families.length()[k];
      const double weight = families.weight().empty() ? 1.0 : families.weight()[k];
      bool may = change > 2 * stretch_ * length * length;
      // Energies without a division: times 2 xi^2 for the first term, 4 xi^2 for the second.
      if (!may && energy_ < infinite)
        may =
            weight * change *
                (2 * length * length * (near[2 * d] + far[2 * d]) + 0.5 * change * (near[2 * d + 1] + far[2 * d + 1])) >
            4 * length * length * energy_;
      if (may) found_.push_back({families.particle()[s], families.particle()[slot], length, weight});
    }
  }
}

}  // namespace perinox::solve
